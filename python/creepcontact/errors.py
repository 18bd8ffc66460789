"""The errors that the library raises."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .results import Run


class Error(Exception):
    """Any error of creepcontact. `exit_status` is that of the command."""

    exit_status = 4


_PLACE = re.compile(r"(?P<file>.*?):(?P<line>\d+):(?P<column>\d+): (?P<rest>.*)", re.S)
_SET = re.compile(r"^set [^:]*: ")
_KEY = re.compile(r"(?P<key>[\w.\[\]<>-]+): (?P<rest>.*)", re.S)


@dataclass(frozen=True)
class Mistake:
    """One mistake in a configuration."""

    file: str
    line: int  #: from 1; 0: it has no place in the file
    column: int
    key: str  #: "time.end"; may be empty
    text: str  #: what was found, what is allowed, and the nearest name

    @classmethod
    def from_line(cls, line: str) -> Mistake:
        place = _PLACE.fullmatch(line)
        rest = place["rest"] if place else _SET.sub("", line)
        key = _KEY.fullmatch(rest)
        return cls(place["file"] if place else "", int(place["line"]) if place else 0, int(place["column"]) if place else 0,
                   key["key"] if key else "", key["rest"] if key else rest)


class ConfigError(Error):
    """A configuration that cannot be used. `mistakes` has all that were found, one by one."""

    exit_status = 2

    @property
    def mistakes(self) -> list[Mistake]:
        return [Mistake.from_line(line) for line in str(self).splitlines() if line]


class ModelError(Error):
    """A mesh or a model that cannot be computed: a group that is missing, a body that is free to move."""

    exit_status = 3


class SolverError(Error):
    """A run that failed. `run` has the results up to the failure; None if there are none."""

    exit_status = 4
    run: Run | None = None
