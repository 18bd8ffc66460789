"""A model: a configuration that can be changed, checked and run."""

from __future__ import annotations

import inspect
import itertools
import logging
import os
import re
import tomllib
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from . import _core, _keys, _toml
from .errors import ConfigError, SolverError
from .results import Run

logger = logging.getLogger("creepcontact")
_VARIABLES = ["q", "T", "t", "eps"]
_numbers = itertools.count(1)  # a rate is another one, whatever its name
_LEVELS = (logging.DEBUG, logging.INFO, logging.WARNING, logging.ERROR)


def _log(level: int, message: str) -> None:
    logger.log(_LEVELS[level], "%s", message)


def _without_warnings(function: Any) -> Any:
    """Where a rate is infinite, as some are at the first strain, numpy would warn."""
    if function is None:
        return None

    def quiet(*arguments: Any) -> Any:
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            return function(*arguments)

    return quiet


class State:
    """A state of a run as an observer sees it, within the call that gets it."""

    def __init__(self, state: Any, probes: list[str]) -> None:
        self._state, self._probes = state, probes

    @property
    def time(self) -> float:
        return self._state.time

    @property
    def step(self) -> float:
        """Length of the step that ends here; 0 at output times within it."""
        return self._state.step

    @property
    def steps(self) -> int:
        """Accepted steps so far."""
        return self._state.steps

    @property
    def probes(self) -> dict[str, float]:
        """The values of all probes here. May cost an elastic solve."""
        return dict(zip(self._probes, self._state.probe_values))


class _Observer:
    """Passes states on to an observer of the user, or to a function that shows progress."""

    def __init__(self, target: Any, probes: list[str]) -> None:
        self._target, self._probes = target, probes

    def _call(self, method: str, state: Any) -> bool:
        function = getattr(self._target, method, None)
        return function is None or function(State(state, self._probes)) is not False

    def on_step(self, state: Any) -> bool:
        return self._call("on_step", state)

    def on_output(self, state: Any) -> bool:
        return self._call("on_output", state)


class _Progress:
    def __init__(self, function: Callable[[float, float], Any], end: float) -> None:
        self._function, self._end = function, end

    def on_step(self, state: State) -> Any:
        return self._function(state.time, min(1.0, state.time / self._end) if self._end > 0 else 1.0)


