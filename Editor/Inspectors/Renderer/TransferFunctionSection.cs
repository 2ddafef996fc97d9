using System;
using AnatomyCarve.Formats;
using AnatomyCarve.Volumes;
using UnityEditor;
using UnityEngine;

namespace AnatomyCarve.Editor
{
    /// <summary>The transfer function: a menu of presets, the plot, the numbers of the selected point.</summary>
    sealed class TransferFunctionSection : IDisposable
    {
        const double Margin = 0.03;

        static readonly GUIContent Value = new GUIContent("Value", "Intensity of the selected point, in the scan's unit (Hounsfield units for CT)");
        static readonly GUIContent Opacity = new GUIContent("Opacity", "Opacity of a path of one reference length, the smallest voxel spacing: 0 to 1");
        static readonly GUIContent FitView = new GUIContent("Fit", "Shows all values of the scan (F)");
        static readonly GUIContent Label = new GUIContent("Function", "Automatic: chosen from each volume's intensities");

        const string Help = "Drag a point. Double click adds one, right click or Delete removes it, arrows nudge it.\n"
            + "Ctrl + wheel zooms, the middle button pans.";

        readonly SerializedObject serializedObject;
        readonly AppearanceProperty appearance;
        readonly TransferPoints points = new TransferPoints();
        readonly TransferFunctionField field = new TransferFunctionField();
        readonly Background<SegmentedVolume, IntensityHistogram> histograms = new Background<SegmentedVolume, IntensityHistogram>(IntensityHistogramOf);
        readonly GUIContent name = new GUIContent();
        OpacityTransferFunction shown, named;
        string nameOfNamed;

        public TransferFunctionSection(SerializedObject serializedObject, AppearanceProperty appearance)
        {
            this.serializedObject = serializedObject;
            this.appearance = appearance;
        }

        /// <summary>Whether the histogram is on its way.</summary>
        public bool IsBusy => histograms.IsBusy;

        public void Draw(CarvedVolumeRenderer renderer)
        {
            if (serializedObject.isEditingMultipleObjects)
            {
                DrawMenu(appearance.HasMixedFunctions ? "-" : TransferFunctionNames.Of(renderer.Appearance.TransferFunction));
                return;
            }
            DrawMenu(NameOf(renderer.Appearance.TransferFunction));
            OpacityTransferFunction function = renderer.TransferFunction;
            if (function == null)
            {
                EditorGUILayout.HelpBox("The function is chosen from the volume's intensities as soon as one is loaded.", MessageType.None);
                return;
            }
            if (function != shown)
                points.Set(shown = function);
            IntensityHistogram histogram = histograms.Of(renderer.Volume);
            SetRange(renderer.Volume);
            if (field.Draw(points, histogram) | DrawPoint())
                appearance.SetFunction(points.Points);
        }

        public void Dispose() => field.Dispose();

        void SetRange(SegmentedVolume volume)
        {
            ValueWindow ofPoints = new ValueWindow(points[0].Value, points[points.Count - 1].Value).WithMargin(Margin);
            ValueWindow data = volume == null ? ofPoints : new ValueWindow(volume.Intensity.ValueMin, volume.Intensity.ValueMax).WithMargin(Margin);
            field.SetRange(volume, data, ofPoints);
        }

        void DrawMenu(string current)
        {
            Rect whole = EditorGUILayout.GetControlRect();
            Rect rect = EditorGUI.PrefixLabel(whole, EditorGUI.BeginProperty(whole, Label, appearance.Points));
            name.text = current;
            var fit = new Rect(rect.xMax - 40f, rect.y, 40f, rect.height);
            rect.width -= fit.width + 4f;
            if (EditorGUI.DropdownButton(rect, name, FocusType.Keyboard))
                ShowMenu(rect, current);
            if (GUI.Button(fit, FitView, EditorStyles.miniButton))
                field.Fit();
            EditorGUI.EndProperty();
        }

        void ShowMenu(Rect below, string current)
        {
            var menu = new GenericMenu();
            menu.AddItem(new GUIContent(TransferFunctionNames.Automatic), current == TransferFunctionNames.Automatic, () => Change(appearance.SetAutomatic));
            menu.AddSeparator("");
            foreach (string preset in TransferFunctionPresets.Names)
                menu.AddItem(new GUIContent(preset), current == preset, () => Take(TransferFunctionPresets.Named(preset)));
            menu.AddSeparator("");
            menu.AddItem(new GUIContent("Load .vp file..."), false, Load);
            menu.DropDown(below);
        }

        void Load()
        {
            string path = EditorUtility.OpenFilePanel("Load a transfer function (3D Slicer's volume property)", "", "vp");
            if (string.IsNullOrEmpty(path))
                return;
            try
            {
                Take(TransferFunctionFile.Read(path));
            }
            catch (VolumeFormatException problem)
            {
                EditorUtility.DisplayDialog("The transfer function could not be loaded", problem.Message, "OK");
            }
        }

        void Take(OpacityTransferFunction function)
        {
            field.Selected = -1;
            field.Fit();
            Change(() => appearance.SetFunction(function.Points));
        }

        /// <summary>Menus call back after the Inspector was drawn.</summary>
        void Change(Action edit)
        {
            serializedObject.Update();
            edit();
            serializedObject.ApplyModifiedProperties();
            EditorViews.Refresh();
        }

        bool DrawPoint()
        {
            int selected = field.Selected;
            if (selected < 0)
            {
                GUILayout.Label(Help, EditorStyles.wordWrappedMiniLabel);
                return false;
            }
            EditorGUI.BeginChangeCheck();
            float value = EditorGUILayout.DelayedFloatField(Value, (float)points[selected].Value);
            float opacity = EditorGUILayout.DelayedFloatField(Opacity, (float)points[selected].Opacity);
            if (!EditorGUI.EndChangeCheck())
                return false;
            field.Selected = points.Place(selected, value, opacity);
            return true;
        }

        string NameOf(OpacityTransferFunction function)
        {
            if (nameOfNamed == null || function != named)
                nameOfNamed = TransferFunctionNames.Of(named = function);
            return nameOfNamed;
        }

        static IntensityHistogram IntensityHistogramOf(SegmentedVolume volume) => volume.Histogram;
    }
}
