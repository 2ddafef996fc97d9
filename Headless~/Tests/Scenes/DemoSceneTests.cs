using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using AnatomyCarve.Desktop;
using AnatomyCarve.Headless.Tests.Layout;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.LowLevel;
using UnityEngine.UI;

namespace AnatomyCarve.Headless.Tests.Scenes
{
    /// <summary>The sample's scene as a user plays it: import the sample, press Play, look around, point, carve, undo.</summary>
    public sealed class DemoSceneTests
    {
        const int Width = 96, Height = 54;
        const int PatienceFrames = 20_000;

        static readonly string Scene = Path.Combine(PackageTree.OfRepository().Root, "Samples~/DemoHead/DemoHead.unity");

        readonly List<string> complaints = [];
        UnityHost host;
        HostInput desk;

        [SetUp]
        public void Play() => Play(new HostOptions());

        [TearDown]
        public void Stop()
        {
            End();
            Assert.That(host.Report.LeakCount, Is.Zero, host.Report.ToString());
            Assert.That(complaints, Is.Empty);
        }

        [Test]
        public void Head_IsLoadedAndCarved_AndTheCameraShowsIt()
        {
            CarvedVolumeRenderer head = Head();
            Assert.That((head.Volume.Segments.Count, head.Stack.Carving.Spheres.Count), Is.EqualTo((119, 4)));
            Assert.That(complaints, Is.Empty);
            PictureData picture = head.Render(Camera(), Width, Height).Read();
            string[] seen = picture.Segments.Where(s => s != PictureData.NoSegment).Distinct().Select(s => head.Volume.Segments[s].Name).ToArray();
            Assert.That(seen, Has.Some.EqualTo("Hippocampus_L").And.Some.EqualTo("head").And.Some.EqualTo("Putamen_L").Or.Some.EqualTo("Insula_L"));
            AssertShows(host.ReadScreen(), picture);
        }

        [Test]
        public void Head_IsShownToBothEyesInTheUniversalPipeline()
        {
            End();
            Play(new HostOptions { RenderPipeline = HostPipeline.Universal, Stereo = HostStereo.SinglePassInstanced });
            for (int eye = 0; eye < 2; eye++)
                Assert.That(Drawn(host.ReadEye(eye)), Is.GreaterThan(0.02), "eye " + eye);
        }

        [Test]
        public void Loading_IsTold_AndThenNot()
        {
            Assert.That(Text("Loading"), Is.Empty);
            host.LoadScene(Scene);
            var told = new HashSet<string>();
            host.RunUntil(
                () =>
                {
                    told.Add(Text("Loading"));
                    return Head().Volume != null;
                },
                PatienceFrames);
            host.Step();
            Assert.That(told, Has.Some.StartsWith("Loading the volume"));
            Assert.That(Text("Loading"), Is.Empty);
        }

        [Test]
        public void Mouse_OverTheHead_NamesItsSegment_AndClickingMarksIt()
        {
            desk.MoveTo(Width / 2f, Height / 2f);
            Steps(2);
            string name = Text("Segment");
            Segment pointed = Find<MousePointer>().Segment;
            Assert.That(name, Is.EqualTo(MousePointer.ClippedSign + " " + pointed.Name), "the next sphere clips it");
            Head().Stack.SetActive(new Vector3(1f, 1f, 1f), 0.01f);
            Steps(2);
            bool clipped = Find<MousePointer>().WillBeClipped;
            desk.Press(MouseButton.Left);
            Steps(2);
            desk.Release(MouseButton.Left);
            Steps(2);
            Assert.That(Find<MousePointer>().WillBeClipped, Is.Not.EqualTo(clipped));
            Assert.That(Text("Segment"), Is.EqualTo((clipped ? "+ " : "\u00D7 ") + pointed.Name));
            desk.MoveTo(1, 1);
            Steps(2);
            Assert.That(Text("Segment"), Is.Empty);
        }

