using AnatomyCarve.Volumes;
using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>
    /// The package's kernels and its shader. One asset of this type lies in a Resources folder of the package and refers to them, so that a player build
    /// holds them and a component that was added at run time finds them without any wiring.
    /// </summary>
    public sealed class AnatomyCarveShaders : ScriptableObject
    {
        const string ResourceName = "AnatomyCarveShaders";

        [SerializeField, Tooltip("Eq. 1 and the transfer function: which opacity a voxel has")]
        ComputeShader clipVoxels = null;

        [SerializeField, Tooltip("3D FXAA of the opacity")]
        ComputeShader antiAlias = null;

        [SerializeField, Tooltip("Normals from the anti-aliased opacity")]
        ComputeShader sobelNormals = null;

        [SerializeField, Tooltip("Empties bricks in which nothing is visible")]
        ComputeShader clearBricks = null;

        [SerializeField, Tooltip("Skip structure, step 1: which cells hold anything")]
        ComputeShader occupiedCells = null;

        [SerializeField, Tooltip("Skip structure, step 2: distances within planes")]
        ComputeShader planeDistances = null;

        [SerializeField, Tooltip("Skip structure, step 3: distances")]
        ComputeShader skipDistances = null;

        [SerializeField, Tooltip("Direct volume rendering into colour, depth and first visible segment")]
        ComputeShader raymarch = null;

        [SerializeField, Tooltip("The volume in a camera's own picture")]
        Shader carvedVolume = null;

        /// <summary>Kernel <c>ClipVoxels</c>: Eq. 1 and the opacity transfer function.</summary>
        public ComputeShader ClipVoxels => clipVoxels;

        /// <summary>Kernel <c>AntiAlias</c>: 3D FXAA of the opacity.</summary>
        public ComputeShader AntiAlias => antiAlias;

        /// <summary>Kernel <c>SobelNormals</c>: normals from the anti-aliased opacity.</summary>
        public ComputeShader SobelNormals => sobelNormals;

        /// <summary>Kernel <c>ClearBricks</c>: opacity 0 where nothing is visible.</summary>
        public ComputeShader ClearBricks => clearBricks;

        /// <summary>Kernel <c>OccupiedCells</c>: which cells of 4 x 4 x 4 voxels hold anything.</summary>
        public ComputeShader OccupiedCells => occupiedCells;

        /// <summary>Kernel <c>PlaneDistances</c>: distances to occupied cells within planes.</summary>
        public ComputeShader PlaneDistances => planeDistances;

        /// <summary>Kernel <c>SkipDistances</c>: distances to occupied cells, by which rays skip empty space.</summary>
        public ComputeShader SkipDistances => skipDistances;

        /// <summary>Kernel <c>Raymarch</c>: the picture.</summary>
        public ComputeShader Raymarch => raymarch;

        /// <summary>Shader <c>AnatomyCarve/Carved Volume</c>: the volume in a camera's own picture.</summary>
        public Shader CarvedVolume => carvedVolume;

        /// <summary>Loads the package's asset.</summary>
        /// <exception cref="AnatomyCarveException">It is not part of the build.</exception>
        internal static AnatomyCarveShaders LoadOrThrow()
        {
            AnatomyCarveShaders shaders = Load();
            return shaders != null ? shaders : throw new AnatomyCarveException("Runtime/Resources/AnatomyCarveShaders.asset is missing in this build.");
        }

        /// <summary>Loads the package's asset.</summary>
        /// <returns>The asset; null where it is not part of the build.</returns>
        public static AnatomyCarveShaders Load() => Resources.Load<AnatomyCarveShaders>(ResourceName);
    }
}
