using System;
using System.Collections.Generic;
using UnityEngine.Shaders;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>How draws go to the eyes of a picture.</summary>
    enum StereoDrawing
    {
        /// <summary>One eye, or none in particular.</summary>
        None,

        /// <summary>Every draw has two instances, whose vertices choose the eye's layer.</summary>
        Instanced,

        /// <summary>Every draw goes to both layers by views.</summary>
        Multiview,
    }

    /// <summary>A mesh to draw, or vertices that the shader makes of their numbers.</summary>
    struct DrawItem
    {
        internal Mesh Mesh;
        internal int SubMesh;

        /// <summary>Without a mesh: how many vertices.</summary>
        internal int VertexCount;

        /// <summary>Without a mesh: what they form.</summary>
        internal MeshTopology Topology;

        /// <summary>0 counts as 1.</summary>
        internal int Instances;
        internal Material Material;
        internal MaterialPropertyBlock Block;
        internal Matrix4x4 ObjectToWorld;
    }

    /// <summary>Makes draws out of meshes and materials, into the present target.</summary>
    static class Drawer
    {
        static readonly PropertySheet s_Object = new();
        static readonly PropertySheet s_ViewValues = new();
        static readonly HashSet<string> s_Keywords = new(StringComparer.Ordinal);
        static ViewSetup s_View = new() { Left = new EyeView(Matrix4x4.identity, Matrix4x4.identity), Width = 1, Height = 1, Near = 0.01f, Far = 100f };
        static bool s_ViewChanged = true;

        /// <summary>The view of all draws that follow.</summary>
        internal static ViewSetup View
        {
            get => s_View;
            set
            {
                s_View = value;
                s_ViewChanged = true;
            }
        }

        internal static StereoDrawing Stereo { get; set; }

        /// <summary>How many draws were made since the start.</summary>
        internal static long DrawCount { get; private set; }

        /// <summary>How many triangles those had, instances counted.</summary>
        internal static long TriangleCount { get; private set; }

        /// <summary>Draws with one pass of the material. Errors are logged once, and nothing is drawn.</summary>
        /// <param name="batched">Whether URP's SRP Batcher draws it.</param>
        /// <returns>Whether it was drawn.</returns>
        internal static bool Draw(in DrawItem item, PassProgram pass, bool batched = false)
        {
            if (DrawTargets.Resolve() is not { } target)
                return false;
            var variant = pass.Variant(Keywords(item.Material), ShaderGlobals.Keywords);
            if (variant == null || !variant.Compile())
                return BuiltinShaders.TryReplace(item, out var replaced, out var error) && Draw(replaced, error);
            if (batched && item.Block is null)
                SrpBatcher.Check(item.Material, variant);
            if (Geometry(item, out var command, out var layout, out var topology) is false)
                return false;
            ViewValues.Write(s_Object, item.ObjectToWorld);
            var source = new DrawSource(item.Material, item.Block, s_Object, ViewSheet());
            if (!Record(target, source, variant, pass.Pass.State, layout, topology, item.ObjectToWorld.determinant < 0, command))
                return false;
            DrawCount++;
            if (topology is MeshTopology.Triangles or MeshTopology.Quads)
                TriangleCount += command.Count / 3 * command.Instances;
            return true;
        }

        internal static void Forget()
        {
            DrawCount = TriangleCount = 0;
            Stereo = StereoDrawing.None;
            s_Object.Clear();
            s_ViewValues.Clear();
            View = new ViewSetup { Left = new EyeView(Matrix4x4.identity, Matrix4x4.identity), Width = 1, Height = 1, Near = 0.01f, Far = 100f };
        }

        static bool Geometry(in DrawItem item, out DrawCommand command, out MeshLayout layout, out MeshTopology topology)
        {
            var instances = (uint)Math.Max(1, item.Instances) * (Stereo == StereoDrawing.Instanced ? 2u : 1u);
            command = new DrawCommand { Instances = instances, Count = (uint)Math.Max(0, item.VertexCount) };
            (layout, topology) = (MeshLayout.None, item.Topology);
            if (item.Mesh is null)
                return command.Count > 0;
            if (item.Mesh.Buffers is not { } mesh || item.SubMesh < 0 || item.SubMesh >= item.Mesh.SubMeshes.Count)
                return false;
            (command.First, command.Count) = mesh.Part(item.SubMesh);
            if (command.Count == 0)
                return false;
            (command.Vertices, command.Indices, command.BaseVertex) = (mesh.Vertices, mesh.Indices, item.Mesh.SubMeshes[item.SubMesh].BaseVertex);
            command.IndexType = mesh.IsWide ? Vk.VK_INDEX_TYPE_UINT32 : Vk.VK_INDEX_TYPE_UINT16;
            (layout, topology) = (mesh.Layout, item.Mesh.SubMeshes[item.SubMesh].Topology);
            return true;
        }

        /// <summary>The view's values, which depend on whether a texture is drawn into.</summary>
        static PropertySheet ViewSheet()
        {
            if (s_ViewChanged || s_View.IntoTexture != DrawTargets.IntoTexture)
            {
                s_View.IntoTexture = DrawTargets.IntoTexture;
                ViewValues.Write(s_ViewValues, s_View);
                LightValues.Write(s_ViewValues);
                s_ViewChanged = false;
            }
            return s_ViewValues;
        }

        static HashSet<string> Keywords(Material material)
        {
            s_Keywords.Clear();
            s_Keywords.UnionWith(material.KeywordSet);
            if (Stereo == StereoDrawing.Instanced)
                s_Keywords.Add(PassSource.Instanced);
            else if (Stereo == StereoDrawing.Multiview)
                s_Keywords.Add(PassSource.Multiview);
            return s_Keywords;
        }

        static bool Record(PassTarget target, in DrawSource source, PassVariant variant, ShaderLabState fixedState, MeshLayout layout, MeshTopology topology,
            bool mirrored, DrawCommand command)
        {
            var context = Gpu.Context;
            var vertex = new DrawBinder(context, source, variant.VertexBindings);
            var fragment = new DrawBinder(context, source, variant.FragmentBindings);
            if (!vertex.ResolveResources() || !fragment.ResolveResources())
                return false;
            if ((vertex.Feedback(target) ?? fragment.Feedback(target)) is { } feedback)
            {
                source.Material.ErrorOnce($"'{feedback}' is read while it is drawn into");
                return false;
            }
            var program = variant.Program(context);
            var state = DrawState.Of(fixedState, source.Float);
            try
            {
                command.Pipeline = program.Pipeline(state, target.Passes[0], layout, topology, Clockwise(mirrored));
                if (target.Passes.Length > 1)
                    command.SecondPipeline = program.Pipeline(state, target.Passes[1], layout, topology, Clockwise(mirrored));
            }
            catch (NotSupportedException e)
            {
                source.Material.ErrorOnce(e.Message);
                return false;
            }
            command.PipelineLayout = program.PipelineLayout;
            // Depth runs from 1 to 0, so what Unity pushes away goes down.
            command.DepthBias = -state.OffsetUnits;
            command.SlopeBias = -state.OffsetFactor;
            command.Scissor = DrawTargets.ToMemory(DrawTargets.Scissor ?? DrawTargets.Viewport);
            command.Viewport = Viewport();
            if (command.Scissor.width == 0 || command.Scissor.height == 0)
                return false;
            if (program.NeedsDefaults(layout))
                command.Defaults = context.DefaultVertex;
            var pass = context.Stream.Pass(target);
            vertex.ResolveConstants();
            fragment.ResolveConstants();
            command.VertexSet = vertex.Write(program.VertexSetLayout, pass);
            command.FragmentSet = fragment.Write(program.FragmentSetLayout, pass);
            Read(context, pass, command.Vertices);
            Read(context, pass, command.Defaults);
            Read(context, pass, command.Indices);
            pass.Add(command);
            return true;
        }

        static void Read(GpuContext context, DrawPass pass, VulkanBuffer buffer)
        {
            if (buffer != null)
                pass.Read(buffer, context.Stream.CurrentSerial);
        }

        /// <summary>Front faces are clockwise for the viewer; a picture that is turned over, or a mirrored object, turns that round.</summary>
        static bool Clockwise(bool mirrored) => !(DrawTargets.IntoTexture ^ mirrored ^ DrawTargets.InvertCulling);

        /// <summary>Direct3D's viewport, whose y points up, which Unity's shaders are written for.</summary>
        static VkViewport Viewport()
        {
            var rect = DrawTargets.Viewport;
            var top = DrawTargets.IntoTexture ? rect.y : DrawTargets.Height - rect.yMax;
            return new VkViewport { x = rect.x, y = top + rect.height, width = rect.width, height = -rect.height, minDepth = 0, maxDepth = 1 };
        }
    }
}
