"""Draws fields of a run as PNG pictures by VTK, off-screen.

usage: python3 -I picture.py JOBS

JOBS is, as JSON, a list of pictures: {"file": .vtu, "contact_file": .vtu of the contact surfaces if the field is theirs, else
"", "output": .png, "width", "height", "title", "unit", "array", "component" (-1: magnitude), "low", "high" (range of the
colours; null: that of the values), "displacement": name of the array or "", "warp": factor, "bodies": numbers of the bodies
shown, empty for all, "colours": [[position, red, green, blue], ...], "mesh": true to colour the bodies instead of a field,
"flat": true for a section, "view": "iso", "x", "-x", "y", "-y", "z" or "-z"}.

Without a display a virtual one is started (Xvfb).
"""

import json
import math
import os
import shutil
import subprocess
import sys
import types

BODY_COLOURS = [(0.55, 0.67, 0.82), (0.88, 0.74, 0.52), (0.62, 0.75, 0.58), (0.80, 0.62, 0.72), (0.70, 0.70, 0.70), (0.86, 0.80, 0.45)]
NO_VALUE = (0.80, 0.82, 0.84)
INK = (0.12, 0.16, 0.20)
MOST_CELLS_WITH_LINES = 60000  # more lines would cover the colours
VIEWS = {"iso": (1.0, -1.25, 0.85), "x": (1, 0, 0), "-x": (-1, 0, 0), "y": (0, 1, 0), "-y": (0, -1, 0), "z": (0, 0, 1), "-z": (0, 0, -1)}


