using AnatomyCarve.Editor;
using NUnit.Framework;

namespace AnatomyCarve.Tests.Editor
{
    /// <summary>What the renderer's Inspector says first.</summary>
    sealed class NoticeTests
    {
        static RendererFacts AllWell => new RendererFacts { HasLoader = true, NamesVolume = true, HasVolume = true, IsEnabled = true };

        [Test]
        public void Notice_WhereAllIsWell_IsNone() => Assert.That(AllWell.Notice().Text, Is.Null);

        [Test]
        public void Problem_OfTheDevice_ComesFirst()
        {
            RendererFacts facts = AllWell;
            facts.Problem = "No compute shaders.";
            facts.HasLoader = false;
            Assert.That(facts.Notice().Kind, Is.EqualTo(NoticeKind.Error));
            Assert.That(facts.Notice().Text, Is.EqualTo("No compute shaders."));
        }

        [Test]
        public void Loader_ThatIsMissing_IsAWarning()
        {
            RendererFacts facts = AllWell;
            facts.HasLoader = false;
            Assert.That(facts.Notice().Kind, Is.EqualTo(NoticeKind.Warning));
        }

        [Test]
        public void Loading_IsShownWithItsProgress()
        {
            RendererFacts facts = AllWell;
            facts.HasVolume = false;
            facts.IsLoading = true;
            facts.Progress = 0.426f;
            Assert.That(facts.Notice().Text, Does.Contain("43 %"));
            facts.HasVolume = true;
            Assert.That(facts.Notice().Text, Is.Null, "another volume is still shown");
        }

        [Test]
        public void Volume_ThatIsMissing_IsExplained()
        {
            RendererFacts facts = AllWell;
            facts.HasVolume = false;
            Assert.That(facts.Notice().Text, Does.Contain("Load now").And.Contain("Console"));
            facts.NamesVolume = false;
            Assert.That(facts.Notice().Text, Does.Contain("neither an asset nor a file"));
        }

        [Test]
        public void Prefab_WithoutAVolume_IsNothingToSay()
        {
            RendererFacts facts = AllWell;
            facts.HasVolume = false;
            facts.NamesVolume = false;
            facts.IsAsset = true;
            Assert.That(facts.Notice().Text, Is.Null);
        }

        [Test]
        public void Disabled_IsSaid()
        {
            RendererFacts facts = AllWell;
            facts.IsEnabled = false;
            Assert.That(facts.Notice().Text, Does.Contain("disabled"));
        }
    }
}
