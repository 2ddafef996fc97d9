namespace UnityEngine
{
    /// <summary>Shows the mesh of the MeshFilter beside it.</summary>
    public class MeshRenderer : Renderer
    {
        public MeshRenderer()
        {
        }

        internal override Mesh MeshFor(Camera camera) => Filter is { } filter && filter.sharedMesh != null ? filter.sharedMesh : null;

        internal override Bounds OwnBounds => MeshFor(null) is { } mesh ? mesh.bounds : default;

        MeshFilter Filter
        {
            get
            {
                foreach (var component in Owner.Components)
                    if (component is MeshFilter filter)
                        return filter;
                return null;
            }
        }
    }
}
