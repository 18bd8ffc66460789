"""Draws bodies and fields on them as PNG pictures by VTK, off-screen.

usage: python3 -I picture.py JOBS

JOBS is a JSON file with a list of pictures. Each has "kind", "output": .png, "title" and "flat": true for a section.

Of kind "field", and of kind "mesh", which colours the bodies instead: {"file": .vtu, "contact_file": .vtu of the contact surfaces if
the field is theirs, else "", "width", "height", "unit", "array", "component" (-1: magnitude), "ticks": numbers at the colours, which
range from the first to the last, "displacement": name of the array or "", "warp": factor, "bodies": numbers of the bodies shown, empty
for all, "colours": [[position, red, green, blue], ...], "view": "iso", "x", "-x", "y", "-y", "z" or "-z", "section": null or a point of a plane
and its normal, towards what is cut away}.

Of kind "model", bodies with marks on them: {"bodies" and "marks": [[name, [red, green, blue], width of lines], ...], "points":
[[x, y, z], ...], "facets" and "lines": [[body, mark or -1, point, point, ...], ...], "ticks": numbers along x and along y (sections),
"length_unit"}.

Without a display a virtual one is started (Xvfb).
"""

import json
import os
import shutil
import subprocess
import sys
import types

BODY_COLOURS = [(0.55, 0.67, 0.82), (0.88, 0.74, 0.52), (0.62, 0.75, 0.58), (0.80, 0.62, 0.72), (0.70, 0.70, 0.70), (0.86, 0.80, 0.45)]
NO_VALUE = (0.80, 0.82, 0.84)
INK = (0.12, 0.16, 0.20)
MAX_CELLS_WITH_LINES = 60000  # more lines would cover the colours
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
    """Adds the scalar to be shown as the array "shown"."""
    array = vtk_to_numpy(grid.GetPointData().GetArray(job["array"]))
    if array.ndim > 1:
        component = job["component"]
        array = numpy.sqrt((array * array).sum(axis=1)) if component < 0 else array[:, component]
    shown = numpy_to_vtk(numpy.ascontiguousarray(array, dtype=float), deep=True, array_type=10)  # float
    shown.SetName("shown")
    grid.GetPointData().AddArray(shown)


def colour_table(job):
    """Colours from the first to the last tick."""
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(256)
    table.SetTableRange(job["ticks"][0], job["ticks"][-1])
    colours = numpy.array(job["colours"], dtype=float)
    for i in range(256):
        rgb = [numpy.interp(i / 255, colours[:, 0], colours[:, c]) for c in (1, 2, 3)]
        table.SetTableValue(i, *rgb, 1)
    table.SetNanColor(*NO_VALUE, 1)
    table.Build()
    return table


def deformed(source, job):
    if not job["displacement"] or not job["warp"]:
        return source
    warp = vtk.vtkWarpVector()
    warp.SetInputConnection(source.GetOutputPort())
    warp.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, job["displacement"])
    warp.SetScaleFactor(job["warp"])
    return warp


def cut(source, job):
    """The part behind the plane of the section."""
    if not job["section"]:
        return source
    plane = vtk.vtkPlane()
    plane.SetOrigin(*job["section"][:3])
    plane.SetNormal(*job["section"][3:])
    clip = vtk.vtkClipDataSet()
    clip.SetInputConnection(source.GetOutputPort())
    clip.SetClipFunction(plane)
    clip.InsideOutOn()
    return clip


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


