using System;
using AnatomyCarve.Picking;
using AnatomyCarve.Volumes;
using NUnit.Framework;
using UnityEngine;

namespace AnatomyCarve.Tests.Components
{
    /// <summary>A camera's rays in the patient: a point of the patient lies on the ray of the pixel that it is projected to.</summary>
    sealed class CameraRaysTests : PlayModeScene
    {
        const int Width = 640, Height = 480;
        const double ToleranceMm = 0.02;

        [Test]
        public void Rays_OfAPerspectiveCamera_PassThroughWhatTheirPixelShows([Values(1, 2, 3)] int seed) => AssertProjections(seed, camera => { });

        [Test]
        public void Rays_OfAnOrthographicCamera_PassThroughWhatTheirPixelShows([Values(1, 2, 3)] int seed) => AssertProjections(seed, camera =>
        {
            camera.orthographic = true;
            camera.orthographicSize = 0.3f;
        });

        [Test]
        public void Rays_OfAnOffCentreProjection_PassThroughWhatTheirPixelShows([Values(1, 2, 3)] int seed) => AssertProjections(seed, camera =>
        {
            Matrix4x4 projection = camera.projectionMatrix;
            projection.m02 = 0.15f;
            projection.m12 = -0.1f;
            camera.projectionMatrix = projection;
        });

        [Test]
        public void Range_OfACamera_IsFromItsNearToItsFarPlane()
        {
            Camera camera = MakeCamera(new Vector3(0f, 0f, -1f), Vector3.up);
            camera.nearClipPlane = 0.25f;
            camera.farClipPlane = 4f;
            PictureRays rays = CameraRays.Of(camera, Make("Volume").transform, Phantoms.Cube(4, "Cube").Geometry, Width, Height);
            Assert.That(rays.NearT, Is.EqualTo(0.25).Within(1e-4));
            Assert.That(rays.FarT, Is.EqualTo(4).Within(1e-3));
            RayMm middle = rays.Ray(Width * 0.5, Height * 0.5);
            Assert.That(rays.Direction.Length, Is.GreaterThanOrEqualTo(1000), "one unit of t is one metre deep");
            Assert.That(middle.Direction.Y, Is.EqualTo(1).Within(1e-6), "+z is posterior");
        }

        [Test]
        public void Picture_OfAMarker_ShowsItAtItsPixel()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers());
            Transform volume = renderer.transform;
            volume.position = new Vector3(0.02f, 0.01f, 0.3f);
            volume.rotation = Quaternion.Euler(0f, 35f, 10f);
            volume.localScale = new Vector3(1.5f, 1f, 1.25f);
            Camera camera = MakeCamera(new Vector3(0.01f, 0.02f, 0.12f), Vector3.up);
            camera.transform.rotation = Quaternion.LookRotation(volume.position - camera.transform.position, Vector3.up);
            camera.fieldOfView = 30f;
            PictureData picture = renderer.Render(camera, 96, 96).Read();
            Vector3 anterior = volume.TransformPoint(VolumeSpace.LpsToLocal(
                renderer.Volume.Geometry, renderer.Volume.Geometry.CentreLps + Phantoms.MarkerCentre(Phantoms.Anterior)));
            Vector2 pixel = Project(camera, anterior, 96, 96);
            Assert.That(picture.Segments[(int)pixel.x + 96 * (int)pixel.y], Is.EqualTo(Phantoms.Anterior));
        }

        [Test]
        public void Render_OfAVolumeWithScaleZero_GivesNoPicture()
        {
            CarvedVolumeRenderer renderer = MakeVolume(Phantoms.Markers(16));
            renderer.transform.localScale = new Vector3(1f, 0f, 1f);
            Assert.That(renderer.Render(MakeCamera(new Vector3(0f, 0f, -0.1f), Vector3.up), 8, 8), Is.Null);
        }

        void AssertProjections(int seed, Action<Camera> configure)
        {
            var random = new System.Random(seed);
            float Next(float range) => (float)(random.NextDouble() - 0.5) * 2f * range;
            VolumeGeometry geometry = Phantoms.Markers(16).Geometry;
            Transform volume = Make("Volume").transform;
            volume.position = new Vector3(Next(0.1f), Next(0.1f), Next(0.1f));
            volume.rotation = Quaternion.Euler(Next(180f), Next(180f), Next(180f));
            volume.localScale = new Vector3(1f + Next(0.5f), 1f + Next(0.5f), 1f + Next(0.5f));
            Camera camera = MakeCamera(new Vector3(Next(0.3f), Next(0.3f), -0.5f), Vector3.up);
            camera.aspect = (float)Width / Height;
            configure(camera);
            PictureRays rays = CameraRays.Of(camera, volume, geometry, Width, Height);
            for (int n = 0; n < 20; n++)
            {
                PointMm point = geometry.CentreLps + new VectorMm(Next(20f), Next(20f), Next(20f));
                Vector2 pixel = Project(camera, volume.TransformPoint(VolumeSpace.LpsToLocal(geometry, point)), Width, Height);
                RayMm ray = rays.Ray(pixel.x, pixel.y);
                VectorMm to = point - ray.Origin;
                double distance = (to - VectorMm.Dot(to, ray.Direction) * ray.Direction).Length;
                Assert.That(distance, Is.LessThan(ToleranceMm), $"seed {seed}, point {n}");
                Assert.That(VectorMm.Dot(to, ray.Direction), Is.GreaterThan(0), "in front of the camera");
            }
        }

        /// <summary>Where Unity's own matrices project a point of the world, in pixels from the lower left corner.</summary>
        static Vector2 Project(Camera camera, Vector3 world, int width, int height)
        {
            Vector4 clip = camera.projectionMatrix * camera.worldToCameraMatrix * new Vector4(world.x, world.y, world.z, 1f);
            return new Vector2((clip.x / clip.w * 0.5f + 0.5f) * width, (clip.y / clip.w * 0.5f + 0.5f) * height);
        }
    }
}
