using UnityEngine;

namespace AnatomyCarve
{
    /// <summary>What takes a shader's values by property id: a kernel or a material.</summary>
    interface IShaderValues
    {
        void SetVector(int id, Vector4 value);

        void SetTexture(int id, Texture texture);
    }
}
