using System;
using NUnit.Framework;
using Unity.Collections;

namespace AnatomyCarve.Headless.Tests.Objects
{
    public sealed class NativeArrayTests
    {
        [Test]
        public void New_IsCleared()
        {
            using var a = new NativeArray<int>(3, Allocator.Persistent);
            Assert.That(a.ToArray(), Is.EqualTo(new int[3]));
        }

        [Test]
        public void New_Uninitialised_IsNotCleared()
        {
            using var a = new NativeArray<byte>(3, Allocator.Temp, NativeArrayOptions.UninitializedMemory);
            Assert.That(a[0], Is.EqualTo(0xCD));
        }

        [Test]
        public void Copy_OfTheStruct_SharesTheMemory()
        {
            using var a = new NativeArray<int>(3, Allocator.Temp);
            var b = a;
            b[1] = 5;
            Assert.That(a[1], Is.EqualTo(5));
        }

        [Test]
        public void Access_AfterDisposeOfACopy_Throws()
        {
            var a = new NativeArray<int>(3, Allocator.Temp);
            var b = a;
            b.Dispose();
            Assert.That(() => a[0], Throws.TypeOf<ObjectDisposedException>());
        }

        [Test]
        public void Index_OutOfRange_Throws()
        {
            using var a = new NativeArray<int>(3, Allocator.Temp);
            var copy = a;
            Assert.That(() => copy[3], Throws.TypeOf<IndexOutOfRangeException>());
        }

        [Test]
        public void Reinterpret_SeesTheSameBytes()
        {
            using var a = new NativeArray<int>(new[] { 0x01020304 }, Allocator.Temp);
            Assert.That(a.Reinterpret<byte>(4).ToArray(), Is.EqualTo(new byte[] { 4, 3, 2, 1 }));
        }

        [Test]
        public void Reinterpret_ThatDoesNotFit_Throws()
        {
            using var a = new NativeArray<byte>(6, Allocator.Temp);
            var copy = a;
            Assert.That(() => copy.Reinterpret<int>(1), Throws.InvalidOperationException);
        }

        [Test]
        public void SubArray_SharesTheMemory()
        {
            using var a = new NativeArray<int>(new[] { 1, 2, 3 }, Allocator.Temp);
            Assert.That(a.GetSubArray(1, 2).ToArray(), Is.EqualTo(new[] { 2, 3 }));
        }

        [Test]
        public void Enumeration_YieldsAllElements()
        {
            using var a = new NativeArray<int>(new[] { 1, 2, 3 }, Allocator.Temp);
            var sum = 0;
            foreach (var v in a)
                sum += v;
            Assert.That(sum, Is.EqualTo(6));
        }

        [Test]
        public void PersistentArray_NotDisposed_CountsAsLeak()
        {
            var before = NativeMemory.LeakCount;
            var a = new NativeArray<int>(1, Allocator.Persistent);
            var during = NativeMemory.LeakCount;
            a.Dispose();
            Assert.That((during - before, NativeMemory.LeakCount - before), Is.EqualTo((1, 0)));
        }

        [Test]
        public void CopyTo_AnotherLength_Throws()
        {
            using var a = new NativeArray<int>(3, Allocator.Temp);
            var copy = a;
            Assert.That(() => copy.CopyTo(new int[2]), Throws.ArgumentException);
        }
    }
}
