"""Field files as VTK's own reader and filters see them: what ParaView would show."""

import itertools
import xml.etree.ElementTree

from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter, vtkWarpVector
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkFiltersParallel import vtkIntegrateAttributes
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

GAUSS = ((0.0694318442029737, 0.1739274225687269), (0.3300094782075719, 0.3260725774312731),
         (0.6699905217924281, 0.3260725774312731), (0.9305681557970263, 0.1739274225687269))  # on 0..1


def output(algorithm, data):
    algorithm.SetInputData(data)
    algorithm.Update()
    return algorithm.GetOutput()


def collection(path):
    """(time, file) of every entry of a .pvd."""
    entries = xml.etree.ElementTree.parse(path).getroot().iter("DataSet")
    return [(float(entry.get("timestep")), path.parent / entry.get("file")) for entry in entries]


def without_unit(name):
    return name.partition(" [")[0]


class Grid:
    """One .vtu file, or what a filter made of it."""

    def __init__(self, source):
        self.data = source
        if not hasattr(source, "GetCellData"):
            reader = vtkXMLUnstructuredGridReader()
            reader.SetFileName(str(source))
            reader.Update()
            if reader.GetErrorCode():
                raise OSError(f"VTK cannot read {source}")
            self.data = reader.GetOutput()

    def components(self, where):
        """{name: components} of the arrays of "point" or "cell" data; names without units."""
        data = self.attributes(where)
        return {without_unit(name): data.GetArray(name).GetNumberOfComponents() for name in self.names(where)}

    def names(self, where):
        """As the file has them, "stress [MPa]"."""
        data = self.attributes(where)
        return [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]

    def attributes(self, where):
        return self.data.GetPointData() if where == "point" else self.data.GetCellData()

    def values(self, where, name):
        """A number each, or a tuple of components. The name is without unit."""
        full = next(one for one in self.names(where) if without_unit(one) == name)
        array = self.attributes(where).GetArray(full)
        tuples = [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]
        return [t[0] for t in tuples] if array.GetNumberOfComponents() == 1 else tuples

    def field(self, name):
        """The values of an array of the field data."""
        array = self.data.GetFieldData().GetArray(name)
        return [array.GetValue(i) for i in range(array.GetNumberOfValues())]

    def texts(self, name):
        """The names of the components of an array of the field data."""
        array = self.data.GetFieldData().GetArray(name)
        return [array.GetComponentName(i) for i in range(array.GetNumberOfComponents())]

    def points(self):
        return [self.data.GetPoint(i) for i in range(self.data.GetNumberOfPoints())]

    def cells(self):
        """One after the other: VTK fills the same object with the next."""
        return (self.data.GetCell(i) for i in range(self.data.GetNumberOfCells()))

    def tetrahedra(self):
        """For VTK's filters that give 0 for hexahedra of 27 nodes."""
        return Grid(output(vtkDataSetTriangleFilter(), self.data))

    def sizes(self):
        """VTK's volume, or area, of each cell."""
        name = "Volume" if self.data.GetCell(0).GetCellDimension() == 3 else "Area"
        return Grid(output(vtkCellSizeFilter(), self.data)).values("cell", name)

    def mean(self, where, name):
        """Volume or area weighted: what the filter Integrate Variables gives, divided by the size."""
        whole = Grid(output(vtkIntegrateAttributes(), self.data))
        size = "Volume" if self.data.GetCell(0).GetCellDimension() == 3 else "Area"
        total, = whole.values("cell", size)
        integral, = whole.values(where, name)
        return [part / total for part in integral] if isinstance(integral, tuple) else integral / total

    def warped(self):
        full = next(name for name in self.names("point") if without_unit(name) == "displacement")
        self.data.GetPointData().SetActiveVectors(full)
        return Grid(output(vtkWarpVector(), self.data))

    def enclosed(self):
        """Volume within the surface by the divergence theorem: positive if its faces look outward."""
        surface = output(vtkTriangleFilter(), output(vtkDataSetSurfaceFilter(), self.data))
        return sum(determinant([surface.GetCell(i).GetPoints().GetPoint(k) for k in range(3)]) / 6
                   for i in range(surface.GetNumberOfCells()))


def determinant(rows):
    (a, b, c), (d, e, f), (g, h, i) = rows
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


def parametric_rule(form):
    """Points and weights on VTK's reference cell; products of Gauss points, collapsed towards corners and edges."""
    for (r, u), (s, v), (t, w) in itertools.product(GAUSS, repeat=3):
        if form == "hex":
            yield (r, s, t), u * v * w
        elif form == "wedge":
            yield (r, s * (1 - r), t), u * v * w * (1 - r)
        else:
            yield (r, s * (1 - r), t * (1 - r) * (1 - s)), u * v * w * (1 - r)**2 * (1 - s)


def jacobians(cell, form):
    """(det J, weight) at integration points, by the shape functions that VTK has for the cell."""
    n = cell.GetNumberOfPoints()
    places = [cell.GetPoints().GetPoint(k) for k in range(n)]
    for at, weight in parametric_rule(form):
        slopes = [0.0] * (3 * n)
        cell.InterpolateDerivs(at, slopes)
        yield determinant([[sum(slopes[a * n + k] * places[k][i] for k in range(n)) for i in range(3)]
                           for a in range(3)]), weight
