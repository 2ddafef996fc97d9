using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.InputSystem;
using UnityEngine.InputSystem.LowLevel;

namespace AnatomyCarve.Headless.Tests.Input
{
    /// <summary>An asset that refers to actions.</summary>
    public sealed class ActionsAsset : ScriptableObject
    {
        public InputActionAsset asset;
        public InputActionReference toggle;
        public InputActionProperty resize;
    }

    /// <summary>.inputactions files: their text, what they become, and how others refer to that.</summary>
    public sealed class ImportTests : InputTests
    {
        const string ActionsGuid = "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa";
        const string ScriptGuid = "bbbbbbbbbbbbbbbbbbbbbbbbbbbbbbbb";

        // The ids, and what Unity makes of them, are known.
        const long ResizeFileId = 2354774633713466350, ToggleFileId = 5362560527200237608;

        const string Json = @"{ ""version"": 1, ""name"": ""Another Name"",
  ""maps"": [ { ""name"": ""Left"", ""id"": ""6b767880-046a-44aa-9540-dc5624a16dfc"",
    ""actions"": [
      { ""name"": ""Resize"", ""type"": ""Value"", ""id"": ""e6895ed7-94fb-4990-b9a5-f4e1a77cbf85"", ""expectedControlType"": ""Vector2"", ""processors"": ""StickDeadzone"", ""interactions"": """", ""initialStateCheck"": true },
      { ""name"": ""Toggle"", ""type"": ""Button"", ""id"": ""f2a869ce-b991-4e13-8c50-def39b263638"", ""expectedControlType"": ""Button"", ""processors"": """", ""interactions"": """", ""initialStateCheck"": false } ],
    ""bindings"": [
      { ""name"": """", ""id"": ""5ca4a5d7-9c5b-4985-9f83-6557237167a0"", ""path"": ""<Mouse>/delta"", ""groups"": """", ""action"": ""Resize"", ""isComposite"": false, ""isPartOfComposite"": false },
      { ""name"": ""Ctrl"", ""id"": ""da69872c-4d0c-41ea-9204-281890f65450"", ""path"": ""OneModifier"", ""groups"": """", ""action"": ""Toggle"", ""isComposite"": true, ""isPartOfComposite"": false },
      { ""name"": ""modifier"", ""id"": ""da69872c-4d0c-41ea-9204-281890f65451"", ""path"": ""<Keyboard>/ctrl"", ""groups"": ""Desk"", ""action"": ""Toggle"", ""isComposite"": false, ""isPartOfComposite"": true },
      { ""name"": ""binding"", ""id"": ""da69872c-4d0c-41ea-9204-281890f65452"", ""path"": ""<Keyboard>/t"", ""groups"": ""Desk"", ""action"": ""Toggle"", ""isComposite"": false, ""isPartOfComposite"": true } ] } ],
  ""controlSchemes"": [ { ""name"": ""Desk"", ""bindingGroup"": ""Desk"", ""devices"": [ { ""devicePath"": ""<Keyboard>"", ""isOptional"": false, ""isOR"": false } ] } ] }";

