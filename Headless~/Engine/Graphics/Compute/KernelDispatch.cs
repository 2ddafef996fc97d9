using UnityEngine.Shaders;
using UnityEngine.Vulkan;

namespace UnityEngine
{
    /// <summary>Checks a dispatch as Unity does, binds what it needs and records it.</summary>
    static unsafe class KernelDispatch
    {
        const int MaxGroups = 65535;

        internal static void Run(ComputeShader shader, int kernel, KernelVariant variant, int x, int y, int z)
        {
            if (x <= 0 || y <= 0 || z <= 0)
            {
                Debug.LogError($"Thread group count must be above zero. Compute shader ({shader.NameForMessages}), kernel index ({kernel}): {x} x {y} x {z}");
                return;
            }
            if (x > MaxGroups || y > MaxGroups || z > MaxGroups)
            {
                Debug.LogError($"Thread group count is above the maximum allowed limit. Maximum allowed thread group count is {MaxGroups}. Compute shader "
                    + $"({shader.NameForMessages}), kernel index ({kernel}): {x} x {y} x {z}");
                return;
            }
            var context = Gpu.Context;
            if (Prepare(context, shader, kernel, variant, null) is not { } commands)
                return;
            context.Device.Api.vkCmdDispatch(commands, (uint)x, (uint)y, (uint)z);
            context.DispatchCount++;
        }

        internal static void RunIndirect(ComputeShader shader, int kernel, KernelVariant variant, GpuBuffer arguments, uint offset)
        {
            if ((arguments.Target & GraphicsBuffer.Target.IndirectArguments) == 0 || offset % 4 != 0 || offset + 12 > arguments.Size)
            {
                Debug.LogError($"DispatchIndirect: the buffer needs the target IndirectArguments and 12 bytes at a multiple of 4; offset {offset} of "
                    + $"{arguments.Size} bytes. Compute shader ({shader.NameForMessages})");
                return;
            }
            var context = Gpu.Context;
            if (Prepare(context, shader, kernel, variant, arguments) is not { } commands)
                return;
            context.Device.Api.vkCmdDispatchIndirect(commands, arguments.Storage.Handle, offset);
            context.DispatchCount++;
        }

        static nint? Prepare(GpuContext context, ComputeShader shader, int kernel, KernelVariant variant, GpuBuffer arguments)
        {
            var binder = new KernelBinder(context, shader, kernel, variant.Layout);
            if (!binder.Resolve())
                return null;
            var program = variant.Program(context);
            var set = context.Stream.DescriptorSet(program.SetLayout);
            binder.Write(set);
            if (arguments != null)
                context.Stream.Read(arguments.Storage);
            var commands = context.Stream.Command();
            context.Device.Api.vkCmdBindPipeline(commands, Vk.VK_PIPELINE_BIND_POINT_COMPUTE, program.Pipeline);
            context.Device.Api.vkCmdBindDescriptorSets(commands, Vk.VK_PIPELINE_BIND_POINT_COMPUTE, program.PipelineLayout, 0, 1, &set, 0, null);
            return commands;
        }
    }
}
