using System;
using System.Collections.Generic;

namespace UnityEngine.Vulkan
{
    /// <summary>
    /// All work for the device, in the order in which it is asked for. Commands gather in one command buffer until the frame ends or
    /// somebody waits. A barrier is put only where a command touches what an earlier one wrote, or writes what it read.
    /// </summary>
    sealed unsafe class CommandStream : IDisposable
    {
        const int MaxStagingChunks = 4;
        const ulong StagingChunk = 16 << 20;
        const ulong UniformChunk = 256 << 10;

        readonly VulkanDevice m_Device;
        readonly HostArena m_Staging;
        readonly HostArena m_Uniforms;
        readonly Queue<Submission> m_Running = new();
        readonly Stack<Submission> m_Free = new();
        readonly List<(VulkanResource Resource, bool Write)> m_Touched = new();
        readonly List<VkImageMemoryBarrier> m_Transitions = new();
        readonly RenderPassCache m_RenderPasses;
        readonly DrawPass m_Pass;
        Submission m_Open;
        ulong m_LastSerial;
        long m_Epoch;
        bool m_NeedsBarrier;

        internal CommandStream(VulkanDevice device)
        {
            m_Device = device;
            m_RenderPasses = new RenderPassCache(device);
            m_Pass = new DrawPass(device, m_RenderPasses);
            m_Staging = new HostArena(device, StagingChunk, Vk.VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
            m_Uniforms = new HostArena(device, UniformChunk, Vk.VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
        }

        /// <summary>The most bytes that one staging slice can have.</summary>
        internal ulong MaxSlice => StagingChunk;

        /// <summary>The last submission that the device has finished.</summary>
        internal ulong Completed { get; private set; }

        /// <summary>How often somebody waited for work that the device had not done.</summary>
        internal long WaitCount { get; private set; }

        /// <summary>The submission that commands recorded now belong to.</summary>
        internal ulong CurrentSerial => m_Open?.Serial ?? m_LastSerial + 1;

        /// <summary>How often work was handed to the device.</summary>
        internal ulong SubmissionCount => m_LastSerial - (m_Open != null ? 1ul : 0ul);

        Submission Open
        {
            get
            {
                if (m_Open == null)
                {
                    m_Open = m_Free.Count > 0 ? m_Free.Pop() : new Submission(m_Device);
                    m_Open.Begin(++m_LastSerial);
                }
                return m_Open;
            }
        }

        /// <summary>The render pass that draws into a target belong to.</summary>
        internal ulong RenderPass(PassTarget target) => m_RenderPasses.Get(target);

        /// <summary>The pass that gathers draws into a target: the open one if it has the same target.</summary>
        internal DrawPass Pass(PassTarget target)
        {
            if (!target.IsSameAs(m_Pass.Target))
                EndPass();
            if (m_Pass.Target == null)
                m_Pass.Begin(target);
            // What the draws use must live until this submission has run.
            var serial = Open.Serial;
            foreach (var color in target.Colors)
                color.LastUse = serial;
            foreach (var resolve in target.Resolves)
                resolve.LastUse = serial;
            if (target.Depth != null)
                target.Depth.LastUse = serial;
            return m_Pass;
        }

        /// <summary>Records the draws that have gathered, before anything else is recorded.</summary>
        internal void EndPass()
        {
            if (m_Pass.Target != null)
                m_Pass.Record(this, Open);
        }

        /// <summary>Says that the next command reads a buffer.</summary>
        internal void Read(VulkanBuffer buffer) => Touch(buffer, write: false);

        /// <summary>Says that the next command writes a buffer.</summary>
        internal void Write(VulkanBuffer buffer) => Touch(buffer, write: true);

        /// <summary>Says that the next command reads an image in that layout.</summary>
        internal void Read(VulkanImage image, uint layout)
        {
            Touch(image, write: false);
            Transition(image, layout);
        }

        /// <summary>Says that the next command writes an image in that layout.</summary>
        internal void Write(VulkanImage image, uint layout)
        {
            Touch(image, write: true);
            Transition(image, layout);
        }

        /// <summary>Puts the barrier that the announced uses need and returns the command buffer for the command itself.</summary>
        internal nint Command()
        {
            EndPass();
            var open = Open;
            if (m_NeedsBarrier || m_Transitions.Count > 0)
                Barrier(open.Commands);
            foreach (var (resource, write) in m_Touched)
            {
                resource.LastUse = open.Serial;
                if (write)
                    resource.WriteEpoch = m_Epoch;
                else
                    resource.ReadEpoch = m_Epoch;
            }
            m_Touched.Clear();
            return open.Commands;
        }

        /// <summary>Mapped memory to copy from, valid until the current submission has run. Waits when too much is under way.</summary>
        internal HostSlice Staging(ulong size)
        {
            const ulong alignment = 16;
            if (m_Staging.ChunkCount >= MaxStagingChunks && m_Staging.WouldGrow(size, alignment))
            {
                Submit();
                while (m_Staging.WouldGrow(size, alignment) && m_Running.Count > 0)
                    Retire(m_Running.Dequeue(), wait: true);
            }
            return m_Staging.Take(size, alignment, Open.StagingChunks);
        }

        /// <summary>Mapped memory for constants of the next dispatch or draw.</summary>
        internal HostSlice Uniforms(ulong size) =>
            m_Uniforms.Take(size, Math.Max(16, m_Device.Properties.limits.minUniformBufferOffsetAlignment), Open.UniformChunks);

        internal ulong DescriptorSet(ulong layout) => Open.Descriptors.Allocate(layout);

        /// <summary>Frees something as soon as the device cannot use it any more.</summary>
        internal void Release(IDisposable garbage, ulong lastUse)
        {
            if (lastUse <= Completed)
                garbage.Dispose();
            else if (m_Open != null)
                m_Open.Garbage.Add(garbage);
            else
                Newest().Garbage.Add(garbage);
        }

        /// <summary>Hands everything recorded so far to the device, without waiting.</summary>
        internal void Submit()
        {
            if (m_Open == null)
                return;
            EndPass();
            HostBarrier(m_Open.Commands);
            m_Staging.Seal();
            m_Uniforms.Seal();
            m_Open.Submit();
            m_Running.Enqueue(m_Open);
            m_Open = null;
            Poll();
        }

        /// <summary>Waits until a submission has run, handing it in first if need be.</summary>
        internal void Wait(ulong serial)
        {
            if (m_Open != null && serial >= m_Open.Serial)
                Submit();
            if (Completed < serial && m_Running.Count > 0)
                WaitCount++;
            while (Completed < serial && m_Running.Count > 0)
                Retire(m_Running.Dequeue(), wait: true);
        }

        /// <summary>Takes note of what has run meanwhile.</summary>
        internal void Poll()
        {
            while (m_Running.Count > 0 && m_Running.Peek().IsDone())
                Retire(m_Running.Dequeue(), wait: false);
        }

        public void Dispose()
        {
            Submit();
            while (m_Running.Count > 0)
                Retire(m_Running.Dequeue(), wait: true);
            foreach (var submission in m_Free)
                submission.Dispose();
            m_Free.Clear();
            m_Staging.Dispose();
            m_Uniforms.Dispose();
            m_RenderPasses.Dispose();
        }

        Submission Newest()
        {
            Submission newest = null;
            foreach (var submission in m_Running)
                newest = submission;
            return newest;
        }

        void Retire(Submission submission, bool wait)
        {
            if (wait)
                submission.Wait();
            Completed = submission.Serial;
            m_Staging.Return(submission.StagingChunks);
            m_Uniforms.Return(submission.UniformChunks);
            submission.Recycle();
            m_Free.Push(submission);
        }

        void Touch(VulkanResource resource, bool write)
        {
            EndPass();
            if (resource.WriteEpoch == m_Epoch || (write && resource.ReadEpoch == m_Epoch))
                m_NeedsBarrier = true;
            m_Touched.Add((resource, write));
        }

        void Transition(VulkanImage image, uint layout)
        {
            if (image.Layout == layout)
                return;
            m_Transitions.Add(new VkImageMemoryBarrier
            {
                sType = Vk.VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER,
                srcAccessMask = Vk.VK_ACCESS_MEMORY_WRITE_BIT,
                dstAccessMask = Vk.VK_ACCESS_MEMORY_READ_BIT | Vk.VK_ACCESS_MEMORY_WRITE_BIT,
                oldLayout = image.Layout,
                newLayout = layout,
                srcQueueFamilyIndex = Vk.VK_QUEUE_FAMILY_IGNORED,
                dstQueueFamilyIndex = Vk.VK_QUEUE_FAMILY_IGNORED,
                image = image.Handle,
                subresourceRange = image.Whole,
            });
            image.Layout = layout;
        }

        void Barrier(nint commands)
        {
            var memory = new VkMemoryBarrier
            {
                sType = Vk.VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                srcAccessMask = Vk.VK_ACCESS_MEMORY_WRITE_BIT,
                dstAccessMask = Vk.VK_ACCESS_MEMORY_READ_BIT | Vk.VK_ACCESS_MEMORY_WRITE_BIT,
            };
            var transitions = m_Transitions.ToArray();
            fixed (VkImageMemoryBarrier* images = transitions)
            {
                m_Device.Api.vkCmdPipelineBarrier(commands, Vk.VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, Vk.VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                    0, 1, &memory, 0, null, (uint)transitions.Length, images);
            }
            m_Transitions.Clear();
            m_NeedsBarrier = false;
            m_Epoch++;
        }

        void HostBarrier(nint commands)
        {
            var memory = new VkMemoryBarrier
            {
                sType = Vk.VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                srcAccessMask = Vk.VK_ACCESS_MEMORY_WRITE_BIT,
                dstAccessMask = Vk.VK_ACCESS_HOST_READ_BIT,
            };
            m_Device.Api.vkCmdPipelineBarrier(commands, Vk.VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, Vk.VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &memory, 0, null, 0, null);
        }
    }
}
