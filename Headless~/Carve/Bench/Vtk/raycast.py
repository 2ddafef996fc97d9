"""VTK's volume ray casters on an opacity field, for `carve bench all` (P31).

    raycast.py SETTINGS.json

The settings name a raw field of bytes (opacity per voxel, 255 = 1), its size, the camera in voxels, and the picture's size. A first line of JSON says which VTK
this is. Then each line on stdin asks for something, answered by a line of JSON: "fixed" or "gpu" for a picture by that mapper (the milliseconds), "lit fixed" or
"lit gpu" for the share of pixels that show something. The camera turns by a hair each time, so that no picture is taken from a cache.
"""
import json
import sys
import time

import numpy
import vtk
from vtk.util import numpy_support


def make_image(settings):
    field = numpy.fromfile(settings["field"], dtype=numpy.uint8)
    image = vtk.vtkImageData()
    image.SetDimensions(*settings["dims"])
    image.SetSpacing(*settings["spacing"])
    image.GetPointData().SetScalars(numpy_support.numpy_to_vtk(field, deep=True))
    return image


def make_property(settings):
    looks = vtk.vtkVolumeProperty()
    opacity = vtk.vtkPiecewiseFunction()
    opacity.AddPoint(0, 0)
    opacity.AddPoint(255, 1)
    color = vtk.vtkColorTransferFunction()
    color.AddRGBPoint(0, 0.83, 0.69, 0.59)
    color.AddRGBPoint(255, 0.83, 0.69, 0.59)
    looks.SetScalarOpacity(opacity)
    looks.SetColor(color)
    looks.SetScalarOpacityUnitDistance(settings["unit"])
    looks.SetInterpolationTypeToLinear()
    looks.ShadeOn()
    return looks


def make_mapper(name, settings, image):
    if name == "fixed":
        mapper = vtk.vtkFixedPointVolumeRayCastMapper()
        mapper.SetNumberOfThreads(settings["threads"])
        mapper.SetImageSampleDistance(1.0)
        mapper.SetMinimumImageSampleDistance(1.0)
        mapper.SetMaximumImageSampleDistance(1.0)
        mapper.SetInteractiveSampleDistance(settings["step"])
    else:
        mapper = vtk.vtkGPUVolumeRayCastMapper()
        mapper.SetUseJittering(0)
        mapper.SetImageSampleDistance(1.0)
    mapper.SetAutoAdjustSampleDistances(0)
    mapper.SetSampleDistance(settings["step"])
    mapper.SetInputData(image)
    return mapper


class View:
    def __init__(self, name, settings, image):
        volume = vtk.vtkVolume()
        volume.SetMapper(make_mapper(name, settings, image))
        volume.SetProperty(make_property(settings))
        renderer = vtk.vtkRenderer()
        renderer.AddVolume(volume)
        camera = renderer.GetActiveCamera()
        camera.SetPosition(*settings["eye"])
        camera.SetFocalPoint(*settings["target"])
        camera.SetViewUp(*settings["up"])
        camera.SetViewAngle(settings["fov"])
        renderer.ResetCameraClippingRange()
        self.camera = camera
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(settings["size"], settings["size"])
        self.window.AddRenderer(renderer)

    def render(self):
        self.camera.Azimuth(1e-4)
        pixel = vtk.vtkUnsignedCharArray()
        begun = time.perf_counter()
        self.window.Render()
        self.window.GetRGBACharPixelData(0, 0, 0, 0, 0, pixel)  # waits until the picture is there
        return 1000 * (time.perf_counter() - begun)

    def lit_share(self):
        width, height = self.window.GetSize()
        pixels = vtk.vtkUnsignedCharArray()
        self.window.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels)
        colors = numpy_support.vtk_to_numpy(pixels).reshape(-1, 4)[:, :3]
        return float((colors.max(axis=1) > 8).mean())


def main():
    vtk.vtkObject.GlobalWarningDisplayOff()
    with open(sys.argv[1], encoding="utf-8") as file:
        settings = json.load(file)
    image = make_image(settings)
    views = {}
    print(json.dumps({"vtk": vtk.vtkVersion().GetVTKVersion()}), flush=True)
    for line in sys.stdin:
        *asked, name = line.split()
        if asked:
            print(json.dumps({"lit": views[name].lit_share()}), flush=True)
            continue
        if name not in views:
            views[name] = View(name, settings, image)
        print(json.dumps({"ms": views[name].render()}), flush=True)


main()