        [Test]
        public void Shift_Drag_Carves_EnterFixes_BackspaceRemoves_UndoBringsBack()
        {
            int spheres = Head().Stack.Carving.Fixed.Count;
            byte[] before = host.ReadScreen();
            desk.MoveTo(Width / 2f, Height / 2f);
            Steps(2);
            desk.Press(Key.LeftShift);
            Steps(2);
            desk.MoveTo(Width / 2f + 8, Height / 2f + 4);
            Steps(3);
            desk.Release(Key.LeftShift);
            Steps(2);
            Assert.That(Head().Stack.Carving.Active, Is.Not.Null);
            Assert.That(Different(before, host.ReadScreen()), Is.GreaterThan(20), "something was cut away");
            Type(Key.Enter);
            Assert.That(Head().Stack.Carving.Fixed, Has.Count.EqualTo(spheres + 1));
            Type(Key.Backspace);
            Assert.That(Head().Stack.Carving.Fixed, Has.Count.EqualTo(spheres));
            desk.Press(Key.LeftCtrl);
            Type(Key.Z);
            desk.Release(Key.LeftCtrl);
            Assert.That(Head().Stack.Carving.Fixed, Has.Count.EqualTo(spheres + 1), "undone: the removed sphere is back");
        }

        [Test]
        public void RightDrag_TurnsTheView_WheelComesNearer_HomeGoesBack()
        {
            Vector3 home = Camera().transform.position;
            desk.MoveTo(Width / 2f, Height / 2f);
            Steps(1);
            desk.Press(MouseButton.Right);
            Steps(1);
            desk.MoveTo(Width / 2f + 30, Height / 2f);
            Steps(1);
            desk.Release(MouseButton.Right);
            Steps(40);
            Vector3 turned = Camera().transform.position;
            Assert.That(Vector3.Angle(home, turned), Is.GreaterThan(20f));
            Assert.That(turned.magnitude, Is.EqualTo(home.magnitude).Within(1e-3f));
            desk.Scroll(3);
            Steps(40);
            Assert.That(Camera().transform.position.magnitude, Is.LessThan(0.8f * home.magnitude));
            Type(Key.Home);
            Steps(50);
            Assert.That((Camera().transform.position - home).magnitude, Is.LessThan(1e-3f));
        }

        [Test]
        public void Hints_TellAllControls_AndAreHiddenByTheirKey()
        {
            Assert.That(Text("Deeds").Split('\n'), Has.Length.EqualTo(Text("Keys").Split('\n').Length).And.Some.EqualTo("undo"));
            Type(Key.H);
            Assert.That(GameObject.Find("Hints"), Is.Null, "not active any more");
        }

        void Play(HostOptions options)
        {
            complaints.Clear();
            options.Log = (type, message, _) =>
            {
                if (type != LogType.Log)
                    complaints.Add(message);
            };
            (options.ScreenWidth, options.ScreenHeight) = (Width, Height);
            options.Headset = new HostHeadset { EyeWidth = 96, EyeHeight = 96 };
            host = UnityHost.Start(options);
            desk = new HostInput();
            host.LoadScene(Scene);
            Assert.That(host.RunUntil(() => Head().Volume != null, PatienceFrames), Is.True, "the volume is loaded");
            Steps(2);
        }

        void End()
        {
            desk.Dispose();
            host.UnloadScene();
            host.Step();
            host.Dispose();
        }

        void Steps(int frames)
        {
            for (int n = 0; n < frames; n++)
                host.Step();
        }

        void Type(Key key)
        {
            desk.Press(key);
            Steps(2);
            desk.Release(key);
            Steps(2);
        }

        static CarvedVolumeRenderer Head() => Find<CarvedVolumeRenderer>();

        static Camera Camera() => Find<Camera>();

        static T Find<T>() where T : Component => UnityEngine.Object.FindFirstObjectByType<T>();

        static string Text(string name) => GameObject.Find(name).GetComponent<Text>().text;

        /// <summary>Where the kernel's picture is opaque the screen is not the background, and where it is empty it is.</summary>
        static void AssertShows(byte[] screen, PictureData picture)
        {
            int wrong = 0;
            for (int p = 0; p < picture.Color.Length; p++)
            {
                bool isBackground = Math.Abs(screen[4 * p] - 0x16) + Math.Abs(screen[4 * p + 1] - 0x18) + Math.Abs(screen[4 * p + 2] - 0x1C) <= 3;
                wrong += picture.Color[p].a > 0.9f && isBackground || picture.Color[p].a == 0f && !isBackground ? 1 : 0;
            }
            Assert.That(wrong, Is.LessThan(picture.Color.Length / 200));
            Assert.That(Drawn(screen), Is.GreaterThan(0.1));
        }

        /// <summary>The share of pixels that are not the background.</summary>
        static double Drawn(byte[] rgba) => Enumerable.Range(0, rgba.Length / 4).Count(p => rgba[4 * p] > 0x30) / (rgba.Length / 4.0);

        static int Different(byte[] a, byte[] b) => Enumerable.Range(0, a.Length / 4).Count(p => Math.Abs(a[4 * p] - b[4 * p]) > 20);
    }
}
