using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace AnatomyCarve.Headless.Tests.Scenes
{
    /// <summary>What cameras see, as files give it. Nothing is drawn here.</summary>
    public sealed class RendererSceneTests : ProjectTests
    {
        const string Standard = "{fileID: 46, guid: 0000000000000000f000000000000000, type: 0}";

        string Material(string fields, string shader = Standard)
        {
            Project.Write("A.mat", new Yaml().Add(21, "Material", 2100000, $"serializedVersion: 8\nm_Name: A\nm_Shader: {shader}\nm_Parent: {{fileID: 0}}\n"
                + $"m_ModifiedSerializedProperties: 0\nm_ValidKeywords: []\nm_InvalidKeywords: []\nm_LightmapFlags: 4\n{fields}").ToString());
            return $"{{fileID: 2100000, guid: {Project.Guid("A.mat")}, type: 2}}";
        }

        void LoadCube(string material) => Load(new Yaml().GameObject(10, "a", components: [12, 13])
            .Add(33, "MeshFilter", 12, "m_GameObject: {fileID: 10}\nm_Mesh: {fileID: 10202, guid: 0000000000000000e000000000000000, type: 0}")
            .Add(23, "MeshRenderer", 13, $"m_GameObject: {{fileID: 10}}\nm_Enabled: 0\nm_CastShadows: 0\nm_ReceiveShadows: 0\nm_Materials:\n- {material}\n"
                + "m_SortingOrder: 3\nm_RenderingLayerMask: 4294967295").Roots(11));

        [Test]
        public void Load_Renderer_HasMeshAndMaterial()
        {
            LoadCube("{fileID: 10303, guid: 0000000000000000f000000000000000, type: 0}");
            var renderer = Find("a").GetComponent<MeshRenderer>();
            Assert.That((Find("a").GetComponent<MeshFilter>().sharedMesh.name, renderer.sharedMaterial.name), Is.EqualTo(("Cube", "Default-Material")));
            Assert.That((renderer.enabled, renderer.shadowCastingMode, renderer.receiveShadows, renderer.sortingOrder, renderer.renderingLayerMask),
                Is.EqualTo((false, ShadowCastingMode.Off, false, 3, uint.MaxValue)));
        }

        [Test]
        public void Load_Material_HasItsValues()
        {
            LoadCube(Material("m_CustomRenderQueue: 2450\nm_EnableInstancingVariants: 1\nstringTagMap:\n  RenderType: Mine\ndisabledShaderPasses: []\n"
                + "m_SavedProperties:\n  serializedVersion: 3\n  m_TexEnvs:\n  - _MainTex:\n      m_Texture: {fileID: 0}\n      m_Scale: {x: 2, y: 1}\n"
                + "      m_Offset: {x: 0, y: 0}\n  m_Ints: []\n  m_Floats:\n  - _Gone: 1\n  m_Colors:\n  - _Color: {r: 0.25, g: 0.5, b: 0.75, a: 1}"));
            var material = Find("a").GetComponent<MeshRenderer>().sharedMaterial;
            Assert.That((material.name, material.color, material.renderQueue, material.enableInstancing, material.GetTag("RenderType", false)),
                Is.EqualTo(("A", new Color(0.25f, 0.5f, 0.75f, 1f), 2450, true, "Mine")));
        }

        [Test]
        public void Load_Material_OfAPackagesShader_FindsIt()
        {
            Project.Write("Mine.shader", "Shader \"Mine\" {\nProperties { _Way (\"Way\", Vector) = (0, 0, 0, 0) }\nSubShader { Pass {\nHLSLPROGRAM\n"
                + "#pragma vertex V\n#pragma fragment F\nfloat4 _Way;\nfloat4 V(float4 p : POSITION) : SV_Position { return p + _Way; }\n"
                + "float4 F() : SV_Target { return 1; }\nENDHLSL\n} } }");
            LoadCube(Material("m_SavedProperties:\n  m_Colors:\n  - _Way: {r: 1, g: 2, b: 3, a: 4}",
                $"{{fileID: 4800000, guid: {Project.Guid("Mine.shader")}, type: 3}}"));
            Assert.That(Find("a").GetComponent<MeshRenderer>().sharedMaterial.GetVector("_Way"), Is.EqualTo(new Vector4(1f, 2f, 3f, 4f)));
        }

        [TestCase("{fileID: 0}", "no shader")]
        [TestCase("{fileID: 10750, guid: 0000000000000000f000000000000000, type: 0}", "Unlit/Transparent")]
        public void Load_Material_WithoutAShaderOfTheHost_IsRefused(string shader, string expected)
        {
            var material = Material("m_DoubleSidedGI: 0", shader);
            Assert.That(() => LoadCube(material), Throws.TypeOf<AssetFormatException>().With.Message.Contains(expected));
        }

        [Test]
        public void Load_Light_HasItsSettings()
        {
            Load(new Yaml().Add(104, "RenderSettings", 2, "serializedVersion: 10\nm_AmbientSkyColor: {r: 0.5, g: 0.5, b: 0.5, a: 1}\nm_AmbientIntensity: 0.75\n"
                    + "m_SkyboxMaterial: {fileID: 10304, guid: 0000000000000000f000000000000000, type: 0}")
                .GameObject(10, "a", components: [12]).Add(108, "Light", 12, "m_GameObject: {fileID: 10}\nm_Enabled: 1\nserializedVersion: 11\nm_Type: 1\n"
                    + "m_Color: {r: 1, g: 0.9, b: 0.8, a: 1}\nm_Intensity: 2\nm_Shadows:\n  m_Type: 2\n  m_Strength: 0.5\n"
                    + "m_RenderingLayerMask: 4294967295").Roots(11));
            var light = Find("a").GetComponent<Light>();
            Assert.That((light.type, light.intensity, light.shadows, light.shadowStrength, light.renderingLayerMask),
                Is.EqualTo((LightType.Directional, 2f, LightShadows.Soft, 0.5f, -1)));
            Assert.That((RenderSettings.ambientLight, RenderSettings.ambientIntensity), Is.EqualTo((new Color(0.5f, 0.5f, 0.5f, 1f), 0.75f)));
        }

        [Test]
        public void Prefab_WithARenderer_IsDrawnOnceInstantiated()
        {
            var path = Project.Write("A.prefab", new Yaml().GameObject(10, "a", components: [12, 13])
                .Add(33, "MeshFilter", 12, "m_GameObject: {fileID: 10}\nm_Mesh: {fileID: 10202, guid: 0000000000000000e000000000000000, type: 0}")
                .Add(23, "MeshRenderer", 13, "m_GameObject: {fileID: 10}\nm_Enabled: 1\nm_Materials:\n"
                    + "- {fileID: 10303, guid: 0000000000000000f000000000000000, type: 0}").ToString());
            var prefab = (GameObject)Host.LoadAsset(path);
            var copy = Object.Instantiate(prefab);
            Assert.That((prefab.GetComponent<MeshRenderer>().IsShown, copy.GetComponent<MeshRenderer>().IsShown), Is.EqualTo((false, true)));
        }
    }
}
