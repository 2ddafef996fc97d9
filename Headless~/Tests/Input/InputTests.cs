using System;
using System.IO;
using NUnit.Framework;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.LowLevel;
using UnityEngine.TestTools;

namespace AnatomyCarve.Headless.Tests.Input
{
    /// <summary>One host for the tests of this folder, with a folder of assets of theirs.</summary>
    [SetUpFixture]
    public sealed class InputSetUp
    {
        internal static UnityHost Host { get; private set; }

        internal static string Assets { get; private set; }

        [OneTimeSetUp]
        public void StartHost()
        {
            Assets = Directory.CreateDirectory(Path.Combine(TestContext.CurrentContext.WorkDirectory, "input-" + Guid.NewGuid().ToString("N"))).FullName;
            ImportTests.WriteAssets(Assets);
            Host = UnityHost.Start(new HostOptions { Log = (_, _, _) => { }, ExtraRoots = [Assets] });
        }

        [OneTimeTearDown]
        public void EndHost()
        {
            Host.Dispose();
            Directory.Delete(Assets, true);
            HostEnds.Note("Tests/Input", Host.Report.IsClean, Host.Report);
        }
    }

    /// <summary>The ground of the tests here: no device and no enabled action but the test's own.</summary>
    public abstract class InputTests
    {
        [TearDown]
        public void RemoveAll()
        {
            InputSystem.DisableAllEnabledActions();
            foreach (InputDevice device in InputSystem.devices.ToArray())
                InputSystem.RemoveDevice(device);
        }

        private protected static void Frame() => InputSetUp.Host.Step();

        /// <summary>The state comes in with a frame.</summary>
        private protected static void Send<T>(InputDevice device, T state) where T : struct, IInputStateTypeInfo
        {
            InputSystem.QueueStateEvent(device, state);
            Frame();
        }

        private protected static void Press(Keyboard keyboard, params Key[] keys) => Send(keyboard, new KeyboardState(keys));
    }
}
