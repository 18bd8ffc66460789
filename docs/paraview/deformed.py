#!/usr/bin/env python3
"""Picture of a run: the deformed bodies, coloured by a field, with a scale, as PNG.

pvpython deformed.py DIR, or python3 deformed.py DIR where VTK is installed (Debian package python3-vtk9). Written for
VTK alone, which ParaView brings along. On a machine without display: xvfb-run -a python3 deformed.py DIR
"""

import argparse
import math
import os
import pathlib
import sys
import xml.etree.ElementTree

import vtkmodules.vtkInteractionStyle  # noqa: F401  (registers itself with the window)
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkFiltersCore import vtkFeatureEdges, vtkPolyDataNormals
from vtkmodules.vtkFiltersGeneral import vtkWarpVector
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (vtkActor, vtkColorTransferFunction, vtkPolyDataMapper, vtkRenderer,
                                         vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter)

# Title and dimension of the fields of one component.
FIELDS = {"von_mises": ("von Mises stress", "stress"), "contact_pressure": ("contact pressure", "stress"),
          "creep_strain_equivalent": ("equivalent creep strain", ""), "temperature": ("temperature", "temperature"),
          "damage": ("damage", ""), "life_fraction": ("life used up", ""), "gap": ("gap", "length")}
UNITS = {"stress": "Pa kPa MPa GPa bar psi ksi N/mm2 N/mm^2 N/m2".split(), "length": "mm m cm um in ft".split(),
         "temperature": "degC K C degF F".split(), "time": "s ms min h hr d a yr hours days years".split()}
VIRIDIS = ((0.267, 0.005, 0.329), (0.229, 0.322, 0.546), (0.128, 0.567, 0.551), (0.369, 0.789, 0.383),
           (0.993, 0.906, 0.144))
SHARE = 0.05  # of the model's diagonal: how long the largest displacement is drawn
ROOM = ((0.03, 0.8), (0.09, 0.96))  # of the window for the bodies: left of the scale, above the caption


def output(algorithm, data):
    algorithm.SetInputData(data)
    algorithm.Update()
    return algorithm.GetOutput()


def entry(collection, time):
    """(time, file) of the output nearest to `time`, or of the last one."""
    if not collection.is_file():
        sys.exit(f"error: {collection}: no such file; give the output directory of a run with fields"
                 + (" and contact" if collection.stem == "contact" else ""))
    listed = [(float(data.get("timestep")), collection.parent / data.get("file"))
              for data in xml.etree.ElementTree.parse(collection).getroot().iter("DataSet")]
    return listed[-1] if time is None else min(listed, key=lambda one: abs(one[0] - time))


def unit(grid, dimension):
    """The unit of a dimension, if the configuration named one: "mm, N, MPa, h" has MPa for stress."""
    units = grid.GetFieldData().GetAbstractArray("units")  # its components are named by the units
    names = [units.GetComponentName(i) or "" for i in range(units.GetNumberOfComponents())] if units else []
    words = " ".join(names).replace(",", " ").replace(";", " ").split()
    return next((word for word in words if word in UNITS.get(dimension, ())), "")


def without_units(grid):
    """The arrays by their plain names: "stress" instead of "stress [MPa]"."""
    for data in (grid.GetPointData(), grid.GetCellData()):
        for i in range(data.GetNumberOfArrays()):
            data.GetArray(i).SetName(data.GetArrayName(i).partition(" [")[0])
    return grid


def automatic_factor(grid):
    """1, 2 or 5 times a power of ten; no less than 1."""
    largest = grid.GetPointData().GetArray("displacement").GetMaxNorm()
    if largest == 0:
        return 1
    wanted = SHARE * grid.GetLength() / largest
    power = 10.0**math.floor(math.log10(wanted))
    return max(1, max(step for step in (power, 2 * power, 5 * power) if step <= wanted * (1 + 1e-9)))