def start_display():
    """A virtual screen for VTK, which draws through X. Returns what must live until the end."""
    if os.environ.get("DISPLAY"):
        return None
    # Not from the working directory, which PATH may name.
    program = shutil.which("Xvfb", path=os.pathsep.join(place for place in os.get_exec_path() if os.path.isabs(place)))
    if program is None:
        sys.exit("there is no display, and Xvfb is not installed (Debian: apt-get install xvfb)")
    reading, writing = os.pipe()
    try:
        server = subprocess.Popen([program, "-displayfd", str(writing), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"],
                                  pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    except FileNotFoundError:
        sys.exit("there is no display, and Xvfb is not installed (Debian: apt-get install xvfb)")
    os.close(writing)
    with os.fdopen(reading) as pipe:
        number = pipe.readline().strip()
    if not number:
        sys.exit("the virtual display (Xvfb) did not start")
    os.environ["DISPLAY"] = ":" + number
    return server


def rounded_ticks(low, high):
    """Ends of a range and ticks at steps of 1, 2 or 5 times a power of ten."""
    if not high > low:
        pad = abs(low) * 0.01 or 1.0
        low, high = low - pad, high + pad
    raw = (high - low) / 6
    decade = 10.0 ** math.floor(math.log10(raw))
    step = next(decade * factor for factor in (1, 2, 5, 10) if decade * factor >= raw * 0.999)
    first, last = math.floor(low / step + 1e-6), math.ceil(high / step - 1e-6)
    return [step * number for number in range(first, last + 1)]


def load_vtk():
    """The classes of VTK by their names. The import takes a second, and fails with a sentence where there is no VTK."""
    try:
        import vtkmodules.vtkRenderingFreeType  # noqa: F401 (text needs it)
        import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
        from vtkmodules import (vtkCommonCore, vtkCommonDataModel, vtkCommonExecutionModel, vtkFiltersCore, vtkFiltersExtraction,
                                vtkFiltersGeneral, vtkFiltersGeometry, vtkIOImage, vtkIOXML, vtkRenderingAnnotation, vtkRenderingCore)
    except ImportError:
        sys.exit("Python has no VTK (Debian: apt-get install python3-vtk9)")
    modules = (vtkCommonCore, vtkCommonDataModel, vtkCommonExecutionModel, vtkFiltersCore, vtkFiltersExtraction, vtkFiltersGeneral, vtkFiltersGeometry,
               vtkIOImage, vtkIOXML, vtkRenderingAnnotation, vtkRenderingCore)
    return types.SimpleNamespace(**{name: getattr(module, name) for module in modules for name in dir(module)
                                    if name.startswith("vtk")})


def read(file):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


def add_values(grid, job):
    """Adds the scalar to be shown as the array "shown", and returns it."""
    array = vtk_to_numpy(grid.GetPointData().GetArray(job["array"]))
    if array.ndim > 1:
        component = job["component"]
        array = numpy.sqrt((array * array).sum(axis=1)) if component < 0 else array[:, component]
    values = numpy.ascontiguousarray(array, dtype=float)
    shown = numpy_to_vtk(values, deep=True, array_type=10)  # float
    shown.SetName("shown")
    grid.GetPointData().AddArray(shown)
    return values


def colour_table(values, job):
    """Colours over rounded numbers, and these."""
    finite = values[numpy.isfinite(values)]
    low = job["low"] if job["low"] is not None else (float(finite.min()) if finite.size else 0.0)
    high = job["high"] if job["high"] is not None else (float(finite.max()) if finite.size else 1.0)
    ticks = rounded_ticks(low, high)
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    table.SetTableRange(ticks[0], ticks[-1])
    colours = numpy.array(job["colours"], dtype=float)
    for i in range(256):
        rgb = [numpy.interp(i / 255, colours[:, 0], colours[:, c]) for c in (1, 2, 3)]
        table.SetTableValue(i, *rgb, 1)
    table.SetNanColor(*NO_VALUE, 1)
    table.Build()
    return table, ticks


def deformed(source, job):
    if not job["displacement"] or not job["warp"]:
        return source
    warp = vtk.vtkWarpVector()
    warp.SetInputConnection(source.GetOutputPort())
    warp.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, job["displacement"])
    warp.SetScaleFactor(job["warp"])
    return warp


def lines_of(grid):
    """The edges of sections in contact as lines: VTK 9.1 crashes where it is to divide quadratic ones itself."""
    cells = vtk.vtkCellArray()
    for i in range(grid.GetNumberOfCells()):
        nodes = grid.GetCell(i).GetPointIds()
        order = (0, 2, 1) if nodes.GetNumberOfIds() == 3 else (0, 1)
        cells.InsertNextCell(len(order))
        for k in order:
            cells.InsertCellPoint(nodes.GetId(k))
    lines = vtk.vtkPolyData()
    lines.SetPoints(grid.GetPoints())
    lines.SetLines(cells)
    lines.GetPointData().ShallowCopy(grid.GetPointData())
    return lines


def add_surface(renderer, source, job, table, colour, depth=(2, 200)):
    """The surface of a part: coloured by the table, or in one colour if that is None. depth: how far behind the lines of the mesh."""
    surface = source
    if not source.GetOutputDataObject(0).IsA("vtkPolyData"):
        surface = vtk.vtkDataSetSurfaceFilter()
        surface.SetInputConnection(source.GetOutputPort())
        surface.SetNonlinearSubdivisionLevel(2)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(*depth)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    prop = actor.GetProperty()
    prop.SetAmbient(1.0 if job["flat"] else 0.55)
    prop.SetDiffuse(0.0 if job["flat"] else 0.5)
    if table is None:
        mapper.ScalarVisibilityOff()
        prop.SetColor(*colour)
    else:
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray("shown")
        mapper.SetLookupTable(table)
        mapper.UseLookupTableScalarRangeOn()
        mapper.InterpolateScalarsBeforeMappingOn()
        prop.SetLineWidth(7)  # contact along the edge of a section
    renderer.AddActor(actor)
    return prop


def add_mesh_lines(renderer, source, opacity):
    edges = vtk.vtkExtractEdges()
    edges.SetInputConnection(source.GetOutputPort())
    lines = vtk.vtkPolyDataMapper()
    lines.SetInputConnection(edges.GetOutputPort())
    lines.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(lines)
    prop = actor.GetProperty()
    prop.SetColor(*INK)
    prop.SetOpacity(opacity)
    prop.LightingOff()
    renderer.AddActor(actor)


def add_outlines(renderer, source):
    """The sharp edges of a part that is drawn as glass."""
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputConnection(source.GetOutputPort())
    edges = vtk.vtkFeatureEdges()
    edges.SetInputConnection(surface.GetOutputPort())
    edges.SetFeatureAngle(35)
    edges.ManifoldEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.ColoringOff()
    lines = vtk.vtkPolyDataMapper()
    lines.SetInputConnection(edges.GetOutputPort())
    lines.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(lines)
    actor.GetProperty().SetColor(*INK)
    actor.GetProperty().SetOpacity(0.6)
    actor.GetProperty().LightingOff()
    renderer.AddActor(actor)


def add_bodies(renderer, grid, job, table):
    points = grid.GetPointData()
    numbers = vtk_to_numpy(points.GetArray("body")) if points.GetArray("body") else numpy.zeros(grid.GetNumberOfPoints())
    n_bodies = int(numbers.max()) + 1 if numbers.size else 1
    for body in job["bodies"] or range(n_bodies):
        threshold = vtk.vtkThreshold()
        threshold.SetInputData(grid)
        if points.GetArray("body"):
            threshold.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, "body")
            threshold.SetLowerThreshold(body - 0.5)
            threshold.SetUpperThreshold(body + 0.5)
            threshold.SetThresholdFunction(vtk.vtkThreshold.THRESHOLD_BETWEEN)
        source = deformed(threshold, job)
        if job["contact_file"]:
            add_surface(renderer, source, job, None, NO_VALUE).SetOpacity(0.10)
            add_outlines(renderer, source)
            continue
        add_surface(renderer, source, job, table, BODY_COLOURS[body % len(BODY_COLOURS)])
        if grid.GetNumberOfCells() < MOST_CELLS_WITH_LINES:
            add_mesh_lines(renderer, source, 0.55 if table is None else 0.35)


