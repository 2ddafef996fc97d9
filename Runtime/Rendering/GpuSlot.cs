using System;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace AnatomyCarve
{
    /// <summary>
    /// A renderer's place for one volume: on the GPU, and in cameras. What the device or the render pipeline refuses is said once; a volume that was refused
    /// is not tried again before it was released.
    /// </summary>
    sealed class GpuSlot
    {
        readonly Object owner;
        SegmentedVolume refused;
        TextureLayout layout;
        VolumeDrawing drawing;
        VolumeSurface shownOn;
        RenderPipelineAsset pipeline;
        bool isPipelineKnown;
        string volumeProblem, pipelineProblem, drawingProblem, pictureProblem;

        /// <param name="owner">Who says what is refused.</param>
        public GpuSlot(Object owner) => this.owner = owner;

        public RenderStatistics Statistics { get; } = new RenderStatistics();

        /// <summary>What is on the GPU; null = nothing.</summary>
        public VolumeGpu Gpu { get; private set; }

        /// <summary>Why the volume, or some way of showing it, is refused, as a sentence; null = all is well as far as it was tried.</summary>
        public string Problem => volumeProblem ?? pipelineProblem ?? drawingProblem ?? pictureProblem;

        /// <summary>Puts a volume on the GPU, unless it is there already, and brings it up to date; another one goes.</summary>
        /// <returns>Null where there is no volume or the device cannot.</returns>
        public VolumeGpu Update(in VolumeInputs inputs, TextureLayout wanted)
        {
            if (!IsPossible(inputs.Volume, wanted))
                return null;
            try
            {
                Gpu ??= VolumeGpu.Create(inputs.Volume, layout, Statistics);
                Gpu.Update(inputs);
                if (drawing != null)
                    Bind(inputs); // textures may be new, and a camera be about to draw
                return Gpu;
            }
            catch (Exception e) when (IsRefusal(e))
            {
                Refuse(inputs.Volume, Sentence(e));
                return null;
            }
        }

        /// <summary>Renders into a picture.</summary>
        /// <returns>Null where the device cannot.</returns>
        public CarvedPicture Render(in VolumeInputs inputs, in PictureRayBundle rays, bool countSamples, CarvedPicture picture)
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
            Say(ref pictureProblem, $"This volume cannot be rendered into a picture. {problem}");
            return null;
        }

        /// <summary>
        /// Has a surface show the volume's box, if it is wanted and the render pipeline and the device draw volumes; else it shows nothing. Nothing goes to the
        /// GPU yet.
        /// </summary>
        /// <returns>Whether cameras can draw it.</returns>
        public bool Place(VolumeSurface surface, bool isWanted, SegmentedVolume volume, TextureLayout wanted)
        {
            bool isPlaced = isWanted && IsPipelineSupported() && IsPossible(volume, wanted) && drawingProblem == null && Show(surface, volume);
            if (!isPlaced)
                surface.Clear();
            return isPlaced;
        }

        /// <summary>Has cameras draw the volume as it is on the GPU. It was placed before.</summary>
        public void Bind(in VolumeInputs inputs) => Gpu.Bind(drawing, inputs.Quality, inputs.Light);

        /// <summary>Lets go of every other volume.</summary>
        public void KeepOnly(SegmentedVolume volume)
        {
            if ((Gpu != null && Gpu.Volume != volume) || (refused != null && refused != volume)
                || (drawing != null && drawing.Geometry != volume?.Geometry))
                Release();
        }

        public void Release()
        {
            Gpu?.Dispose();
            Gpu = null;
            shownOn?.Clear(); // what is shown there goes now
            shownOn = null;
            drawing?.Dispose();
            drawing = null;
            refused = null;
            pipeline = null;
            isPipelineKnown = false;
            volumeProblem = pipelineProblem = drawingProblem = pictureProblem = null;
        }

        /// <summary>What a device that cannot answers with.</summary>
        static bool IsRefusal(Exception e) =>
            e is AnatomyCarveException || e is ArgumentException || e is UnityException || e is OutOfMemoryException;

        static string Sentence(Exception e) => e is AnatomyCarveException ? e.Message : $"The device could not take it: {e.Message}";

        bool Show(VolumeSurface surface, SegmentedVolume volume)
        {
            string problem = drawing == null ? DeviceSupport.Missing(volume.Geometry, DeviceSupport.Choose(layout)) : null;
            if (problem != null)
            {
                Refuse(volume, problem);
                return false;
            }
            try
            {
                drawing ??= new VolumeDrawing(AnatomyCarveShaders.LoadOrThrow(), volume.Geometry);
                drawing.Place(surface);
                shownOn = surface;
                return true;
            }
            catch (Exception e) when (IsRefusal(e))
            {
                Say(ref drawingProblem, $"This volume cannot be drawn by cameras. {Sentence(e)}");
                return false;
            }
        }

        bool IsPossible(SegmentedVolume volume, TextureLayout wanted)
        {
            KeepOnly(volume);
            if (wanted != layout)
                Release();
            layout = wanted;
            return volume != null && volume != refused;
        }

        bool IsPipelineSupported()
        {
            RenderPipelineAsset present = GraphicsSettings.currentRenderPipeline;
            if (!isPipelineKnown || present != pipeline)
            {
                isPipelineKnown = true;
                pipeline = present;
                string problem = RenderPipelines.Problem(present);
                if (problem == null)
                    pipelineProblem = null;
                else
                    Say(ref pipelineProblem, $"This volume cannot be drawn by cameras. {problem}");
            }
            return pipelineProblem == null;
        }

        void Refuse(SegmentedVolume volume, string problem)
        {
            Release();
            refused = volume;
            Say(ref volumeProblem, $"This volume cannot be shown. {problem}");
        }

        void Say(ref string said, string problem)
        {
            if (said == problem)
                return;
            said = problem;
            Debug.LogError($"{owner.name}: {char.ToLowerInvariant(problem[0])}{problem.Substring(1)}", owner);
        }
    }
}
