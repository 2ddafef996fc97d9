using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using AnatomyCarve.Headless.Tests.CommandLine;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Shaders;

namespace AnatomyCarve.Headless.Tests.Routes
{
    /// <summary>Every variant of every kernel of the package by both routes: it compiles, makes a pipeline, and lays out the same resources alike.</summary>
    sealed class KernelLayoutTests
    {
        static IEnumerable<string> Files()
        {
            string folder = Path.Combine(RepositoryFiles.Root, "Shaders");
            return Directory.GetFiles(folder, "*.compute").Select(Path.GetFileName).OrderBy(name => name, StringComparer.Ordinal);
        }

        [TestCaseSource(nameof(Files))]
        public void Variants_ByBothRoutes_HaveTheSameLayout(string file)
        {
            var messages = new List<string>();
            using UnityHost host = UnityHost.Start(new HostOptions { Log = (_, message, _) => messages.Add(message) });
            ComputeSource source = ComputeSource.Load(Path.Combine(host.PackageRoot, "Shaders", file));
            int variants = 0;
            foreach (KernelPragma kernel in source.Kernels)
                foreach (List<string> keywords in Variants(source))
                {
                    List<string> defines = kernel.Defines.Concat(keywords.Select(k => k + "=1")).ToList();
                    variants++;
                    string subject = $"{kernel.Name} [{string.Join(" ", keywords)}]";
                    Assert.That(Layout(source, kernel, defines, KernelRoute.Fxc), Is.EqualTo(Layout(source, kernel, defines, KernelRoute.Glslang)), subject);
                }
            Assert.That(variants, Is.Positive);
            Assert.That(messages, Is.Empty, "what the validation layer says of pipelines");
        }

        /// <summary>One line for each fact: group size, resources, constants.</summary>
        static List<string> Layout(ComputeSource source, KernelPragma kernel, List<string> defines, KernelRoute route)
        {
            GpuOptions.KernelRoute = route;
            try
            {
                KernelCode code = KernelCode.Compile(source, kernel.Name, defines);
                using (new KernelProgram(Gpu.Context, code))
                    return Describe(code.Layout).OrderBy(line => line, StringComparer.Ordinal).ToList();
            }
            finally
            {
                GpuOptions.KernelRoute = KernelRoute.Glslang;
            }
        }

        static IEnumerable<string> Describe(KernelLayout layout)
        {
            yield return $"numthreads {layout.GroupX} {layout.GroupY} {layout.GroupZ}";
            foreach (KernelBinding binding in layout.Bindings)
            {
                yield return binding.Name + ": " + binding.Kind switch
                {
                    BindingKind.ConstantBuffer => $"constants, {binding.Size} bytes",
                    BindingKind.Sampler => "sampler",
                    BindingKind.RandomWriteBuffer => $"random-write buffer, stride {binding.Stride}",
                    BindingKind.Buffer or BindingKind.TexelBuffer => $"buffer, stride {binding.Stride}",
                    _ => $"{binding.Kind} {binding.Dimension} of {binding.Number}",
                };
                foreach (ConstantMember member in binding.Members ?? [])
                    yield return $"{binding.Name}.{member.Name}: {member.Number} at {member.Offset}, {member.Size} bytes";
            }
        }

        /// <summary>Every choice of one keyword of each set, or none where the set has it.</summary>
        static IEnumerable<List<string>> Variants(ComputeSource source)
        {
            IEnumerable<List<string>> variants = [[]];
            foreach (KeywordSet set in source.KeywordSets)
                variants = variants.SelectMany(v => set.Keywords.Select(k => KeywordSet.IsNone(k) ? v : v.Append(k).ToList())).ToList();
            return variants;
        }
    }
}
