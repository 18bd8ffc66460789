"""The keys of a configuration as attributes of Python, made of the declarations that the program reads them by."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from functools import cache
from typing import TYPE_CHECKING, Any

from . import _core

if TYPE_CHECKING:
    from .model import Model


class _Node:
    """A key or a table of the schema with what is below it."""

    def __init__(self) -> None:
        self.info: dict[str, Any] = {}
        self.below: dict[str, _Node] = {}  # "[]": each entry of a list; "<>": each of a name that users choose

    def child(self, name: str) -> _Node:
        return self.below.setdefault(name, _Node())


@cache
def schema() -> _Node:
    top = _Node()
    for info in _core.keys():
        node = top
        for part in re.findall(r"<\w+>|\[\]|[^.\[\]<>]+", info["path"]):
            node = node.child("<>" if part.startswith("<") else part)
        if not node.info:
            node.info = info
    return top


def _describe(node: _Node) -> str:
    info = node.info
    if not info:
        return "A table of keys."
    text = info["description"].replace("`", "")
    if info["form"] == "value" and info["type"]:
        text += f"\n\nAllowed: {info['type']}."
    if info["default"]:
        text += f"\nDefault: {info['default']}."
    return text


def _is_part(node: _Node) -> bool:
    return bool(node.below)


class Table:
    """A table of the configuration: its keys are attributes. Setting one reads the configuration again."""

    _node: _Node

    def __init__(self, model: Model, path: str) -> None:
        object.__setattr__(self, "_model", model)
        object.__setattr__(self, "_path", path)

    def __setattr__(self, name: str, value: Any) -> None:
        if name not in self._node.below:
            raise AttributeError(f"{self._path or 'the configuration'} has no key '{name}'; allowed: {', '.join(self._node.below)}")
        self._model[_joined(self._path, name)] = value

    def __repr__(self) -> str:
        return f"<{self._path or 'configuration'}: {self._model.value(self._path)!r}>"


class List:
    """Tables of one kind, by number."""

    def __init__(self, model: Model, path: str, node: _Node) -> None:
        self._model, self._path, self._node = model, path, node

    def __len__(self) -> int:
        return len(self._model.value(self._path) or [])

    def __getitem__(self, index: int) -> Any:
        n = len(self)
        if not -n <= index < n:
            raise IndexError(f"{self._path}[{index}]: there are {n}")
        return view(self._model, f"{self._path}[{index % n}]", self._node.below["[]"])

    def __iter__(self) -> Iterator[Any]:
        return (self[i] for i in range(len(self)))

    def __repr__(self) -> str:
        return f"<{self._path}: {self._model.value(self._path)!r}>"


class Named:
    """Tables of one kind, by the names that the user has chosen: as keys, and as attributes."""

    def __init__(self, model: Model, path: str, node: _Node) -> None:
        self._model, self._path, self._node = model, path, node

    def keys(self) -> list[str]:
        return list(self._model.value(self._path) or {})

    def __len__(self) -> int:
        return len(self.keys())

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __getitem__(self, name: str) -> Any:
        if name not in self.keys():
            raise KeyError(f"{self._path} has no '{name}'; there are: {', '.join(self.keys())}")
        return view(self._model, _joined(self._path, name), self._node.below["<>"])

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self[name]
        except KeyError as error:
            raise AttributeError(error.args[0]) from None

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.keys()]

    def __repr__(self) -> str:
        return f"<{self._path}: {', '.join(self.keys())}>"


def _joined(path: str, name: str) -> str:
    plain = re.fullmatch(r"[A-Za-z0-9_-]+", name)
    name = name if plain else '"' + name.replace("\\", "\\\\").replace('"', '\\"') + '"'
    return f"{path}.{name}" if path else name


def _property(name: str, node: _Node) -> property:
    def get(self: Table) -> Any:
        return view(self._model, _joined(self._path, name), node)

    def put(self: Table, value: Any) -> None:
        self._model[_joined(self._path, name)] = value

    return property(get, put, doc=_describe(node))


@cache
def table_class(node: _Node) -> type[Table]:
    """A class whose properties are the keys of a table, with their descriptions."""
    members: dict[str, Any] = {name: _property(name, below) for name, below in node.below.items() if name.isidentifier()}
    return type("Table", (Table,), {**members, "_node": node, "__doc__": _describe(node)})


def view(model: Model, path: str, node: _Node) -> Any:
    """What stands under a key: a value, or an object for what is below it."""
    value = model.value(path)
    if "[]" in node.below and node.below["[]"].below and not (value is not None and not isinstance(value, list)):
        return List(model, path, node)
    if "<>" in node.below and (value is None or isinstance(value, dict)):
        return Named(model, path, node)
    if set(node.below) - {"[]", "<>"} and (value is None or isinstance(value, dict)):
        return table_class(node)(model, path)
    if value is None and node.info.get("default"):
        try:
            return tomllib.loads("value = " + node.info["default"])["value"]
        except tomllib.TOMLDecodeError:
            return node.info["default"]
    return value


def find(document: Any, path: str) -> Any:
    """The value of a key in a document; None if it is not there."""
    for part in re.findall(r'"(?:[^"\\]|\\.)*"|\[\d+\]|[^.\[\]"]+', path):
        if document is None:
            return None
        if part.startswith("["):
            number = int(part[1:-1])
            document = document[number] if isinstance(document, list) and number < len(document) else None
            continue
        if part.startswith('"'):
            part = tomllib.loads("value = " + part)["value"]
        document = document.get(part) if isinstance(document, dict) else None
    return document
