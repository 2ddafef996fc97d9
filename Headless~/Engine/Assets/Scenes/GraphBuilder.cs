using System;
using System.Collections.Generic;
using System.Linq;
using YamlDotNet.RepresentationModel;

namespace UnityEngine
{
    /// <summary>Makes the objects of a file: first all of them, so that references find each other, then their fields. Nobody wakes up.</summary>
    sealed class GraphBuilder
    {
        readonly ObjectGraph m_Graph;
        readonly Dictionary<long, Object> m_Objects;
        readonly YamlReferences m_References;

        /// <param name="graph">What the file consists of.</param>
        /// <param name="objects">Receives the objects by number.</param>
        internal GraphBuilder(ObjectGraph graph, Dictionary<long, Object> objects)
        {
            m_Graph = graph;
            m_Objects = objects;
            m_References = new YamlReferences(objects);
        }

        /// <summary>Constructs everything, without fields.</summary>
        internal void Construct()
        {
            foreach (var item in m_Graph.Items.Where(i => i.Class.Id != NativeClass.MonoBehaviour))
                item.Class.CheckFields(item.Document);
            foreach (var item in m_Graph.Items.Where(i => i.Class.Id == NativeClass.GameObject))
                ConstructGameObject(item);
            foreach (var item in m_Graph.Items.Where(i => i.Class.Id == NativeClass.MonoBehaviour && ObjectGraph.Owner(i) == 0))
                ConstructScriptableObject(item);
            foreach (var item in m_Graph.Items.Where(i => !m_Objects.ContainsKey(i.Id)))
                ConstructOther(item);
        }

        /// <summary>Fills the fields and puts the transforms into their hierarchy.</summary>
        /// <returns>The root objects, in order.</returns>
        internal List<GameObject> Fill()
        {
            foreach (var item in m_Graph.Items)
                Fill(item);
            var roots = new HierarchyBuilder(m_Graph, m_Objects).Build();
            foreach (var item in m_Graph.Items.Where(i => i.Class.Id != NativeClass.SceneRoots))
                m_References.CheckAll(item.Document);
            return roots;
        }

        /// <summary>Puts a scene's settings into force.</summary>
        internal void ApplySettings()
        {
            foreach (var item in m_Graph.Items.Where(i => i.Class.Id == NativeClass.RenderSettings))
                RendererReaders.ReadRenderSettings(new NativeFields(item.Document, m_References));
        }

        void ConstructGameObject(GraphItem item)
        {
            var document = item.Document;
            var components = document.List(document.Needed(document.Body, "m_Component"))
                .Select(n => Component(item, document.Mapping(n))).ToList();
            if (components.Count == 0 || !components[0].Class.IsTransform || components.Count(c => c.Class.IsTransform) != 1)
                throw document.Error(document.Body, "the first component of a GameObject, and only that, is its Transform");
            var g = GameObject.Construct(document.Scalar(document.Needed(document.Body, "m_Name")), NativeReaders.TypeOf(components[0].Class.Id));
            m_Objects.Add(item.Id, g);
            m_Objects.Add(components[0].Id, g.OwnTransform);
            foreach (var component in components.Skip(1))
                ConstructComponent(component, g);
            foreach (var component in g.Components)
                CheckRequirements(document, component);
        }

        /// <summary>A component that a GameObject lists, and that says that it belongs there.</summary>
        GraphItem Component(GraphItem owner, YamlMappingNode entry)
        {
            var id = owner.Document.LocalId(owner.Document.Needed(entry, "component"));
            var component = m_Graph.Find(id) ?? throw owner.Document.Error(entry, $"lists component {id}, which the file does not have");
            if (!component.Class.IsComponent)
                throw owner.Document.Error(entry, $"lists {id} as a component, which is a {component.Class.Name}");
            if (ObjectGraph.Owner(component) != owner.Id)
                throw component.Document.Error(component.Document.Body,
                    $"belongs to GameObject {ObjectGraph.Owner(component)}, but GameObject {owner.Id} lists it as its component");
            if (m_Objects.ContainsKey(id))
                throw owner.Document.Error(entry, $"lists component {id} twice");
            return component;
        }

        void ConstructComponent(GraphItem item, GameObject owner)
        {
            var document = item.Document;
            if (m_Objects.ContainsKey(item.Id))
                throw document.Error(document.Body, "is listed twice as a component");
            var typeName = "UnityEngine." + item.Class.Name;
            var type = NativeReaders.TypeOf(item.Class.Id);
            if (item.Class.Id == NativeClass.MonoBehaviour)
            {
                var script = ScriptReference.Of(document);
                (type, typeName) = (script.Type, script.TypeName);
                if (type != null && (!typeof(MonoBehaviour).IsAssignableFrom(type) || type.IsAbstract))
                    throw document.Error(document.Body, $"its script {typeName} is no component");
            }

            var component = ComponentFactory.Construct(type ?? typeof(DataComponent), owner);
            (component as DataComponent)?.Fill(typeName, document);
            m_Objects.Add(item.Id, component);
        }

        static void CheckRequirements(YamlDocument document, Component component)
        {
            foreach (var required in ComponentFactory.Required(component.GetType()))
                if (!component.Owner.Components.Any(required.IsInstanceOfType))
                    throw document.Error(document.Body,
                        $"'{component.NameForMessages}' has a {component.GetType().Name} without the {required.Name} that it requires");
        }

        void ConstructScriptableObject(GraphItem item)
        {
            var script = ScriptReference.Of(item.Document);
            if (script.Type == null)
                throw item.Document.Error(item.Document.Body, $"is a {script.TypeName}, which the host does not have");
            if (!typeof(ScriptableObject).IsAssignableFrom(script.Type))
                throw item.Document.Error(item.Document.Body, $"its script {script.TypeName} is no ScriptableObject, and it has no m_GameObject");
            m_Objects.Add(item.Id, ScriptableObject.Construct(script.Type));
        }

        void ConstructOther(GraphItem item)
        {
            if (item.Class.IsComponent)
                throw item.Document.Error(item.Document.Body, $"no GameObject lists the {item.Class.Name} {item.Id} as its component");
            if (item.Class.IsSettings || item.Class.Id == NativeClass.SceneRoots)
                return;
            m_Objects.Add(item.Id, item.Class.Id == NativeClass.Material
                ? MaterialReader.Construct(new NativeFields(item.Document, m_References))
                : (Object)DataAsset.Of(m_Graph.Path, item.Id));
        }

        void Fill(GraphItem item)
        {
            if (!m_Objects.TryGetValue(item.Id, out var target))
                return;
            var document = item.Document;
            var fields = new NativeFields(document, m_References);
            target.hideFlags = (HideFlags)fields.Get("m_ObjectHideFlags", 0);
            if (target is Behaviour behaviour)
                behaviour.EnabledFlag = fields.Get("m_Enabled", true);
            if (item.Class.Id != NativeClass.MonoBehaviour)
            {
                if (NativeReaders.TypeOf(item.Class.Id) != null)
                    NativeReaders.Read(target, item.Class.Id, fields);
                return;
            }

            if (target is DataComponent)
                return;
            if (target is ScriptableObject)
                target.NativeName = fields.Get("m_Name", "");
            new YamlFields(document, m_References, ScriptReference.Of(document).IsOwn)
                .Read(target, document.Body.Children.Where(c => !item.Class.Has(YamlNodes.Key(c))));
            (target as ISerializationCallbackReceiver)?.OnAfterDeserialize();
        }
    }
}
