using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Text;
using System.Threading;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Networking;
using AnatomyCarve.Headless.Tests.Objects;
using Object = UnityEngine.Object;

namespace AnatomyCarve.Headless.Tests.Hosting
{
    /// <summary>Files by their addresses: on the disk, and inside an Android application's package.</summary>
    public sealed class WebRequestTests
    {
        string m_Folder;
        UnityHost m_Host;

        [SetUp]
        public void MakeFiles()
        {
            m_Folder = Directory.CreateTempSubdirectory("anatomycarve-web-").FullName;
            File.WriteAllText(Path.Combine(m_Folder, "a file.txt"), "on the disk");
            using (var package = ZipFile.Open(Path.Combine(m_Folder, "base.apk"), ZipArchiveMode.Create))
            using (var entry = package.CreateEntry("assets/scans/head.bin").Open())
                entry.Write(Encoding.UTF8.GetBytes("in the package"));
        }

        [TearDown]
        public void RemoveFiles()
        {
            m_Host?.Dispose();
            Directory.Delete(m_Folder, true);
        }

        string Jar => $"jar:file://{m_Folder}/base.apk!/assets";

        void Start(string streamingAssets = null) => m_Host = UnityHost.Start(new HostOptions { StreamingAssets = streamingAssets, Log = (_, _, _) => { } });

        void Finish(UnityWebRequest request)
        {
            for (var frame = 0; frame < 10000 && !request.isDone; frame++)
            {
                m_Host.Step();
                Thread.Sleep(1);
            }

            Assert.That(request.isDone, Is.True);
        }

        [Test]
        public void StreamingAssets_InAPackage_AreReadByAddress()
        {
            Start(Jar);
            Assert.That(Application.streamingAssetsPath, Is.EqualTo(Jar));
            using var request = UnityWebRequest.Get(Application.streamingAssetsPath + "/scans/head.bin");
            request.SendWebRequest();
            Finish(request);
            Assert.That((request.result, request.downloadHandler.text, request.error, request.responseCode, request.downloadProgress),
                Is.EqualTo((UnityWebRequest.Result.Success, "in the package", (string)null, 200L, 1f)));
        }

        [Test]
        public void StreamingAssets_InAFolder_AreThatFolder()
        {
            Start(m_Folder);
            Assert.That(Application.streamingAssetsPath, Is.EqualTo(m_Folder));
        }

        [TestCase("/a file.txt")]
        [TestCase("/a%20file.txt")]
        public void File_OnTheDisk_IsRead(string path)
        {
            Start();
            using var request = UnityWebRequest.Get("file://" + m_Folder + path);
            request.SendWebRequest();
            Finish(request);
            Assert.That((request.downloadHandler.text, request.downloadedBytes), Is.EqualTo(("on the disk", 11ul)));
        }

        [Test]
        public void Request_IsDoneWithALaterFrame_OnTheMainThread()
        {
            Start();
            using var request = UnityWebRequest.Get(Jar + "/scans/head.bin");
            Assert.That((request.downloadProgress, request.result), Is.EqualTo((-1f, UnityWebRequest.Result.InProgress)));
            var calls = new List<bool>();
            var operation = request.SendWebRequest();
            operation.completed += o => calls.Add(o == operation && Thread.CurrentThread == m_Main);
            Thread.Sleep(100);
            Assert.That((request.isDone, calls.Count, request.result), Is.EqualTo((false, 0, UnityWebRequest.Result.InProgress)));
            m_Host.Step();
            Assert.That((request.isDone, calls), Is.EqualTo((true, new List<bool> { true })));
            operation.completed += _ => calls.Add(false);
            Assert.That(calls, Has.Count.EqualTo(2), "a listener that comes later is called at once");
        }

        readonly Thread m_Main = Thread.CurrentThread;

        [Test]
        public void Request_IsAwaitedByACoroutine()
        {
            Start();
            using var request = UnityWebRequest.Get(Jar + "/scans/head.bin");
            var text = "";
            var runner = new GameObject("runner").AddComponent<Recorder>();
            IEnumerator Wait()
            {
                yield return request.SendWebRequest();
                text = request.downloadHandler.text;
            }

            runner.StartCoroutine(Wait());
            Finish(request);
            Assert.That(text, Is.EqualTo("in the package"), "in the frame that ends the request");
            Object.DestroyImmediate(runner.gameObject);
        }

        [Test]
        public void File_OfAHandler_GetsTheData()
        {
            Start();
            var target = Path.Combine(m_Folder, "new folder", "head.bin");
            using var request = new UnityWebRequest(Jar + "/scans/head.bin") { downloadHandler = new DownloadHandlerFile(target) };
            request.SendWebRequest();
            Finish(request);
            Assert.That(File.ReadAllText(target), Is.EqualTo("in the package"));
            Assert.That(() => request.downloadHandler.data, Throws.TypeOf<NotSupportedException>());
        }

        [Test]
        public void Missing_InAPackage_IsNotFound()
        {
            Start();
            using var request = UnityWebRequest.Get(Jar + "/scans/tail.bin");
            request.SendWebRequest();
            Finish(request);
            Assert.That((request.result, request.responseCode, request.error),
                Is.EqualTo((UnityWebRequest.Result.ProtocolError, 404L, "HTTP/1.1 404 Not Found")));
        }

        [TestCase("file:///nowhere/at/all.txt")]
        [TestCase("jar:file:///nowhere/base.apk!/assets/x")]
        [TestCase("https://example.com/x")]
        [TestCase("/a/path")]
        public void Address_ThatLeadsNowhere_IsAnError(string url)
        {
            Start();
            using var request = UnityWebRequest.Get(url);
            request.SendWebRequest();
            Finish(request);
            Assert.That(request.result, Is.EqualTo(UnityWebRequest.Result.ConnectionError));
            Assert.That(request.error, Does.StartWith("Cannot open file"));
        }

        [Test]
        public void Abort_LeavesNoFileIfAsked()
        {
            Start();
            var target = Path.Combine(m_Folder, "aborted.bin");
            using var request = new UnityWebRequest(Jar + "/scans/head.bin") { downloadHandler = new DownloadHandlerFile(target) { removeFileOnAbort = true } };
            request.Abort();
            request.SendWebRequest();
            Finish(request);
            Assert.That((request.result, request.error, File.Exists(target)), Is.EqualTo((UnityWebRequest.Result.ConnectionError, "Request aborted", false)));
        }

        [Test]
        public void Request_SentTwice_IsRefused()
        {
            Start();
            using var request = UnityWebRequest.Get(Jar + "/scans/head.bin");
            request.SendWebRequest();
            Assert.That(() => request.SendWebRequest(), Throws.InvalidOperationException);
            Finish(request);
        }

        [Test]
        public void Dispose_WhileItRuns_EndsIt()
        {
            Start();
            var target = Path.Combine(m_Folder, "head.bin");
            var request = new UnityWebRequest(Jar + "/scans/head.bin") { downloadHandler = new DownloadHandlerFile(target) };
            request.SendWebRequest();
            request.Dispose();
            Assert.That(() => File.Delete(target), Throws.Nothing, "nobody holds the file");
            Assert.That(() => request.SendWebRequest(), Throws.InvalidOperationException);
        }
    }
}
