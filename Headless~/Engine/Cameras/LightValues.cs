using UnityEngine.Shaders;

namespace UnityEngine
{
    /// <summary>The main light and the ambient one, by the names of both pipelines.</summary>
    static class LightValues
    {
        static readonly int s_Position = Shader.PropertyToID("_WorldSpaceLightPos0"), s_Color = Shader.PropertyToID("_LightColor0"),
            s_MainPosition = Shader.PropertyToID("_MainLightPosition"), s_MainColor = Shader.PropertyToID("_MainLightColor"),
            s_Ambient = Shader.PropertyToID("unity_AmbientSky"), s_LightModel = Shader.PropertyToID("glstate_lightmodel_ambient"),
            s_RedProbe = Shader.PropertyToID("unity_SHAr"), s_GreenProbe = Shader.PropertyToID("unity_SHAg"), s_BlueProbe = Shader.PropertyToID("unity_SHAb");

        internal static void Write(PropertySheet sheet)
        {
            var light = Light.Main;
            // Directions point to the light. Without one it stands above and gives nothing.
            var direction = light is null ? Vector3.up : -light.transform.forward;
            var color = light is null ? Color.clear : ColorSpaces.ToShader(light.color) * light.intensity;
            Set(sheet, s_Position, new Vector4(direction.x, direction.y, direction.z, 0));
            Set(sheet, s_MainPosition, new Vector4(direction.x, direction.y, direction.z, 0));
            Set(sheet, s_Color, color);
            Set(sheet, s_MainColor, color);
            var ambient = ColorSpaces.ToShader(RenderSettings.ambientLight);
            Set(sheet, s_Ambient, ambient);
            Set(sheet, s_LightModel, ambient);
            // The same from all directions.
            Set(sheet, s_RedProbe, new Vector4(0, 0, 0, ambient.r));
            Set(sheet, s_GreenProbe, new Vector4(0, 0, 0, ambient.g));
            Set(sheet, s_BlueProbe, new Vector4(0, 0, 0, ambient.b));
        }

        static void Set(PropertySheet sheet, int name, Vector4 value) => sheet.Set(name, value, NumberKind.Float);
    }
}