def surface_of(grid, factor):
    grid.GetPointData().SetActiveVectors("displacement")
    warp, skin, normals = vtkWarpVector(), vtkDataSetSurfaceFilter(), vtkPolyDataNormals()
    warp.SetScaleFactor(factor)
    skin.SetNonlinearSubdivisionLevel(2)  # quadratic faces are curved
    normals.SetFeatureAngle(40)
    return output(normals, output(skin, output(warp, grid)))


def coloured(surface, field, scale):
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(surface)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(field)
    mapper.SetLookupTable(scale)
    mapper.InterpolateScalarsBeforeMappingOn()
    actor.SetMapper(mapper)
    actor.GetProperty().SetInterpolationToPhong()
    actor.GetProperty().SetAmbient(0.4)
    actor.GetProperty().SetDiffuse(0.6)
    return actor


def edges(surface, colour, width):
    """Outlines: where the surface ends or has an edge."""
    filter_, mapper, actor = vtkFeatureEdges(), vtkPolyDataMapper(), vtkActor()
    filter_.SetFeatureAngle(40)
    filter_.NonManifoldEdgesOff()
    filter_.ColoringOff()
    mapper.SetInputData(output(filter_, surface))
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(colour)
    actor.GetProperty().SetLineWidth(width)
    actor.GetProperty().LightingOff()
    return actor


def colour_scale(low, high):
    scale = vtkColorTransferFunction()
    least = 1e-3 * (max(abs(low), abs(high)) or 1)  # rounding of a uniform field shall not fill the scale
    if high - low < least:
        low, high = 0.5 * (low + high - least), 0.5 * (low + high + least)
    for i, colour in enumerate(VIRIDIS):
        scale.AddRGBPoint(low + i / (len(VIRIDIS) - 1) * (high - low), *colour)
    return scale


def scale_bar(scale, title):
    bar = vtkScalarBarActor()
    bar.SetLookupTable(scale)
    bar.SetTitle(title + "\n ")
    bar.UnconstrainedFontSizeOn()
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.5g")
    bar.SetTextPositionToSucceedScalarBar()
    bar.SetPosition(0.84, 0.12)
    bar.SetWidth(0.09)
    bar.SetHeight(0.7)
    for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        text.SetColor(0, 0, 0)
        text.SetFontSize(20)
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
    return bar


def caption(text):
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.GetTextProperty().SetColor(0, 0, 0)
    actor.GetTextProperty().SetFontSize(20)
    actor.SetPosition(16, 12)
    return actor


def look(renderer, surface, direction):
    """A parallel view that the surface fills, but for the place of the scale; on flat bodies rather from above."""
    bounds = surface.GetBounds()
    extents = [bounds[2 * i + 1] - bounds[2 * i] for i in range(3)]
    if direction is None:
        direction = [sign / max(extent, 0.25 * max(extents)) for sign, extent in zip((1, -1, 1), extents)]
    length = math.hypot(*direction)
    direction = [d / length for d in direction]
    up = (0, 0, 1) if abs(direction[2]) < 0.8 else (0, 1, 0)
    centre = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(centre)
    camera.SetPosition([c + surface.GetLength() * d for c, d in zip(centre, direction)])
    camera.SetViewUp(up)
    camera.OrthogonalizeViewUp()
    seen = camera.GetViewTransformMatrix()
    places = [seen.MultiplyPoint((*surface.GetPoint(i), 1)) for i in range(surface.GetNumberOfPoints())]
    per_pixel, shift = 0, []
    for k, pixels, (start, end) in zip((0, 1), renderer.GetRenderWindow().GetSize(), ROOM):
        per_pixel = max(per_pixel, (max(p[k] for p in places) - min(p[k] for p in places)) / (pixels * (end - start)))
    for k, pixels, (start, end) in zip((0, 1), renderer.GetRenderWindow().GetSize(), ROOM):
        middle = 0.5 * (max(p[k] for p in places) + min(p[k] for p in places))
        shift.append(middle - (0.5 * (start + end) - 0.5) * pixels * per_pixel)
    axes = [[seen.GetElement(k, i) for i in range(3)] for k in (0, 1)]  # to the right and upward
    move = [sum(s * axis[i] for s, axis in zip(shift, axes)) for i in range(3)]
    camera.SetFocalPoint([a + b for a, b in zip(camera.GetFocalPoint(), move)])
    camera.SetPosition([a + b for a, b in zip(camera.GetPosition(), move)])
    camera.SetParallelScale(0.5 * renderer.GetRenderWindow().GetSize()[1] * per_pixel)
    renderer.ResetCameraClippingRange()