class Model:
    """A configuration, from a file or a dict.

    Keys are attributes, with completion and descriptions: `model.time.end`, `model.contacts[0].gap = -0.05`; any key can
    be set as an item: `model["materials.rotor.creep[0].A"] = 2e-18`. A value that is not allowed raises ConfigError
    and changes nothing. The mesh and the factors of the stiffness are kept from run to run, and used again as long as
    nothing changes that they depend on.

    A model belongs to one thread at a time; several models may run in several threads.
    """

    def __init__(self, source: str | os.PathLike[str] | Mapping[str, Any], set: Mapping[str, Any] | None = None, *,
                 directory: str | os.PathLike[str] = ".", trust_geometry: bool = False) -> None:
        """
        source: path of a configuration (.toml), or a dict as such a file would have it.
        set: values of keys, instead of those of the source: {"contacts[0].gap": -0.06}.
        directory: to which paths in a dict are relative; files have their own.
        trust_geometry: let a .geo run programs and write files.
        Raises ConfigError with all mistakes.
        """
        if isinstance(source, Mapping):
            self._text: str | None = _toml.document(source)
            self._file = Path(directory) / "model.toml"
        else:
            self._text, self._file = None, Path(source)
        self._trusts = trust_geometry
        self._values: dict[str, Any] = dict(set or {})
        self._kept, self._raised = _core.Kept(), _core.Raised()
        self._rates: dict[str, tuple[Any, ...]] = {}
        self._read(self._values)

    def _read(self, values: Mapping[str, Any]) -> None:
        overrides = [f"{key}={_toml.value(value, key)}" for key, value in values.items()]
        try:
            if self._text is None:
                config = _core.Config.read(self._file, overrides)
            else:
                config = _core.Config.parse(self._text, self._file, overrides)
        except ConfigError as error:  # the option of the command is the argument `set` here
            raise ConfigError(re.sub(r"^--set ", "set ", str(error), flags=re.M)) from None
        config.trust_geometry(self._trusts)
        for material, (text, variables, function, derivative) in self._rates.items():
            if hasattr(function, "address"):
                config.set_rate_at(material, text, variables, function.address, function)
            else:
                config.set_rate(material, text, variables, _without_warnings(function), _without_warnings(derivative), self._raised)
        self._config, self._document = config, None

    def __getstate__(self) -> Any:
        raise TypeError("models are not pickled; pickle the source and what is set, or results")

    # Keys

    def __setitem__(self, key: str, value: Any) -> None:
        values = {k: v for k, v in self._values.items() if k != key} | {key: value}
        self._read(values)
        self._values = values

    def __getitem__(self, key: str) -> Any:
        """The value of a key as the configuration has it; None if it is not given."""
        return self.value(key)

    def value(self, key: str) -> Any:
        """The value of a key or of a whole table as the configuration has it; None if it is not given."""
        if self._document is None:
            self._document = tomllib.loads(self._config.to_toml())
        return _keys.find(self._document, key)

    def __getattr__(self, name: str) -> Any:
        node = _keys.schema().below.get(name) if not name.startswith("_") else None
        if node is None:
            raise AttributeError(f"a model has no key '{name}'; the tables are: {', '.join(_keys.schema().below)}")
        return _keys.view(self, name, node)

    def __setattr__(self, name: str, value: Any) -> None:
        if name.startswith("_"):
            object.__setattr__(self, name, value)
        elif name in _keys.schema().below:
            self[name] = value
        else:
            raise AttributeError(f"a model has no key '{name}'; the tables are: {', '.join(_keys.schema().below)}")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *_keys.schema().below]

    def set_rate(self, material: str, rate: Callable[..., Any], derivative: Callable[..., Any] | None = None,
                 uses: Sequence[str] | None = None) -> None:
        """Gives a material a creep law of your own, instead of those of the configuration.

        rate: the equivalent creep rate of arrays q (von Mises stress), T, t and eps (creep strain of this law so far),
            one entry for each point; a parameter that the function does not name is not passed. It must be a pure
            function, of positive values. Or a function compiled by numba.cfunc("float64(float64, float64, float64,
            float64)") with the arguments q, T, t, eps, which any thread calls without the interpreter.
        derivative: of the same arguments; returns df/dq and df/deps. Without it differences are taken, in four further
            calls.
        uses: the arguments in their order, where the function does not tell them; a compiled one: those that it
            depends on.
        An exception in it ends the run and is raised there.
        """
        if uses is None:
            uses = _VARIABLES if hasattr(rate, "address") else list(inspect.signature(rate).parameters)
        wrong = [name for name in uses if name not in _VARIABLES]
        if wrong or not uses:
            raise ValueError(f"a rate has arguments of {', '.join(_VARIABLES)}; found: {', '.join(wrong) or 'none'}")
        text = f"{getattr(rate, '__qualname__', None) or type(rate).__name__} of Python, {next(_numbers)}"
        before = dict(self._rates)
        self._rates[material] = (text, list(uses), rate, derivative)
        try:
            self._read(self._values)
        except Exception:
            self._rates = before
            self._read(self._values)
            raise

    def to_toml(self) -> str:
        """The configuration as a file would have it, without keys that have their defaults."""
        return self._config.to_toml()

    def variant(self, set: Mapping[str, Any] | None = None) -> Model:
        """Another model with further values, which shares the kept mesh and factors."""
        other = object.__new__(Model)
        for member in ("_text", "_file", "_trusts", "_kept"):  # shared
            object.__setattr__(other, member, getattr(self, member))
        other._raised, other._rates = _core.Raised(), dict(self._rates)
        other._values = self._values | dict(set or {})
        other._read(other._values)
        return other

    # Runs

    def check(self, *, start: bool = False) -> str:
        """Reads the mesh and makes the model; nothing is run. Returns what `creepcontact check` prints.

        start: solve t = 0 too. Raises ConfigError or ModelError as run() would before its first step.
        """
        return self._config.check(start)

    def start(self, threads: int = 1) -> Run:
        """The equilibrium at t = 0 with its fields, as a run that ends there. Nothing creeps."""
        return self._run(self._config.at_start(), threads, None, False, [])

    def run(self, threads: int = 1, output: str | os.PathLike[str] | None = None,
            progress: Callable[[float, float], Any] | None = None, observers: Iterable[Any] = (), *,
            resume: bool = False) -> Run:
        """Runs the model.

        threads: number of threads. The results do not depend on it, but for the last digits of large factors.
        output: directory of the result files, those of the command; None: the results stay in memory.
        progress: called after each step with the time and the share of the time that is done.
        observers: objects with `on_step(state)` and `on_output(state)`, both optional. One that returns False ends the
            run, which then is completed; one that raises ends it too, and its exception is raised here.
        resume: go on from the checkpoint in `output`.

        Raises SolverError with `.run`, the results up to there, if a solver fails; KeyboardInterrupt with `.run` after
        Ctrl-C, with `output` after a checkpoint.
        """
        watching = list(observers)
        if progress is not None:
            watching.append(_Progress(progress, self._config.end))
        return self._run(self._config, threads, output, resume, watching)

    def _run(self, config: Any, threads: int, output: str | os.PathLike[str] | None, resume: bool, observers: list[Any]) -> Run:
        if isinstance(threads, bool) or not isinstance(threads, int) or threads < 1:
            raise ValueError(f"threads = {threads!r}; a whole number from 1 on is needed")
        if resume and output is None:
            raise ValueError("only a run in a directory can be resumed; give output")
        probes = config.probes
        result = _core.run(config=config, kept=self._kept, threads=threads,
                           output=None if output is None else os.fspath(output), resume=resume,
                           observers=[_Observer(observer, probes) for observer in observers], log=_log, raised=self._raised)
        run = Run.in_memory(result, probes) if output is None else Run.in_directory(Path(output))
        if result.exit_status == 0:
            return run
        error: BaseException = (KeyboardInterrupt(result.message) if result.exit_status == 130
                                else SolverError(result.message))
        error.run = run  # type: ignore[attr-defined]
        raise error

    @property
    def counters(self) -> dict[str, int]:
        """What all runs of this model and its variants together have read and factored.

        meshes_read: meshes that were read or made; factorizations: of the stiffness of one body; factors_found: those
        that an earlier run had left.
        """
        return {name: getattr(self._kept, name) for name in ("meshes_read", "factorizations", "factors_found")}

    def __repr__(self) -> str:
        return f"<Model {self._config.title!r} of {self._file}>"
