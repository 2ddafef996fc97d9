using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// A renderer's place for one volume on the GPU. What the device or the render pipeline refuses is said once; a volume that was refused is not tried
    /// again before it was released.
    /// </summary>
    sealed class GpuSlot
    {
        SegmentedVolume refused;
        TextureLayout layout;
        string volumeProblem, drawingProblem, pictureProblem;

        public GpuSlot(RenderStatistics statistics) => Statistics = statistics;

        public RenderStatistics Statistics { get; }

        /// <summary>What is there; null = nothing.</summary>
        public VolumeGpu Gpu { get; private set; }

        /// <summary>Why the volume, or some way of showing it, is refused, as a sentence; null = all is well as far as it was tried.</summary>
        public string Problem => volumeProblem ?? drawingProblem ?? pictureProblem;

        /// <summary>Puts a volume there, unless it is there already, and brings it up to date; another one goes.</summary>
        /// <returns>Null where there is no volume or the device cannot.</returns>
        public VolumeGpu Update(in VolumeInputs inputs, TextureLayout wanted, Object owner)
        {
            KeepOnly(inputs.Volume);
            if (wanted != layout)
                Release();
            layout = wanted;
            if (inputs.Volume == null || inputs.Volume == refused)
                return null;
            try
            {
                Gpu ??= VolumeGpu.Create(inputs.Volume, layout, Statistics);
                Gpu.Update(inputs);
                return Gpu;
            }
            catch (AnatomyCarveException e)
            {
                Release();
                refused = inputs.Volume;
                Say(ref volumeProblem, $"This volume cannot be shown. {e.Message}", owner);
                return null;
            }
        }

        /// <summary>Renders into a picture.</summary>
        /// <returns>Null where the device cannot.</returns>
        public CarvedPicture Render(in VolumeInputs inputs, in PictureRayBundle rays, bool countSamples, CarvedPicture picture, Object owner)
        {
            string problem = DeviceSupport.MissingForPictures();
            if (problem == null)
            {
                try
                {
                    Gpu.Render(rays, inputs.Quality, inputs.Light, countSamples, picture);
                    return picture;
                }
                catch (AnatomyCarveException e)
                {
                    problem = e.Message;
                }
            }
            Say(ref pictureProblem, $"This volume cannot be rendered into a picture. {problem}", owner);
            return null;
        }

        /// <summary>Has cameras draw the volume, if the render pipeline allows it.</summary>
        public void ShowOn(MeshFilter filter, MeshRenderer renderer, in VolumeInputs inputs, Object owner)
        {
            string problem = RenderPipelines.Problem();
            if (problem == null)
            {
                try
                {
                    Gpu.ShowOn(filter, renderer, inputs);
                    drawingProblem = null;
                    return;
                }
                catch (AnatomyCarveException e)
                {
                    problem = e.Message;
                }
            }
            VolumeDrawing.Clear(filter, renderer);
            Say(ref drawingProblem, $"This volume cannot be drawn by cameras. {problem}", owner);
        }

        /// <summary>Lets go of every other volume.</summary>
        public void KeepOnly(SegmentedVolume volume)
        {
            if ((Gpu != null && Gpu.Volume != volume) || (refused != null && refused != volume))
                Release();
        }

        public void Release()
        {
            Gpu?.Dispose();
            Gpu = null;
            refused = null;
            volumeProblem = drawingProblem = pictureProblem = null;
        }

        static void Say(ref string said, string problem, Object owner)
        {
            if (said == problem)
                return;
            said = problem;
            Debug.LogError($"{owner.name}: {char.ToLowerInvariant(problem[0])}{problem.Substring(1)}", owner);
        }
    }
}