def add_actor(renderer, source, job, depth):
    """A lit surface. depth: how far behind the lines of the mesh."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(*depth)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    prop = actor.GetProperty()
    prop.SetAmbient(1.0 if job["flat"] else 0.55)
    prop.SetDiffuse(0.0 if job["flat"] else 0.5)
    renderer.AddActor(actor)
    return mapper, prop


def add_surface(renderer, source, job, table, colour, depth=(2, 200)):
    """The surface of a part: coloured by the table, or in one colour if that is None."""
    surface = source
    if not source.GetOutputDataObject(0).IsA("vtkPolyData"):
        surface = vtk.vtkDataSetSurfaceFilter()
        surface.SetInputConnection(source.GetOutputPort())
        surface.SetNonlinearSubdivisionLevel(2)
    mapper, prop = add_actor(renderer, surface, job, depth)
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
        source = deformed(cut(threshold, job), job)
        if job["contact_file"]:
            add_surface(renderer, source, job, None, NO_VALUE).SetOpacity(0.10)
            add_outlines(renderer, source)
            continue
        add_surface(renderer, source, job, table, BODY_COLOURS[body % len(BODY_COLOURS)])
        if grid.GetNumberOfCells() < MAX_CELLS_WITH_LINES:
            add_mesh_lines(renderer, source, 0.55 if table is None else 0.35)


def add_text(renderer, words, size, x, y, bold=False, centred=False, turned=False):
    actor = vtk.vtkTextActor()
    actor.SetInput(words)
    prop = actor.GetTextProperty()
    prop.SetFontSize(size)
    prop.SetColor(*INK)
    prop.SetFontFamilyToArial()
    prop.SetBold(bold)
    if centred:
        prop.SetJustificationToCentered()
        prop.SetVerticalJustificationToCentered()
    if turned:
        prop.SetOrientation(90)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(x, y)
    renderer.AddActor2D(actor)


def add_shape(renderer, corners, polygons=(), lines=(), colours=()):
    """Polygons and lines in pixels of the picture, each in its own colour."""
    shape, points, shades = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkUnsignedCharArray()
    shades.SetNumberOfComponents(3)
    for x, y in corners:
        points.InsertNextPoint(x, y, 0)
    shape.SetPoints(points)
    for cells, add in ((lines, shape.SetLines), (polygons, shape.SetPolys)):
        array = vtk.vtkCellArray()
        for cell in cells:
            array.InsertNextCell(len(cell))
            for corner in cell:
                array.InsertCellPoint(corner)
        add(array)
    for rgb in colours:
        shades.InsertNextTuple3(*(int(255 * value) for value in rgb))
    shape.GetCellData().SetScalars(shades)
    mapper = vtk.vtkPolyDataMapper2D()
    mapper.SetInputData(shape)
    actor = vtk.vtkActor2D()
    actor.SetMapper(mapper)
    renderer.AddActor2D(actor)


def add_legend(renderer, job, table):
    """A strip of our own: the ticks of VTK's colour bar are not at round numbers."""
    width, height, ticks = job["width"], job["height"], job["ticks"]
    left, bottom, tall = 0.86, 0.16, 0.64
    steps = 128
    corners, colours = [], []
    for i in range(steps + 1):
        y = (bottom + tall * i / steps) * height
        corners += [(left * width, y), ((left + 0.022) * width, y)]
        rgb = [0.0, 0.0, 0.0]
        table.GetColor(ticks[0] + (ticks[-1] - ticks[0]) * (i + 0.5) / steps, rgb)
        colours.append(rgb)
    add_shape(renderer, corners, [(2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2) for i in range(steps)], colours=colours[:steps])
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


def axes_inset(viewport, layer, letter, camera, direction):
    """The directions of x, y and z."""
    axes = vtk.vtkAxesActor()
    inset = vtk.vtkRenderer()
    inset.SetViewport(*viewport)
    inset.SetLayer(layer)
    axes.SetCylinderRadius(0.04)
    axes.SetShaftTypeToCylinder()
    for caption in (axes.GetXAxisCaptionActor2D(), axes.GetYAxisCaptionActor2D(), axes.GetZAxisCaptionActor2D()):
        caption.GetTextActor().SetTextScaleModeToNone()
        prop = caption.GetCaptionTextProperty()
        prop.SetFontSize(letter)
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


def save(window, job):
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


def window_of(width, height, layers):
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(width, height)
    window.SetNumberOfLayers(layers)
    return window


