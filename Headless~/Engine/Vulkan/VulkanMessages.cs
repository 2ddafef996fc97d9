using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace UnityEngine.Vulkan
{
    /// <summary>Collects what the validation layer says. Drivers call from any thread, so the messages wait here until they are drained.</summary>
    sealed unsafe class VulkanMessages
    {
        readonly List<string> m_Waiting = new();
        readonly Callback m_Callback;
        readonly nint m_Pointer;

        internal VulkanMessages()
        {
            m_Callback = OnMessage;
            m_Pointer = Marshal.GetFunctionPointerForDelegate(m_Callback);
        }

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        delegate uint Callback(uint severity, uint type, VkDebugUtilsMessengerCallbackDataEXT* data, void* user);

        /// <summary>How many messages there were since the device was made.</summary>
        internal int Count { get; private set; }

        internal VkDebugUtilsMessengerCreateInfoEXT CreateInfo() => new()
        {
            sType = Vk.VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
            messageSeverity = Vk.VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | Vk.VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
            messageType = Vk.VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT | Vk.VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT,
            pfnUserCallback = m_Pointer,
        };

        /// <summary>Logs all waiting messages as errors.</summary>
        internal void Drain()
        {
            string[] messages;
            lock (m_Waiting)
            {
                if (m_Waiting.Count == 0)
                    return;
                messages = m_Waiting.ToArray();
                m_Waiting.Clear();
            }
            foreach (var message in messages)
                Debug.LogError(message);
        }

        uint OnMessage(uint severity, uint type, VkDebugUtilsMessengerCallbackDataEXT* data, void* user)
        {
            var kind = (type & Vk.VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT) != 0 ? "Vulkan validation: " : "Vulkan: ";
            var isError = (severity & Vk.VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT) != 0;
            // The loader warns of drivers that do not fit this machine; that is no fault of a caller.
            if ((type & Vk.VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT) == 0 && !isError)
                return 0;
            // A colour without a target is dropped, as everywhere; shaders that draw depth alone may have one.
            var text = NativeText.Read(data->pMessage);
            if (!isError && text.Contains("Shader-OutputNotConsumed", StringComparison.Ordinal))
                return 0;
            lock (m_Waiting)
            {
                m_Waiting.Add(kind + text);
                Count++;
            }
            return 0;
        }
    }
}