def add_text(renderer, words, size, x, y, bold=False):
    actor = vtk.vtkTextActor()
    actor.SetInput(words)
    prop = actor.GetTextProperty()
    prop.SetFontSize(size)
    prop.SetColor(*INK)
    prop.SetFontFamilyToArial()
    prop.SetBold(bold)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(x, y)
    renderer.AddActor2D(actor)


def add_legend(renderer, job, table, ticks):
    """A strip of our own: the ticks of VTK's colour bar are not at round numbers."""
    width, height = job["width"], job["height"]
    left, bottom, tall = 0.86, 0.16, 0.64
    strip, cells, shades, corners = vtk.vtkPolyData(), vtk.vtkCellArray(), vtk.vtkUnsignedCharArray(), vtk.vtkPoints()
    shades.SetNumberOfComponents(3)
    steps = 128
    for i in range(steps + 1):
        y = (bottom + tall * i / steps) * height
        corners.InsertNextPoint(left * width, y, 0)
        corners.InsertNextPoint((left + 0.022) * width, y, 0)
        if i < steps:
            cells.InsertNextCell(4)
            for corner in (2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2):
                cells.InsertCellPoint(corner)
            rgb = [0.0, 0.0, 0.0]
            table.GetColor(ticks[0] + (ticks[-1] - ticks[0]) * (i + 0.5) / steps, rgb)
            shades.InsertNextTuple3(*(int(255 * value) for value in rgb))
    strip.SetPoints(corners)
    strip.SetPolys(cells)
    strip.GetCellData().SetScalars(shades)
    strip_mapper = vtk.vtkPolyDataMapper2D()
    strip_mapper.SetInputData(strip)
    strip_actor = vtk.vtkActor2D()
    strip_actor.SetMapper(strip_mapper)
    renderer.AddActor2D(strip_actor)
    for tick in ticks:
        y = bottom + tall * (tick - ticks[0]) / (ticks[-1] - ticks[0])
        add_text(renderer, f"{tick:.6g}", max(12, height // 48), left + 0.03, y - 0.012)
    if job["unit"]:
        add_text(renderer, job["unit"], max(12, height // 46), left, bottom + tall + 0.025, bold=True)


def facing(grid):
    """The oblique direction that sees most of a surface."""
    if grid.GetCell(0).GetCellDimension() < 2:
        return VIEWS["iso"]
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(surface.GetOutputPort())
    triangles.PassLinesOff()
    triangles.Update()
    mesh = triangles.GetOutput()
    corners = vtk_to_numpy(mesh.GetPoints().GetData())[vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    areas = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    x, y, z = VIEWS["iso"]
    return max([(x, y, z), (-x, y, z), (x, -y, z), (-x, -y, z)], key=lambda view: numpy.abs(areas @ view).sum())


def aim(renderer, job, has_legend, on_contact):
    """The camera, and the direction from which it looks: at the contact surfaces if they are given, else at all bodies."""
    bounds = around(on_contact.GetBounds()) if on_contact else None
    width, height = job["width"], job["height"]
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    renderer.ResetCamera(bounds or renderer.ComputeVisiblePropBounds())
    focus = camera.GetFocalPoint()
    direction = (0, 0, 1) if job["flat"] else facing(on_contact) if on_contact and job["view"] == "iso" else VIEWS[job["view"]]
    camera.SetPosition(*(focus[i] + direction[i] for i in range(3)))
    camera.SetViewUp(*((0, 1, 0) if job["flat"] or abs(direction[2]) == 1 else (0, 0, 1)))
    renderer.ResetCamera(bounds or renderer.ComputeVisiblePropBounds())
    # The sphere around the bodies is larger than what is seen of them: fit their corners instead.
    bounds = bounds or renderer.ComputeVisiblePropBounds()
    right = numpy.cross(camera.GetViewUp(), camera.GetDirectionOfProjection())
    right = -right / numpy.linalg.norm(right)
    up = numpy.cross(right, camera.GetDirectionOfProjection())
    corners = numpy.array([[bounds[i], bounds[2 + j], bounds[4 + k]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
    wide, tall_ = numpy.ptp(corners @ right), numpy.ptp(corners @ up)
    free_width = 0.80 if has_legend else 0.94
    camera.SetParallelScale(0.5 * max(tall_ / 0.86, wide / free_width * height / width))
    if has_legend:
        camera.SetWindowCenter(0.13, 0.04)
    return camera, direction


def around(bounds):
    """A box with some of the neighbourhood."""
    margin = 0.3 * max(bounds[2 * i + 1] - bounds[2 * i] for i in range(3))
    return [end + (margin if i % 2 else -margin) for i, end in enumerate(bounds)]


def axes_inset(job, camera, direction):
    width, height = job["width"], job["height"]
    axes = vtk.vtkAxesActor()
    inset = vtk.vtkRenderer()
    inset.SetViewport(0.0, 0.0, 0.14, 0.14 * width / height)
    inset.SetLayer(1)
    axes.SetCylinderRadius(0.04)
    axes.SetShaftTypeToCylinder()
    for caption in (axes.GetXAxisCaptionActor2D(), axes.GetYAxisCaptionActor2D(), axes.GetZAxisCaptionActor2D()):
        caption.GetTextActor().SetTextScaleModeToNone()
        prop = caption.GetCaptionTextProperty()
        prop.SetFontSize(max(12, height // 46))
        prop.SetColor(*INK)
        prop.BoldOff()
        prop.ItalicOff()
        prop.ShadowOff()
    axes.SetXAxisLabelText("x")
    axes.SetYAxisLabelText("y")
    axes.SetZAxisLabelText("z")
    inset.AddActor(axes)
    small = inset.GetActiveCamera()
    small.ParallelProjectionOn()
    inset.ResetCamera()
    place = small.GetFocalPoint()
    small.SetPosition(*(place[i] + 4 * direction[i] for i in range(3)))
    small.SetViewUp(*camera.GetViewUp())
    inset.ResetCamera()
    small.SetParallelScale(small.GetParallelScale() * 0.9)
    return inset


def draw(job):
    grid = read(job["file"])
    on_contact = read(job["contact_file"]) if job["contact_file"] else None
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    table = None
    if not job["mesh"]:
        table, ticks = colour_table(add_values(on_contact or grid, job), job)
    add_bodies(renderer, grid, job, table)
    if on_contact:
        surface = vtk.vtkTrivialProducer()
        surface.SetOutput(lines_of(on_contact) if job["flat"] else on_contact)
        add_surface(renderer, deformed(surface, job), job, table, None, (-1, -100))
    if table is not None:
        add_legend(renderer, job, table, ticks)
    if job["title"]:
        add_text(renderer, job["title"], max(13, job["height"] // 40), 0.025, 0.945, bold=True)
    camera, direction = aim(renderer, job, table is not None, on_contact)

    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(job["width"], job["height"])
    window.SetNumberOfLayers(2)
    window.AddRenderer(renderer)
    if not job["flat"]:
        window.AddRenderer(axes_inset(job, camera, direction))
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(job["output"])
    writer.Write()
    if writer.GetErrorCode():
        sys.exit(f"cannot write '{job['output']}'")
    window.Finalize()


def main(jobs):
    server = start_display()
    try:
        for job in jobs:
            draw(job)
    finally:
        if server:
            server.terminate()
            server.wait()


vtk = load_vtk()
import numpy  # noqa: E402 (VTK brings it)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402

main(json.loads(sys.argv[1]))