def draw_field(job):
    width, height = job["width"], job["height"]
    grid = read(job["file"])
    on_contact = read(job["contact_file"]) if job["contact_file"] else None
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    table = None
    if job["kind"] == "field":
        add_values(on_contact or grid, job)
        table = colour_table(job)
    add_bodies(renderer, grid, job, table)
    if on_contact:
        surface = vtk.vtkTrivialProducer()
        surface.SetOutput(lines_of(on_contact) if job["flat"] else on_contact)
        add_surface(renderer, deformed(surface, job), job, table, None, (-1, -100))
    if table is not None:
        add_legend(renderer, job, table)
    if job["title"]:
        add_text(renderer, job["title"], max(13, height // 40), 0.025, 0.945, bold=True)
    camera, direction = aim(renderer, job, table is not None, on_contact)
    window = window_of(width, height, 2)
    window.AddRenderer(renderer)
    if not job["flat"]:
        window.AddRenderer(axes_inset((0.0, 0.0, 0.14, 0.14 * width / height), 1, max(12, height // 46), camera, direction))
    save(window, job)


# Pictures of a model, in pixels.
VIEW_SIZE, FLAT_SIZE, EDGE, TOP, GAP, LETTER, LINE = (430, 360), (720, 800), 84, 48, 12, 15, 21
FRONT = (1.0, -1.4, 0.9)
MAX_BODIES_ALONE = 4  # with views of their own


def merge_points(job):
    """Cells share the points that lie at one place, so that each edge is drawn once."""
    points, numbers = numpy.unique(numpy.array(job["points"], dtype=float).reshape(-1, 3), axis=0, return_inverse=True)
    numbers = numbers.ravel().tolist()
    job["points"] = points
    for cells in (job["facets"], job["lines"]):
        cells[:] = [[body, mark, *(numbers[corner] for corner in corners)] for body, mark, *corners in cells]


def cells_of(job, cells):
    """Points and cells with the colours of their marks, or else of their bodies."""
    points, array, shades = vtk.vtkPoints(), vtk.vtkCellArray(), vtk.vtkUnsignedCharArray()
    points.SetData(numpy_to_vtk(job["points"], deep=True))
    shades.SetNumberOfComponents(3)
    for body, mark, *corners in cells:
        array.InsertNextCell(len(corners))
        for corner in corners:
            array.InsertCellPoint(corner)
        shades.InsertNextTuple3(*(int(255 * part) for part in (job["marks"][mark] if mark >= 0 else job["bodies"][body])[1]))
    data = vtk.vtkPolyData()
    data.SetPoints(points)
    return data, array, shades


def add_cells(renderer, job, cells, kind, width=1, depth=(2, 200)):
    """kind: "Polys", "Lines" or "Verts" """
    data, array, shades = cells_of(job, cells)
    getattr(data, "Set" + kind)(array)
    data.GetCellData().SetScalars(shades)
    source = vtk.vtkTrivialProducer()
    source.SetOutput(data)
    mapper, prop = add_actor(renderer, source, job, depth)
    mapper.SetScalarModeToUseCellData()
    if kind == "Polys":
        prop.SetBackfaceCulling(not job["flat"])
        if len(cells) < MAX_CELLS_WITH_LINES:
            add_mesh_lines(renderer, source, 0.35)
        return
    prop.LightingOff()
    prop.SetLineWidth(width)
    prop.SetPointSize(10)
    prop.RenderPointsAsSpheresOn()


def add_model(renderer, job, body):
    """One body, or all of them if it is None."""
    facets = [facet for facet in job["facets"] if body in (None, facet[0])]
    add_cells(renderer, job, facets, "Polys")
    for mark, (_, _, width) in enumerate(job["marks"]):  # later ones are nearer
        marked = [line for line in job["lines"] if line[1] == mark and body in (None, line[0])]
        for kind, cells in (("Lines", [line for line in marked if len(line) > 3]), ("Verts", [line for line in marked if len(line) == 3])):
            if cells:
                add_cells(renderer, job, cells, kind, width, (-1 - mark, -100 - mark))


def look(renderer, job, body, direction, size):
    """Turns the camera so that the bodies fill a view of this size; returns the camera, and the corner and scale of what it shows."""
    corners = job["points"]
    shown = {corner for cell in job["facets"] + job["lines"] if body in (None, cell[0]) for corner in cell[2:]}
    corners = corners[sorted(shown)] if shown else numpy.zeros((1, 3))
    eye = numpy.array(direction, dtype=float) / numpy.linalg.norm(direction)
    above = numpy.array((0, 1, 0) if job["flat"] else (0, 0, 1), dtype=float)
    right = numpy.cross(above, eye)
    right /= numpy.linalg.norm(right)
    up = numpy.cross(eye, right)
    place = numpy.stack([corners @ right, corners @ up], axis=1)
    low, high = place.min(axis=0), place.max(axis=0)
    margin = 0.06 * max(numpy.linalg.norm(high - low), 1e-300)
    low, high = low - margin, high + margin
    scale = max((high[0] - low[0]) / size[0], (high[1] - low[1]) / size[1])  # per pixel
    middle = (low + high) / 2
    focus = middle[0] * right + middle[1] * up + (corners @ eye).mean() * eye
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*focus)
    camera.SetPosition(*(focus + eye))
    camera.SetViewUp(*above)
    renderer.ResetCamera()
    camera.SetFocalPoint(*focus)
    camera.SetPosition(*(focus + eye * camera.GetDistance()))
    camera.SetParallelScale(0.5 * scale * size[1])
    renderer.ResetCameraClippingRange()
    return camera, middle - 0.5 * scale * numpy.array(size), scale


def add_axes(renderer, job, left, bottom, size, corner, scale, page):
    """Coordinates around a section."""
    unit = f" ({job['length_unit']})" if job["length_unit"] else ""
    corners, lines = [(left, bottom + size[1]), (left, bottom), (left + size[0], bottom)], [(0, 1), (1, 2)]
    for axis, ticks in enumerate(job["ticks"]):
        for tick in ticks:
            at = (tick - corner[axis]) / scale
            if not 0 <= at <= size[axis]:
                continue
            x, y = (left + at, bottom) if axis == 0 else (left, bottom + at)
            corners += [(x, y), (x, y - 6) if axis == 0 else (x - 6, y)]
            lines.append((len(corners) - 2, len(corners) - 1))
            label = (x, y - 18) if axis == 0 else (x - 30, y)
            add_text(renderer, f"{tick:.6g}", LETTER, label[0] / page[0], label[1] / page[1], centred=True)
    add_shape(renderer, corners, lines=lines, colours=[INK] * len(lines))
    add_text(renderer, "x" + unit, LETTER, (left + size[0] / 2) / page[0], (bottom - 42) / page[1], centred=True)
    add_text(renderer, "y" + unit, LETTER, (left - 66) / page[0], (bottom + size[1] / 2) / page[1], centred=True, turned=True)


def flat_size(job):
    wide, tall = numpy.ptp(job["points"][:, :2], axis=0) if len(job["points"]) else (1.0, 1.0)
    ratio = max(tall / max(wide, 1e-300), 1e-6)
    width = min(max(FLAT_SIZE[1] / ratio, 160), FLAT_SIZE[0])
    return int(width), int(min(max(width * ratio, 120), FLAT_SIZE[1]))


def draw_model(job):
    """Sections along z with coordinates; solids from the front and from behind, all together and the first ones each alone, since
    contact surfaces hide each other."""
    merge_points(job)
    entries = job["bodies"] + job["marks"]
    bodies = [None]
    if job["flat"]:
        size, left, directions, below = flat_size(job), EDGE + GAP, [(0, 0, 1)], EDGE
    else:
        size, left, directions, below = VIEW_SIZE, GAP, [FRONT, tuple(-part for part in FRONT)], GAP
        if len(job["bodies"]) > 1:
            bodies += range(min(len(job["bodies"]), MAX_BODIES_ALONE))
    legend = left + len(directions) * (size[0] + GAP)
    # A letter is about half as wide as the font is high.
    page = (legend + 3 * GAP + int(0.6 * LETTER * max([len(entry[0]) for entry in entries], default=0)),
            int(max(TOP + len(bodies) * (size[1] + GAP) + below, TOP + LINE * (len(entries) + 1))))
    sheet = vtk.vtkRenderer()
    sheet.SetBackground(1, 1, 1)
    add_text(sheet, job["title"], LETTER + 3, GAP / page[0], 1 - 30 / page[1], bold=True)
    for i, (name, colour, _) in enumerate(entries):
        y = page[1] - TOP - LINE * (i + 1)
        add_shape(sheet, [(legend, y), (legend + GAP, y), (legend + GAP, y + GAP), (legend, y + GAP)], [(0, 1, 2, 3)], colours=[colour])
        add_text(sheet, name, LETTER, (legend + 2 * GAP) / page[0], (y - 2) / page[1])
    window = window_of(*page, 3)
    window.AddRenderer(sheet)
    for row, body in enumerate(bodies):
        for column, direction in enumerate(directions):
            x, y = left + column * (size[0] + GAP), page[1] - TOP - (row + 1) * (size[1] + GAP) + GAP
            view = vtk.vtkRenderer()
            view.SetViewport(x / page[0], y / page[1], (x + size[0]) / page[0], (y + size[1]) / page[1])
            view.SetLayer(1)
            add_model(view, job, body)
            camera, corner, scale = look(view, job, body, direction, size)
            window.AddRenderer(view)
            if job["flat"]:
                add_axes(sheet, job, x, y, size, corner, scale, page)
            else:
                inset = (x / page[0], y / page[1], (x + 96) / page[0], (y + 96) / page[1])
                window.AddRenderer(axes_inset(inset, 2, LETTER - 3, camera, direction))
    save(window, job)


def main(jobs):
    server = start_display()
    try:
        for job in jobs:
            (draw_model if job["kind"] == "model" else draw_field)(job)
    finally:
        if server:
            server.terminate()
            server.wait()


vtk = load_vtk()
import numpy  # noqa: E402 (VTK brings it)
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402

with open(sys.argv[1], encoding="utf-8") as file:
    main(json.load(file))
