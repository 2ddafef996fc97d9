using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Drawing
{
    /// <summary>The volume and other things in the scene hide each other where they should.</summary>
    sealed class OcclusionTests : DrawnScene
    {
        const int Size = 96, Middle = Size * Size / 2 + Size / 2;

        CarvedVolumeRenderer volume;
        Camera camera;
        GameObject thing;

        [SetUp]
        public void MakeScene()
        {
            volume = MakeVolume(Phantoms.Markers(60));
            camera = MakeDrawingCamera(new Vector3(0f, 0f, -0.08f), Vector3.up, Size, Size);
            thing = Own(GameObject.CreatePrimitive(PrimitiveType.Cube));
            thing.transform.localScale = new Vector3(0.2f, 0.2f, 0.0002f);
        }

        [Test]
        public void OpaqueObject_BeforeTheVolume_HidesIt()
        {
            thing.transform.position = new Vector3(0f, 0f, -0.03f);
            Color[] with = Draw(camera);
            volume.enabled = false;
            Assert.That(with, Is.EqualTo(Draw(camera)), "as if there were no volume");
        }

        [Test]
        public void OpaqueObject_BehindTheVolume_IsHiddenByIt()
        {
            thing.transform.position = new Vector3(0f, 0f, 0.03f);
            Color[] with = Draw(camera);
            thing.SetActive(false);
            Color[] alone = Draw(camera);
            Assert.That(Difference(with[Middle], alone[Middle]), Is.LessThan(OneCode), "the anterior marker is opaque");
            Assert.That(Difference(with[0], alone[0]), Is.GreaterThan(0.05f), "beside the volume the wall is seen");
        }

        [Test]
        public void OpaqueObject_ThroughTheVolume_ShowsWhatIsInFrontOfIt()
        {
            // The anterior marker reaches from z = -18 mm to -10 mm; the markers left and right lie around z = 0.
            thing.transform.position = new Vector3(0f, 0f, -0.008f);
            Color[] with = Draw(camera);
            thing.SetActive(false);
            Color[] alone = Draw(camera);
            volume.enabled = false;
            thing.SetActive(true);
            Color[] wall = Draw(camera);
            Vector3 left = camera.WorldToViewportPoint(new Vector3(0.014f, 0f, 0f));
            int atLeft = (int)(left.y * Size) * Size + (int)(left.x * Size);
            Assert.That(Difference(with[Middle], alone[Middle]), Is.LessThan(OneCode), "in front of the wall");
            Assert.That(Difference(alone[atLeft], wall[atLeft]), Is.GreaterThan(0.05f), "without a wall something is there");
            Assert.That(Difference(with[atLeft], wall[atLeft]), Is.LessThan(OneCode), "behind the wall");
        }

        [Test]
        public void Volumes_ThatInterpenetrate_ShowTheNearerSurface([Values(false, true)] bool otherOrder)
        {
            thing.SetActive(false);
            CarvedVolumeRenderer cube = MakeVolume(Phantoms.Cube(20, "Cube"));
            cube.transform.position = new Vector3(0f, 0f, otherOrder ? -0.002f : 0.002f);
            Color[] both = Draw(camera);
            cube.enabled = false;
            Color[] markers = Draw(camera);
            cube.enabled = true;
            volume.enabled = false;
            Color[] block = Draw(camera);
            Assert.That(Difference(both[Middle], markers[Middle]), Is.LessThan(OneCode), "the anterior marker stands out of the cube");
            int beside = Middle + 8;
            Assert.That(Difference(both[beside], block[beside]), Is.LessThan(OneCode), "the body lies inside the cube");
        }

        [Test]
        public void TranslucentMatter_BeforeAnOpaqueObject_VeilsIt()
        {
            volume.TransferFunction = Volumes.OpacityTransferFunction.Parse("400:0,600:0.01");
            thing.transform.position = new Vector3(0f, 0f, 0.03f);
            Color[] with = Draw(camera);
            volume.enabled = false;
            Color[] wall = Draw(camera);
            Assert.That(Difference(with[Middle], wall[Middle]), Is.GreaterThan(0.02f).And.LessThan(0.5f));
        }
    }
}