        internal static void WriteAssets(string folder)
        {
            void Write(string path, string text, string guid)
            {
                path = Path.Combine(folder, path);
                Directory.CreateDirectory(Path.GetDirectoryName(path));
                File.WriteAllText(path, text);
                File.WriteAllText(path + ".meta", $"fileFormatVersion: 2\nguid: {guid}\n");
            }

            Write("Hands.inputactions", Json, ActionsGuid);
            Write("ActionsAsset.cs", "namespace AnatomyCarve.Headless.Tests.Input { }", ScriptGuid);
            Write("Resources/InputTestActions.asset", $@"%YAML 1.1
%TAG !u! tag:unity3d.com,2011:
--- !u!114 &11400000
MonoBehaviour:
  m_Script: {{fileID: 11500000, guid: {ScriptGuid}, type: 3}}
  m_Name: InputTestActions
  asset: {{fileID: -944628639613478452, guid: {ActionsGuid}, type: 3}}
  toggle: {{fileID: {ToggleFileId}, guid: {ActionsGuid}, type: 3}}
  resize:
    m_UseReference: 1
    m_Action:
      m_Name: Resize
      m_Type: 0
      m_ExpectedControlType: 
      m_Id: 
      m_Processors: 
      m_Interactions: 
      m_SingletonActionBindings: []
      m_Flags: 0
    m_Reference: {{fileID: {ResizeFileId}, guid: {ActionsGuid}, type: 3}}
".Replace("\r", ""), "cccccccccccccccccccccccccccccccc");
        }

        [Test]
        public void FileIds_OfTheAssetAndAnAction_AreUnitys()
        {
            Assert.That(ImportedFileIds.Of("MonoBehaviour", "<root>"), Is.EqualTo(-944628639613478452));
            Assert.That(ImportedFileIds.Of("MonoBehaviour", "33754c03-48ec-46ef-9bc6-22ed6bfdd8e8"), Is.EqualTo(-6131295136447488360));
        }

        [Test]
        public void Asset_ReferredToFromYaml_IsTheFiles()
        {
            var loaded = Resources.Load<ActionsAsset>("InputTestActions");
            Assert.That((loaded.asset.name, loaded.asset.actionMaps.Count), Is.EqualTo(("Hands", 1)), "named after the file");
            Assert.That((loaded.toggle.name, loaded.toggle.action), Is.EqualTo(("Left/Toggle", loaded.asset.FindAction("Left/Toggle"))));
            Assert.That(loaded.resize.action, Is.SameAs(loaded.asset.FindAction("Resize")));
        }

        [Test]
        public void Copy_OfAnAsset_WorksByItself()
        {
            var keyboard = InputSystem.AddDevice<Keyboard>();
            var original = Resources.Load<ActionsAsset>("InputTestActions").asset;
            var copy = Object.Instantiate(original);
            InputAction toggle = copy.FindAction("Left/Toggle");
            Assert.That(toggle, Is.Not.SameAs(original.FindAction("Left/Toggle")));
            copy.Enable();
            Press(keyboard, Key.LeftCtrl, Key.T);
            Assert.That((toggle.WasPressedThisFrame(), original.enabled, toggle.actionMap.asset), Is.EqualTo((true, false, copy)));
            Object.DestroyImmediate(copy);
            Assert.That(toggle.enabled, Is.False, "a destroyed asset's actions end");
        }

        [Test]
        public void Json_WrittenAndRead_IsTheSame()
        {
            var asset = InputActionAsset.FromJson(Json);
            string json = asset.ToJson();
            var again = InputActionAsset.FromJson(json);
            Assert.That(again.ToJson(), Is.EqualTo(json));
            Assert.That(again.bindings, Is.EqualTo(asset.bindings));
            Assert.That(again.FindAction("Toggle").bindings.Count, Is.EqualTo(3));
            Assert.That(again.FindControlScheme("desk")?.deviceRequirements.Single().controlPath, Is.EqualTo("<Keyboard>"));
            Object.DestroyImmediate(asset);
            Object.DestroyImmediate(again);
        }

        [TestCase("Left/Toggle")]
        [TestCase("left/toggle")]
        [TestCase("Toggle")]
        [TestCase("f2a869ce-b991-4e13-8c50-def39b263638")]
        public void FindAction_ByNameOrId_FindsIt(string text) =>
            Assert.That(Resources.Load<ActionsAsset>("InputTestActions").asset.FindAction(text)?.name, Is.EqualTo("Toggle"));

        [Test]
        public void FindAction_ThatIsNotThere_SaysSo()
        {
            var asset = Resources.Load<ActionsAsset>("InputTestActions").asset;
            Assert.That(asset.FindAction("Left/Fly"), Is.Null);
            Assert.That(() => asset.FindAction("Left/Fly", true), Throws.ArgumentException.With.Message.Contains("Left/Fly"));
            Assert.That(() => asset.FindActionMap("Right", true), Throws.ArgumentException.With.Message.Contains("Right"));
        }

        [Test]
        public void Devices_OfAnAsset_AreTheOnlyOnesItUses()
        {
            var first = InputSystem.AddDevice<Keyboard>();
            var second = InputSystem.AddDevice<Keyboard>();
            var asset = Object.Instantiate(Resources.Load<ActionsAsset>("InputTestActions").asset);
            asset.devices = new InputDevice[] { second };
            asset.Enable();
            Press(first, Key.LeftCtrl, Key.T);
            Assert.That(asset["Toggle"].IsPressed(), Is.False);
            Press(second, Key.LeftCtrl, Key.T);
            Assert.That(asset["Toggle"].IsPressed(), Is.True);
            Object.DestroyImmediate(asset);
        }

        [Test]
        public void BindingMask_LeavesOtherGroupsOut()
        {
            var keyboard = InputSystem.AddDevice<Keyboard>();
            var asset = Object.Instantiate(Resources.Load<ActionsAsset>("InputTestActions").asset);
            asset.bindingMask = InputBinding.MaskByGroup("Headset");
            asset.Enable();
            Press(keyboard, Key.LeftCtrl, Key.T);
            Assert.That(asset["Toggle"].IsPressed(), Is.False);
            Object.DestroyImmediate(asset);
        }

        [TestCase("{ \"maps\": [ { \"name\": \"M\", \"actions\": [ { \"name\": \"A\", \"type\": \"Lever\" } ] } ] }", "Lever")]
        [TestCase("{ \"maps\": ", "JSON")]
        public void FromJson_OfBadText_SaysWhatIsWrong(string json, string expected) =>
            Assert.That(() => InputActionMap.FromJson(json), Throws.ArgumentException.With.Message.Contains(expected));

        [Test]
        public void ActionsAndBindings_MadeByScript_Work()
        {
            var mouse = InputSystem.AddDevice<Mouse>();
            var asset = ScriptableObject.CreateInstance<InputActionAsset>();
            InputActionMap map = asset.AddActionMap("Map");
            InputAction action = map.AddAction("Click", InputActionType.Button, "<Mouse>/leftButton");
            Assert.That(() => map.AddAction("click"), Throws.InvalidOperationException);
            action.ApplyBindingOverride(0, "<Mouse>/rightButton");
            asset.Enable();
            Send(mouse, new MouseState().WithButton(MouseButton.Right));
            Assert.That(action.WasPressedThisFrame(), Is.True);
            action.RemoveBindingOverride(0);
            Send(mouse, new MouseState().WithButton(MouseButton.Left));
            Assert.That((action.bindings[0].effectivePath, action.WasPressedThisFrame()), Is.EqualTo(("<Mouse>/leftButton", true)));
            Object.DestroyImmediate(asset);
        }
    }
}
