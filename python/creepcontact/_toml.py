"""Values of Python as TOML."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Mapping
from typing import Any


def value(data: Any, where: str = "") -> str:
    """The text of a value, on one line. TypeError names what has no form in TOML."""
    if hasattr(data, "tolist"):  # of numpy
        data = data.tolist()
    if isinstance(data, bool):
        return "true" if data else "false"
    if isinstance(data, int):
        return str(data)
    if isinstance(data, float):
        if not math.isfinite(data):
            raise ValueError(f"{where or 'a value'} is {data}; a finite number is needed")
        return repr(data)
    if isinstance(data, (str, os.PathLike)):
        # JSON escapes as TOML does, but for DEL.
        return json.dumps(os.fspath(data), ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(data, Mapping):
        return "{ " + ", ".join(f"{key(k)} = {value(v, f'{where}.{k}' if where else str(k))}" for k, v in data.items()) + " }"
    if isinstance(data, (list, tuple)):
        return "[" + ", ".join(value(v, f"{where}[{i}]") for i, v in enumerate(data)) + "]"
    raise TypeError(f"{where or 'a value'} is of the type {type(data).__name__}; allowed: numbers, texts, bool, lists and dicts of them")


def key(name: Any) -> str:
    if not isinstance(name, str):
        raise TypeError(f"{name!r} is not the name of a key")
    plain = name != "" and all(c.isascii() and (c.isalnum() or c in "_-") for c in name)
    return name if plain else value(name)


def document(data: Mapping[str, Any]) -> str:
    """A whole configuration, a line for each key at the top."""
    return "".join(f"{key(k)} = {value(v, str(k))}\n" for k, v in data.items())
