using System;
using System.Collections.Generic;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>A renderer's pictures: one for each camera, kept as long as the camera lives, and one for rays without a camera.</summary>
    sealed class PictureCache : IDisposable
    {
        readonly Dictionary<Camera, CarvedPicture> ofCameras = new Dictionary<Camera, CarvedPicture>();
        readonly List<Camera> gone = new List<Camera>();
        CarvedPicture ofRays;

        public CarvedPicture Of(Camera camera)
        {
            DropGone();
            if (!ofCameras.TryGetValue(camera, out CarvedPicture picture))
            {
                picture = new CarvedPicture("AnatomyCarve " + camera.name);
                ofCameras.Add(camera, picture);
            }
            return picture;
        }

        public CarvedPicture OfRays() => ofRays ??= new CarvedPicture("AnatomyCarve rays");

        public void AddSizes(List<ResourceSize> sizes)
        {
            foreach (KeyValuePair<Camera, CarvedPicture> entry in ofCameras)
                sizes.Add(new ResourceSize(entry.Value.Name, entry.Value.Bytes));
            if (ofRays != null)
                sizes.Add(new ResourceSize(ofRays.Name, ofRays.Bytes));
        }

        public void Dispose()
        {
            foreach (KeyValuePair<Camera, CarvedPicture> entry in ofCameras)
                entry.Value.Dispose();
            ofCameras.Clear();
            ofRays?.Dispose();
            ofRays = null;
        }

        /// <summary>Frees the pictures of cameras that were destroyed.</summary>
        public void DropGone()
        {
            foreach (KeyValuePair<Camera, CarvedPicture> entry in ofCameras)
                if (entry.Key == null)
                    gone.Add(entry.Key);
            foreach (Camera camera in gone)
            {
                ofCameras[camera].Dispose();
                ofCameras.Remove(camera);
            }
            gone.Clear();
        }
    }
}
