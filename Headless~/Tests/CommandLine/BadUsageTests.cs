using NUnit.Framework;

namespace AnatomyCarve.Headless.Tests.CommandLine
{
    /// <summary>Arguments that can't be right: exit code 2, one line, nothing written.</summary>
    sealed class BadUsageTests
    {
        [TestCase("nothing", TestName = "BadUsage_UnknownCommand_IsRefused")]
        [TestCase(TestName = "BadUsage_NoCommand_IsRefused")]
        [TestCase("info", TestName = "BadUsage_InfoWithoutFile_IsRefused")]
        [TestCase("info", "a.nrrd", "--jsno", TestName = "BadUsage_MisspelledOption_IsRefused")]
        [TestCase("compare", "a.png", TestName = "BadUsage_CompareWithOneFile_IsRefused")]
        [TestCase("expect", "a.json", TestName = "BadUsage_ExpectWithOneFile_IsRefused")]
        [TestCase("render", "a.nrrd", TestName = "BadUsage_RenderWithoutOutput_IsRefused")]
        [TestCase("render", "--output", "a.png", TestName = "BadUsage_RenderWithoutVolume_IsRefused")]
        [TestCase("render", "a.nrrd", "--phantom", "8x8x8", "--output", "a.png", TestName = "BadUsage_RenderOfAVolumeAndThePhantom_IsRefused")]
        [TestCase("render", "--phantom", "8x8", "--output", "a.png", TestName = "BadUsage_RenderOfAPhantomWithTwoSides_IsRefused")]
        [TestCase("render", "--phantom", "8x8x8", "--labels", "b.nrrd", "--output", "a.png", TestName = "BadUsage_LabelsForThePhantom_AreRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--budget", "-1", TestName = "BadUsage_BudgetBelowZero_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.jpg", TestName = "BadUsage_PictureThatIsNoPng_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--depth", "a.exr", TestName = "BadUsage_DepthThatIsNoPfm_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--segments", "a.png", TestName = "BadUsage_SegmentsThatAreNoPgm_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--report", "a.txt", TestName = "BadUsage_ReportThatIsNoJson_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--size", "512", TestName = "BadUsage_SizeWithOneSide_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--size", "0x512", TestName = "BadUsage_SizeOfNothing_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--size", "99999x9", TestName = "BadUsage_SizeBeyondTextures_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--size", "-5x5", TestName = "BadUsage_NegativeSize_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--quality", "superb", TestName = "BadUsage_UnknownQuality_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--cut", "sharp", TestName = "BadUsage_UnknownCut_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--anti-aliasing", "1.5", TestName = "BadUsage_AntiAliasingAbove1_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--anti-aliasing", "nan", TestName = "BadUsage_AntiAliasingThatIsNoNumber_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--camera", ".", TestName = "BadUsage_CameraThatIsAFolder_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--background", "blue", TestName = "BadUsage_BackgroundByName_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--camera", "12", TestName = "BadUsage_CameraOfOneAngle_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--camera", "0,91", TestName = "BadUsage_ElevationBeyondThePole_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--camera", "0,0,180", TestName = "BadUsage_FieldOfViewOf180_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--camera", "nan,0", TestName = "BadUsage_AngleThatIsNoNumber_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--drawn", "b.jpg", TestName = "BadUsage_DrawnPictureThatIsNoPng_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--drawn-depth", "b.png", TestName = "BadUsage_DrawnDepthThatIsNoPfm_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--pipeline", "hdrp", TestName = "BadUsage_UnknownPipeline_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--color-space", "sRGB", TestName = "BadUsage_UnknownColourSpace_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--layout", "tiny", TestName = "BadUsage_UnknownLayout_IsRefused")]
        [TestCase("render", "a.nrrd", "--output", "a.png", "--stereo", "anaglyph", TestName = "BadUsage_UnknownStereo_IsRefused")]
        [TestCase("scene", TestName = "BadUsage_NoScene_IsRefused")]
        [TestCase("scene", "a.unity", TestName = "BadUsage_SceneWithoutOutput_IsRefused")]
        [TestCase("scene", "a.unity", "--output", "a.png", "--frames", "0", TestName = "BadUsage_NoFrames_AreRefused")]
        [TestCase("bench", TestName = "BadUsage_BenchWithoutWhat_IsRefused")]
        [TestCase("bench", "load", TestName = "BadUsage_BenchLoadWithoutVolume_IsRefused")]
        [TestCase("bench", "load", "a.nrrd", "--phantom", "4x4x4", TestName = "BadUsage_BenchLoadOfTwoThings_IsRefused")]
        [TestCase("bench", "load", "--phantom", "4x4x4", "--labels", "a.nrrd", TestName = "BadUsage_LabelsOfThePhantom_AreRefused")]
        [TestCase("bench", "load", "--phantom", "4x4", TestName = "BadUsage_PhantomOfTwoSides_IsRefused")]
        [TestCase("bench", "load", "--phantom", "2048x2048x2048", TestName = "BadUsage_PhantomBeyondMemory_IsRefused")]
        [TestCase("bench", "load", "a.nrrd", "--runs", "0", TestName = "BadUsage_NoRuns_AreRefused")]
        [TestCase("bench", "load", "a.nrrd", "--threads", "65", TestName = "BadUsage_TooManyThreads_AreRefused")]
        public void BadUsage(params string[] arguments)
        {
            var result = Carve.InProcess(arguments);

            Assert.That(result.ExitCode, Is.EqualTo(2), result.Error);
            Assert.That(result.ErrorLines, Has.Length.EqualTo(1), result.Error);
            Assert.That(result.ErrorLines[0], Does.StartWith("carve: "));
            Assert.That(result.Output, Is.Empty);
        }

        [Test]
        public void BadUsage_UnknownCommand_IsNamed() => Assert.That(Carve.InProcess("nothing").Error, Does.Contain("nothing"));
    }
}
