using System;
using System.IO;
using System.Linq;
using AnatomyCarve.Volumes;
using UnityEditor;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>
    /// What shows that the package works in this Editor, on this machine. The methods are for the Editor's command line (-batchmode -executeMethod), and end
    /// with exit code 0 where all is well and 1 where it is not.
    /// </summary>
    public static class EditorVerification
    {
        const string SceneOption = "-anatomycarveScene", OutputOption = "-anatomycarveOutput", VerificationOption = "-anatomycarveVerification";
        const string SampleScene = "DemoHead";

        /// <summary>
        /// Opens a scene, plays it, and writes game.png (what its camera draws), kernel.png (what the kernel renders for that camera) and
        /// report.json. Ends the Editor when it is done, so it needs no -quit. Options: <c>-anatomycarveOutput FOLDER</c>, and
        /// <c>-anatomycarveScene PATH</c> of an asset; without it, the imported sample's scene.
        /// </summary>
        /// <exception cref="ArgumentException">An option has no value, or the folder is not given.</exception>
        /// <exception cref="AnatomyCarveException">There is no such scene.</exception>
        public static void Screenshots()
        {
            string[] arguments = Environment.GetCommandLineArgs();
            string output = CommandLineArguments.Value(arguments, OutputOption)
                ?? throw new ArgumentException($"{OutputOption} is missing: the folder for pictures and report.");
            string scene = CommandLineArguments.Value(arguments, SceneOption) ?? FindSampleScene();
            if (AssetDatabase.LoadAssetAtPath<SceneAsset>(scene) == null)
                throw new AnatomyCarveException($"{scene}: there is no such scene; expected the path of an asset, such as Assets/Scenes/Head.unity.");
            Directory.CreateDirectory(output);
            Debug.Log($"AnatomyCarve verification: {scene}, results in {output}.");
            EditorSceneManager.OpenScene(scene, OpenSceneMode.Single);
            VerificationRun.Start(Path.GetFullPath(output), scene);
        }

        /// <summary>
        /// With <c>-anatomycarveVerification</c> on the command line shaders are compiled before they are drawn: the first picture of a project would show
        /// placeholders otherwise.
        /// </summary>
        [InitializeOnLoadMethod]
        static void ObeyCommandLine()
        {
            if (Array.IndexOf(Environment.GetCommandLineArgs(), VerificationOption) >= 0)
                ShaderUtil.allowAsyncCompilation = false;
        }

        /// <summary>Imports the package's sample into Assets/Samples, and checks that its volume was imported.</summary>
        /// <exception cref="AnatomyCarveException">The sample cannot be found, or its volume was not imported; the log says why.</exception>
        public static void ImportSample()
        {
            string folder = SampleImport.Run();
            string[] volumes = AssetDatabase.FindAssets("t:" + nameof(VolumeAsset), new[] { folder }).Select(AssetDatabase.GUIDToAssetPath).ToArray();
            if (volumes.Length == 0)
                throw new AnatomyCarveException($"{folder}: none of its files was imported as a volume.");
            Debug.Log($"AnatomyCarve verification: imported {string.Join(", ", volumes)}.");
        }

        static string FindSampleScene()
        {
            string path = AssetDatabase.FindAssets(SampleScene + " t:Scene", new[] { "Assets" }).Select(AssetDatabase.GUIDToAssetPath)
                .FirstOrDefault(p => Path.GetFileNameWithoutExtension(p) == SampleScene);
            return path ?? throw new AnatomyCarveException(
                $"{SampleScene}.unity is not in this project. Import the sample first (EditorVerification.ImportSample), or give {SceneOption}.");
        }
    }
}
