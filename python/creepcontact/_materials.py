"""Creep laws and materials without a model: rates, creep curves, relaxation, published data, and fits to tests."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from . import _core, _toml


@dataclass(frozen=True)
class CreepCurve:
    """Creep strain of a bar over time; NaN after rupture."""

    time: np.ndarray
    strain: np.ndarray
    rupture: float | None  #: time of rupture, if it is within the times


@dataclass(frozen=True)
class Material:
    """A material as a bar under uniaxial stress, in its own units."""

    name: str
    _bar: Any = field(repr=False)
    units: str = ""  #: as `units` of a configuration; empty: those of whoever made it
    source: str = ""  #: citation
    status: str = ""  #: how well the data are confirmed
    stress_range: tuple[float, float] | None = None  #: of the data
    temperature_range: tuple[float, float] | None = None
    time_range: tuple[float, float] | None = None
    has_elasticity: bool = True

    @property
    def laws(self) -> list[str]:
        """The creep laws; their rates add."""
        return self._bar.laws

    def young_modulus(self, temperature: Any = 0.0) -> Any:
        """Young's modulus at temperatures: a number or an array like the argument."""
        self._require_elasticity()
        return self._bar.young_modulus(temperature)

    def rate(self, stress: Any, temperature: Any = 0.0, time: Any = 0.0, strain: Any = 0.0) -> Any:
        """Creep rate along the bar. The arguments are numbers or arrays that broadcast.

        time: since the load began, for laws that depend on it. strain: creep strain so far, for hardening laws; a law
        that knows more of its past takes only 0.
        """
        np.broadcast_shapes(*map(np.shape, (stress, temperature, time, strain)))  # ValueError where they do not fit
        return self._bar.rate(stress, temperature, time, strain)

    def creep_curve(self, stress: float, times: Any, temperature: float = 0.0) -> CreepCurve:
        """Creep strain under constant stress at increasing times."""
        strain, _, rupture = self._bar.history(stress, times, temperature, np.inf)
        return CreepCurve(np.asarray(times, float), strain, rupture)

    def relaxation(self, stress: float, times: Any, temperature: float = 0.0, young_modulus: float | None = None) -> np.ndarray:
        """Stress of a bar of constant length that begins at `stress`, at increasing times.

        young_modulus: that of the material if not given.
        """
        if young_modulus is None:
            self._require_elasticity()
            young_modulus = float(self._bar.young_modulus(temperature))
        _, stresses, _ = self._bar.history(stress, times, temperature, young_modulus)
        return stresses

    def _require_elasticity(self) -> None:
        if not self.has_elasticity:
            raise ValueError(f"{self.name} has no Young's modulus; give young_modulus")


def laws() -> dict[str, str]:
    """The creep laws with their formulas."""
    return _core.laws()


def law(name: str, young_modulus: Any = None, **constants: Any) -> Material:
    """A creep law with its constants: numbers, expressions of T, or tables {"T": [...], "values": [...]}.

    cc.law("norton", A=2e-18, n=5).rate(100.0). Raises ConfigError for unknown names and impossible values.
    """
    return Material(name, _core.law(name, constants, young_modulus), has_elasticity=young_modulus is not None)


def material(use: str, units: str = "") -> Material:
    """A material of the library of published data: cc.material("grade_91/swindeman_1999").

    units: as `units` of a configuration, "mm, N, MPa, h, degC"; those of the library file if empty.
    """
    entry = _core.library_entry(use, units)
    return Material(entry["name"], entry["bar"], entry["units"], entry["source"], entry["status"], entry["stress_range"],
                    entry["temperature_range"], entry["time_range"], entry["has_elasticity"])


def materials(word: str = "") -> list[str]:
    """The names that material() takes, those that contain a word."""
    return [name for name in _core.library_names() if word.lower() in name.lower()]


@dataclass(frozen=True)
class Fit:
    """Constants of a law that were fitted to tests."""

    material: Material
    values: dict[str, float]
    low: dict[str, float]  #: 95 % confidence
    high: dict[str, float]
    units: dict[str, str]
    correlation: np.ndarray  #: of the constants in the order of `values`
    deviation: float  #: standard deviation of the residuals, logarithms of ratios
    warnings: list[str]
    report: str = field(repr=False)  #: what the command prints
    toml: str = field(repr=False)  #: the material block for a configuration
    #: factor of each batch on one constant, if the data have a column `batch`; the constants are those of the mean batch
    batches: dict[str, float] = field(default_factory=dict)
    batch_deviation: float | None = None  #: from batch to batch, of the logarithm of that constant


def fit(data: str | os.PathLike[str], law: str, *, set: Mapping[str, Any] | None = None, free: Sequence[str] = (),
        young_modulus: Any = None, temperature: float | None = None) -> Fit:
    """Fits a creep law to measured tests, as `creepcontact fit` does.

    data: CSV with the columns time, stress, strain and so on, with units. set: constants that are held. free: optional
    constants that are fitted too. young_modulus: the column strain is then the total strain. temperature: only tests
    near it. Raises ConfigError if the data do not fit the law.
    """
    held = [f"{key}={_toml.value(value, key)}" for key, value in (set or {}).items()]
    found = _core.fit(data, law, held, list(free), young_modulus, temperature)
    bar = found.pop("bar")
    return Fit(Material(law, bar, has_elasticity=young_modulus is not None), found["values"], found["low"], found["high"],
               found["units"], found["correlation"], found["deviation"], found["warnings"], found["report"], found["block"],
               found["batches"], found["batch_deviation"])