def save(window, path):
    window.Render()
    image, writer = vtkWindowToImageFilter(), vtkPNGWriter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("directory", metavar="DIR", type=pathlib.Path, help="output directory of a run")
    parser.add_argument("--field", default="von_mises", help="point data to colour by; of contact_pressure and gap the "
                        "contact surfaces are shown (default: von_mises)")
    parser.add_argument("--time", type=float, help="the output nearest to it is shown (default: the last)")
    parser.add_argument("--factor", type=float, help="of the displacements (default: chosen, 1 at least)")
    parser.add_argument("--range", type=float, nargs=2, metavar=("LOW", "HIGH"), help="of the colours")
    parser.add_argument("--view", type=float, nargs=3, metavar=("X", "Y", "Z"), help="direction towards the eye")
    parser.add_argument("--size", type=int, nargs=2, default=(1200, 900), metavar=("WIDTH", "HEIGHT"))
    parser.add_argument("--picture", type=pathlib.Path, help="file to write (default: DIR/deformed.png)")
    options = parser.parse_args()

    of_contact = options.field in ("contact_pressure", "gap")
    time, file = entry(options.directory / ("contact.pvd" if of_contact else "fields.pvd"), options.time)
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(file))
    reader.Update()
    grid = without_units(reader.GetOutput())
    arrays = [grid.GetPointData().GetArrayName(i) for i in range(grid.GetPointData().GetNumberOfArrays())]
    known = [name for name in arrays if grid.GetPointData().GetArray(name).GetNumberOfComponents() == 1]
    if options.field not in known:
        sys.exit(f"error: {file}: no field '{options.field}' of one component; there are: {', '.join(known)}")
    factor = automatic_factor(grid) if options.factor is None else options.factor
    low, high = options.range or grid.GetPointData().GetArray(options.field).GetFiniteRange()

    window, renderer = vtkRenderWindow(), vtkRenderer()
    if window.GetClassName() == "vtkXOpenGLRenderWindow" and not os.environ.get("DISPLAY"):
        sys.exit("error: this VTK draws by X, and there is no display; start the same command by xvfb-run -a ...")
    window.SetOffScreenRendering(True)
    window.SetSize(*options.size)
    window.SetMultiSamples(8)
    window.AddRenderer(renderer)
    renderer.SetBackground(1, 1, 1)
    scale, surface = colour_scale(low, high), surface_of(grid, factor)
    title, dimension = FIELDS.get(options.field, (options.field, ""))
    name_and_unit = [title] + ([f"({unit(grid, dimension)})"] if unit(grid, dimension) else [])
    renderer.AddActor(edges(surface_of(grid, 0), (0.6, 0.6, 0.6), 1))
    renderer.AddActor(coloured(surface, options.field, scale))
    renderer.AddActor(edges(surface, (0, 0, 0), 1.5))
    renderer.AddViewProp(scale_bar(scale, "\n".join(name_and_unit)))
    text = " ".join(part for part in (f"t = {time:.6g}", unit(grid, "time")) if part)
    renderer.AddViewProp(caption(f"{text}, displacements x {factor:g}"))
    look(renderer, surface, options.view)
    picture = options.picture or options.directory / "deformed.png"
    save(window, picture)
    print(f"{picture}: {options.field} from {low:.6g} to {high:.6g} at {text}, displacements x {factor:g}")


if __name__ == "__main__":
    main()
