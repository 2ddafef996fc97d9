using System;
using AnatomyCarve.Picking;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Experimental.Rendering;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>What hides a volume: a wall in the left half of the picture, or all over it.</summary>
    sealed class SceneDepthTests : PlayModeScene
    {
        const int Size = 32;
        const float Near = 10f, Far = 1000f;

        CarvedVolumeRenderer renderer;
        PictureRays rays;
        CarvedPicture picture;
        Texture2D wall;

        [SetUp]
        public void MakeWall()
        {
            renderer = MakeVolume(Phantoms.Markers());
            rays = FrontView(renderer.Volume, Size);
            picture = new CarvedPicture("Hidden picture");
            wall = new Texture2D(Size, Size, GraphicsFormat.R32_SFloat, TextureCreationFlags.None) { name = "Wall" };
        }

        [TearDown]
        public void RemoveWall()
        {
            picture.Dispose();
            Object.DestroyImmediate(wall);
        }

        [Test]
        public void SceneDepth_InFrontOfTheVolume_HidesIt()
        {
            Build(x => x < Size / 2 ? Near : Far);
            picture.SceneDepth = wall;
            PictureData data = renderer.Render(rays, picture).Read();
            Assert.That(Count(data, Phantoms.Right), Is.Zero, "the left half of the picture is hidden");
            Assert.That(Count(data, Phantoms.Left), Is.GreaterThan(0));
        }

        [Test]
        public void SceneDepth_WrittenAnew_IsSeen()
        {
            Build(x => Near);
            picture.SceneDepth = wall;
            Assert.That(Count(renderer.Render(rays, picture).Read(), Phantoms.Left), Is.Zero);
            Build(x => Far);
            Assert.That(Count(renderer.Render(rays, picture).Read(), Phantoms.Left), Is.GreaterThan(0));
        }

        [Test]
        public void SceneDepth_TakenAway_ShowsTheVolumeAgain()
        {
            PictureData whole = renderer.Render(rays, picture).Read();
            Build(x => Near);
            picture.SceneDepth = wall;
            renderer.Render(rays, picture);
            picture.SceneDepth = null;
            AssertSamePicture(whole, renderer.Render(rays, picture).Read());
        }

        [Test]
        public void SceneDepth_Destroyed_ShowsTheVolumeAgain()
        {
            PictureData whole = renderer.Render(rays, picture).Read();
            Build(x => Near);
            picture.SceneDepth = wall;
            renderer.Render(rays, picture);
            Object.DestroyImmediate(wall);
            AssertSamePicture(whole, renderer.Render(rays, picture).Read());
        }

        [Test]
        public void SceneDepth_OfAnotherSize_IsRefusedWithBothSizes()
        {
            picture.SceneDepth = wall;
            Assert.That(() => renderer.Render(FrontView(renderer.Volume, 2 * Size), picture),
                Throws.ArgumentException.With.Message.Contain("'Wall'").And.Message.Contain("32 x 32").And.Message.Contain("64 x 64"));
        }

        void Build(Func<int, float> depthAtColumn)
        {
            var depths = new float[Size * Size];
            for (int p = 0; p < depths.Length; p++)
                depths[p] = depthAtColumn(p % Size);
            wall.SetPixelData(depths, 0);
            wall.Apply(false, false);
        }
    }
}
