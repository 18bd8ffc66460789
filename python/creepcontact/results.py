"""Results of runs: in memory, or in the directory of a run of the command."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from . import _core
from .errors import ConfigError


class Table(np.ndarray):
    """A structured array, a field for each column: table["time"]."""

    @classmethod
    def of(cls, columns: Mapping[str, Any]) -> Table:
        arrays = {name: np.asarray(values) for name, values in columns.items()}
        rows = len(next(iter(arrays.values()), ()))
        table = np.empty(rows, dtype=[(name, values.dtype) for name, values in arrays.items()])
        for name, values in arrays.items():
            table[name] = values
        return table.view(cls)

    def to_pandas(self) -> Any:
        """A DataFrame with the time as its index. Needs pandas."""
        import pandas

        frame = pandas.DataFrame({name: np.asarray(self[name]) for name in self.dtype.names})
        return frame.set_index("time") if "time" in frame else frame


#: Names of cells in meshio, and what the points of each cell are in the order of VTK.
_MESHIO = {"point1": "vertex", "line2": "line", "line3": "line3", "tri3": "triangle", "tri6": "triangle6", "quad4": "quad",
           "quad8": "quad8", "quad9": "quad9", "tet4": "tetra", "tet10": "tetra10", "hex8": "hexahedron",
           "hex20": "hexahedron20", "hex27": "hexahedron27", "wedge6": "wedge", "wedge15": "wedge15"}


_TIMES = ("s", "min", "h", "d", "a")


class Mesh:
    """Points and cells of all bodies, one body after the other, as they were before the deformation.

    points: n x 3, in the unit of length of the model.
    cells: nodes by type ("hex20"), cells x nodes, in the order of VTK.
    groups: nodes by the names of the groups of the mesh; empty for results of a directory, which do not have them.
    bodies: their names; the array `body` of the fields has their numbers.
    """

    def __init__(self, points: np.ndarray, blocks: list[tuple[str, int, np.ndarray]], groups: dict[str, np.ndarray],
                 texts: dict[str, list[str]]) -> None:
        self.points, self._blocks, self.groups = points, blocks, groups
        self.bodies: list[str] = texts.get("bodies", [])
        self.contacts: list[str] = texts.get("contacts", [])

    @classmethod
    def _of(cls, mesh: Any, groups: dict[str, np.ndarray]) -> Mesh:
        return cls(mesh.points, mesh.cells, groups, mesh.texts)

    @cached_property
    def cells(self) -> dict[str, np.ndarray]:
        kinds = dict.fromkeys(kind for kind, _, _ in self._blocks)
        return {kind: np.concatenate([nodes for name, _, nodes in self._blocks if name == kind]) for kind in kinds}

    def to_meshio(self, fields: Fields | None = None) -> Any:
        """A mesh of meshio, with fields at its points. Needs meshio."""
        import meshio

        return meshio.Mesh(self.points, [(_MESHIO[kind], nodes) for kind, _, nodes in self._blocks],
                           point_data={} if fields is None else dict(fields))

    def to_pyvista(self, fields: Fields | None = None) -> Any:
        """An UnstructuredGrid of pyvista, with fields at its points. Needs pyvista."""
        import pyvista

        cells = [np.column_stack([np.full(len(nodes), nodes.shape[1]), nodes]).ravel() for _, _, nodes in self._blocks]
        types = [np.full(len(nodes), vtk, np.uint8) for _, vtk, nodes in self._blocks]
        grid = pyvista.UnstructuredGrid(np.concatenate(cells), np.concatenate(types), self.points)
        for name, values in (fields or {}).items():
            grid.point_data[name] = values
        return grid

    def __repr__(self) -> str:
        return f"<Mesh of {len(self.points)} points, {', '.join(f'{len(n)} {k}' for k, n in self.cells.items())}>"


class Fields(Mapping[str, np.ndarray]):
    """The fields of one output time, by the names of the field files without units: fields["von_mises"].

    Values are at the points of Run.mesh: n for scalars, n x 3 for vectors, n x 6 for tensors, in the order xx, yy, zz, xy,
    yz, zx. They are read-only. `cells` has the means of the elements, `contacts` the values at the points of
    Run.contact_mesh; both are empty for results of a directory.
    """

    def __init__(self, time: float, points: Mapping[str, Any], cells: Mapping[str, np.ndarray],
                 contacts: Mapping[str, np.ndarray]) -> None:
        self.time, self._points, self.cells, self.contacts = time, points, cells, contacts

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self._points:
            raise KeyError(f"there is no field '{name}'; there are: {', '.join(self._points)}")
        return self._points[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._points)

    def __len__(self) -> int:
        return len(self._points)

    def __repr__(self) -> str:
        return f"<Fields at t = {self.time:g}: {', '.join(self._points)}>"


class _InMemory:
    """What a run has left in memory."""

    def __init__(self, result: Any, probes: list[str]) -> None:
        self._result, self._probes = result, probes

    def history(self) -> dict[str, np.ndarray]:
        times = self._result.times
        values = self._result.probe_values(max(1, len(self._probes))).reshape(len(times), -1)
        return {"time": times} | {name: values[:, i] for i, name in enumerate(self._probes)}

    def steps(self) -> dict[str, np.ndarray]:
        return self._result.steps

    def cycles(self) -> dict[str, np.ndarray]:
        return {}

    def summary(self) -> dict[str, Any]:
        return json.loads(self._result.summary)

    def field_times(self) -> list[float]:
        return self._result.field_times

    def fields(self, time: float) -> Fields:
        return Fields(time, *self._result.fields(time))

    def mesh(self) -> Mesh:
        return Mesh._of(self._result.mesh, self._result.groups)

    def contact_mesh(self) -> Mesh:
        return Mesh._of(self._result.contact_mesh, {})


def _without_unit(name: str) -> str:
    return name[:name.rindex(" [")] if name.endswith("]") and " [" in name else name


class _FileFields(Mapping[str, np.ndarray]):
    """The arrays of a file, each read when it is asked for."""

    def __init__(self, file: Any) -> None:
        self._file, self._names = file, {_without_unit(name): name for name in file.names()}

    def __getitem__(self, name: str) -> np.ndarray:
        return self._file.values(self._names[name])

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)


class _InDirectory:
    """What a run has left in its directory."""

    def __init__(self, directory: Path) -> None:
        self._directory = directory
        if not (directory / "history.csv").is_file():
            raise ConfigError(f"'{directory}' is not the directory of a run: it has no history.csv")

    def _table(self, name: str) -> dict[str, np.ndarray]:
        path = self._directory / name
        return _core.csv_table(path) if path.is_file() else {}

    def history(self) -> dict[str, np.ndarray]:
        return self._table("history.csv")

    def steps(self) -> dict[str, np.ndarray]:
        return self._table("steps.csv")

    def cycles(self) -> dict[str, np.ndarray]:
        return self._table("cycles.csv")

    def summary(self) -> dict[str, Any]:
        path = self._directory / "summary.json"
        return json.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}

    def _files(self, name: str) -> dict[float, Path]:
        path = self._directory / name
        return dict(_core.field_list(path)) if path.is_file() else {}

    def field_times(self) -> list[float]:
        return list(self._files("fields.pvd"))

    def fields(self, time: float) -> Fields:
        return Fields(time, _FileFields(_core.FieldFile(self._files("fields.pvd")[time])), {}, {})

    def _mesh(self, name: str) -> Mesh:
        files = self._files(name)
        if not files:
            return Mesh(np.empty((0, 3)), [], {}, {})
        return Mesh._of(_core.FieldFile(next(iter(files.values()))).mesh(), {})

    def mesh(self) -> Mesh:
        return self._mesh("fields.pvd")

    def contact_mesh(self) -> Mesh:
        return self._mesh("contact.pvd")


class _Copied:
    """Results that came from another process."""

    def __init__(self, source: Any) -> None:
        self._tables = {name: dict(getattr(source, name)()) for name in ("history", "steps", "cycles", "summary")}
        self._fields = {}
        for time in source.field_times():
            fields = source.fields(time)
            self._fields[time] = Fields(time, dict(fields), dict(fields.cells), dict(fields.contacts))
        self._meshes = source.mesh(), source.contact_mesh()

    def history(self) -> dict[str, np.ndarray]:
        return self._tables["history"]

    def steps(self) -> dict[str, np.ndarray]:
        return self._tables["steps"]

    def cycles(self) -> dict[str, np.ndarray]:
        return self._tables["cycles"]

    def summary(self) -> dict[str, Any]:
        return self._tables["summary"]

    def field_times(self) -> list[float]:
        return list(self._fields)

    def fields(self, time: float) -> Fields:
        return self._fields[time]

    def mesh(self) -> Mesh:
        return self._meshes[0]

    def contact_mesh(self) -> Mesh:
        return self._meshes[1]


class Run:
    """The results of a run. They can be pickled."""

    def __init__(self, source: Any, directory: Path | None) -> None:
        self._source = source
        self.directory = directory  #: of the result files; None: in memory

    @classmethod
    def in_memory(cls, result: Any, probes: list[str]) -> Run:
        return cls(_InMemory(result, probes), None)

    @classmethod
    def in_directory(cls, directory: Path) -> Run:
        return cls(_InDirectory(directory), directory)

    def __getstate__(self) -> dict[str, Any]:
        source = self._source if isinstance(self._source, (_InDirectory, _Copied)) else _Copied(self._source)
        return {"_source": source, "directory": self.directory}

    @cached_property
    def history(self) -> Table:
        """A row for each output time: `time` and the probes, as in history.csv."""
        return Table.of(self._source.history())

    @cached_property
    def steps(self) -> Table:
        """A row for each accepted step, as in steps.csv."""
        return Table.of(self._source.steps())

    @cached_property
    def cycles(self) -> Table:
        """A row for each cycle, as in cycles.csv; empty without `time.cycle`, and for results in memory."""
        return Table.of(self._source.cycles())

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The content of summary.json."""
        return self._source.summary()

    @property
    def status(self) -> str:
        return self.summary.get("status", "interrupted")

    @property
    def events(self) -> dict[str, float | None]:
        """Time of each event; None: it has not happened."""
        return self.summary.get("events", {})

    @property
    def criteria(self) -> dict[str, dict[str, Any]]:
        """What is demanded, found and allowed, by the names of the criteria."""
        return self.summary.get("criteria", {})

    @property
    def warnings(self) -> list[str]:
        return self.summary.get("warnings", [])

    @cached_property
    def times(self) -> list[float]:
        """The times of which there are fields."""
        return self._source.field_times()

    def fields(self, time: float | None = None) -> Fields:
        """The fields at an output time; None: the last one."""
        times = self.times
        if not times:
            raise KeyError("the run has no fields (output.fields)")
        if time is None:
            return self._source.fields(times[-1])
        nearest = min(times, key=lambda t: abs(t - time))
        if abs(nearest - time) > 1e-9 * max(abs(times[-1]), abs(time)):
            raise KeyError(f"there are no fields at t = {time:g}; there are at: {', '.join(f'{t:g}' for t in times)}")
        return self._source.fields(nearest)

    @cached_property
    def mesh(self) -> Mesh:
        return self._source.mesh()

    @cached_property
    def contact_mesh(self) -> Mesh:
        """The contact surfaces; without points if there are none."""
        return self._source.contact_mesh()

    def plot(self, *probes: str, log_time: bool = True) -> Any:
        """Draws probes over time, all if none are named. Returns a figure of matplotlib, which is needed."""
        from matplotlib.figure import Figure

        history, known = self.history, self.summary.get("probes", {})
        names = probes or history.dtype.names[1:]
        for name in names:
            if name not in history.dtype.names[1:]:
                raise KeyError(f"there is no probe '{name}'; there are: {', '.join(history.dtype.names[1:])}")
        units: dict[str, list[str]] = {}
        for name in names:
            units.setdefault(known.get(name, {}).get("unit") or "", []).append(name)
        figure = Figure(figsize=(7, 2.2 * max(1, len(units))), layout="constrained")
        panels = figure.subplots(len(units) or 1, sharex=True, squeeze=False)[:, 0]
        for panel, (unit, group) in zip(panels, units.items()):
            for name in group:
                panel.plot(history["time"], history[name], marker=".", label=name)
            panel.set_ylabel(unit)
            panel.legend(frameon=False)
            panel.grid(alpha=0.3)
            positive = history["time"][history["time"] > 0]
            if log_time and len(positive) > 1 and positive[-1] > 1000 * positive[0]:
                panel.set_xscale("symlog", linthresh=positive[0])
        words = [word.strip() for word in str(self.summary.get("units", "")).split(",")]
        unit = next((word for word in words if word in _TIMES), "")
        panels[-1].set_xlabel(f"time [{unit}]" if unit else "time")
        return figure

    def __repr__(self) -> str:
        return f"<Run {self.summary.get('title', '')!r}: {self.status} at t = {self.summary.get('time_reached', 0):g}>"


def open(directory: str | os.PathLike[str]) -> Run:  # noqa: A001: the name that users expect
    """The results of a run of the command, or of Model.run(output=...), in a directory."""
    return Run.in_directory(Path(directory))
