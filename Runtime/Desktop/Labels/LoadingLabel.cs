using System;
using AnatomyCarve.Volumes;
using UnityEngine;
using UnityEngine.UI;

namespace AnatomyCarve.Desktop
{
    /// <summary>Shows in the Text on its GameObject how far a volume is loaded, and why it could not be; nothing once it is there.</summary>
    [AddComponentMenu("AnatomyCarve/Loading Label")]
    [RequireComponent(typeof(Text))]
    [DisallowMultipleComponent]
    [ManualPage("components")]
    public sealed class LoadingLabel : MonoBehaviour
    {
        const int NotLoading = -1, Unknown = -2;

        [SerializeField, Tooltip("What loads; empty = the one on this GameObject")]
        VolumeLoader loader;

        Text text;
        VolumeLoader shown;
        string failure = "";
        int shownPercent;

        /// <summary>What loads: the one that was set, or else the one on this GameObject. Taken when the component is enabled.</summary>
        public VolumeLoader Loader
        {
            get => this.WiredOrSibling(loader);
            set => loader = value;
        }

        void OnEnable()
        {
            text = GetComponent<Text>();
            text.text = failure = "";
            shownPercent = Unknown;
            shown = Loader;
            if (shown == null)
                return;
            shown.Failed += OnFailed;
            shown.Loaded += OnLoaded;
        }

        void Start() => enabled = this.Has(Loader, nameof(Loader));

        void OnDisable()
        {
            if (shown != null)
            {
                shown.Failed -= OnFailed;
                shown.Loaded -= OnLoaded;
            }
            shown = null;
            text.text = "";
        }

        void Update()
        {
            int percent = shown != null && shown.IsLoading ? Mathf.RoundToInt(100f * shown.Progress) : NotLoading;
            if (percent == shownPercent)
                return;
            shownPercent = percent;
            text.text = percent == NotLoading ? failure : $"Loading the volume: {percent} %";
        }

        void OnFailed(Exception reason) => Tell(reason.Message);

        void OnLoaded(SegmentedVolume volume) => Tell("");

        void Tell(string message)
        {
            failure = message;
            shownPercent = Unknown;
        }
    }
}
