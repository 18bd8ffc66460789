#!/usr/bin/env python3
"""House rules of the source tree. usage: check.py RULE ROOT; exit status 0 kept, 1 broken, 77 could not be checked."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

SKIPPED = 77
LONG_FILE = 400  # lines

# Libraries that one module alone may see, by how their headers begin.
LIBRARY_HOME = {
    "toml++/": "config",
    "toml.hpp": "config",
    "gmsh.h": "mesher",
    "ceres/": "optimizer",
    "pybind11/": "python",
    "boost/geometry": "mesh",
    "boost/process": "platform",
    "mpi.h": "mpi",
    "dmumps_c.h": "mpi",
    "metis.h": "mpi",
    "petscksp.h": "mpi",
    **{f"{part}/": "ode" for part in ("arkode", "cvode", "cvodes", "ida", "kinsol", "nvector", "sundials", "sunlinsol",
                                      "sunmatrix", "sunnonlinsol")},
}
MODULE_DECLARATION = re.compile(r"\bcreepcontact_(?:module|program|plugin|extension)\(\s*(\w+)([^)]*)\)")
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
# Put together here so that this file keeps the rule itself.
# A path that goes on from a name, as in docs/work/, is relative.
# A line that runs it: in a first line, before an option, a script or a text from a pipe.
STARTED_PYTHON = re.compile(r"^#!.*\bpython3?\b|(?:^|[|;&(]\s*)python3? +[-\w/]")
ISOLATED_PYTHON = re.compile(r"\bpython3? +-I\b")
MACHINE_PATHS = re.compile(r"(?<![\w.})])/(?:" + "|".join(["work/", "tmp/b_", "home/[a-z]", "root/"]) + ")")
DECOMPOSITION = re.compile(r"\w*(?:SVD\b|Svd\b|HouseholderQR|householderQr|HouseholderQr|EigenSolver|OrthogonalDecomposition|[fF]ullPivLU|fullPivLu)|Eigen/(?:QR|SVD|Eigenvalues)")
BUILD_DIRECTORIES = {".git", "build", "results", "__pycache__"}


def declared_modules(root):
    """What CMake links each module to: {module: (public, private)}. No other list says what a module may include."""
    modules = {}
    for path in [root / "CMakeLists.txt", *sorted((root / "cmake").glob("*.cmake"))]:
        text = re.sub(r"#.*", "", path.read_text(encoding="utf-8")) if path.is_file() else ""
        for name, arguments in MODULE_DECLARATION.findall(text):
            parts = re.split(r"\b((?:PRIVATE_)?USES)\b", arguments)
            listed = dict(zip(parts[1::2], parts[2::2]))
            modules[name] = tuple(re.findall(r"\bcreepcontact_(?!options\b)(\w+)", listed.get(key, ""))
                                  for key in ("USES", "PRIVATE_USES"))
    return modules


def allowed_modules(modules, module):
    """The module itself, what it is linked to, and what those pass on."""
    found, pending = {module}, [*modules[module][0], *modules[module][1]]
    while pending:
        current = pending.pop()
        if current not in found:
            found.add(current)
            pending += modules[current][0]
    return found


def tracked_files(root):
    """What git tracks; all but build directories where there is no git."""
    if shutil.which("git") and (root / ".git").exists():
        listed = subprocess.run(["git", "-c", f"safe.directory={root}", "-C", str(root), "ls-files", "-z"],
                                capture_output=True, text=True)
        if listed.returncode == 0:
            return [path for name in listed.stdout.split("\0") if name and (path := root / name).is_file()]
    files = []
    for directory, subdirectories, names in os.walk(root):
        subdirectories[:] = [d for d in subdirectories if d not in BUILD_DIRECTORIES]
        files += [Path(directory) / name for name in names]
    return files


def cpp_files(root, *folders):
    return sorted(path for folder in folders for path in (root / folder).rglob("*") if path.suffix in (".hpp", ".cpp"))


def module_sources(root):
    """(module, file, line number, bracket, included name) of every include in the modules."""
    for tree in ("include/creepcontact", "src"):
        for path in cpp_files(root, tree):
            parts = path.relative_to(root / tree).parts
            if len(parts) < 2:
                yield None, path, 0, "", ""
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                if match := INCLUDE.match(line):
                    yield parts[0], path, number, *match.groups()


def is_private_header(root, module, path, name):
    """Whether the file lies in the module's own sources, at most in one of their subfolders."""
    found, home = (path.parent / name).resolve(), root / "src" / module
    return found.is_file() and home in (found.parent, found.parent.parent)


def module_includes(root):
    modules = declared_modules(root)
    for module, path, number, bracket, name in module_sources(root):
        where = f"{path.relative_to(root)}:{number}"
        if module not in modules:
            yield f"{where}: no module of CMakeLists.txt; declared are {', '.join(modules)}"
        elif name.startswith("creepcontact/"):
            other = name.split("/")[1]
            if bracket == "<":
                yield f'{where}: write #include "{name}"'
            allowed = allowed_modules(modules, module)
            if other not in allowed:
                yield f"{where}: module '{module}' includes '{other}'; it may include {', '.join(sorted(allowed))}"
        elif bracket == '"' and not is_private_header(root, module, path, name):
            yield f'{where}: "{name}" is neither "creepcontact/<module>/<file>.hpp" nor a file of src/{module}'


def public_headers(root):
    """A header of include/ serves another module or the program of somebody else's (tests/style/consumer), or a header
    that does; what a module alone uses lies in src/."""
    users = {}
    for module, path, _, _, name in module_sources(root):
        users.setdefault(name, []).append((module, path))
    for path in cpp_files(root, "tests/style/consumer"):
        for line in path.read_text(encoding="utf-8").splitlines():
            if match := INCLUDE.match(line):
                users.setdefault(match[2], []).append((None, path))
    home = root / "include"
    unknown = {path.relative_to(home).as_posix(): path for path in cpp_files(root, "include")}
    found = True
    while found:
        found = [name for name in unknown for module, path in users.get(name, [])
                 if module != name.split("/")[1]
                 or (home in path.parents and path.relative_to(home).as_posix() not in unknown)]
        for name in set(found):
            del unknown[name]
    yield from (f"include/{name}: no other module and no public header uses it; it belongs in src/" for name in unknown)


def module_table(root):
    """The table of docs/architecture.md says what CMake says."""
    text = (root / "docs/architecture.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `(?:src/)?(\w+)` \|.*\| ([^|]*) \|$", text, re.MULTILINE)
    told = {name: set(re.findall(r"`(\w+)`", uses)) for name, uses in rows}
    for name, (public, private) in declared_modules(root).items():
        if (uses := {*public, *private}) != told.pop(name, None):
            yield f"docs/architecture.md: module '{name}' is linked to {', '.join(sorted(uses)) or 'none'}"
    yield from (f"docs/architecture.md: no module '{name}' in CMake's lists" for name in told)


def library_includes(root):
    for module, path, number, _, name in module_sources(root):
        for start, home in LIBRARY_HOME.items():
            if name.startswith(start) and module != home:
                yield f"{path.relative_to(root)}:{number}: <{name}> belongs to module '{home}' alone"


def decompositions(root):
    """Templates that take long to compile are instantiated in one place."""
    for path in cpp_files(root, "include", "src"):
        inside = path.relative_to(root).as_posix()
        if inside.startswith("src/linalg/") or inside == "src/base/tensor.cpp":
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if match := DECOMPOSITION.search(line):
                yield f"{inside}:{number}: '{match.group()}' takes long to compile; linalg/dense.hpp has decompositions"


def formatting(root):
    tool = shutil.which("clang-format")
    if tool is None:
        print("skipped: clang-format is not installed (Debian package clang-format)")
        sys.exit(SKIPPED)
    files = [str(path.relative_to(root)) for path in cpp_files(root, "include", "src", "tests")]
    checked = subprocess.run([tool, "--dry-run", "-Werror", "--style=file", *files], cwd=root, capture_output=True,
                             text=True)
    if checked.returncode != 0:
        broken = sorted(set(re.findall(r"^(\S+?):\d+:\d+: error", checked.stderr, re.MULTILINE)))
        yield from (f"{name}: run clang-format -i on it" for name in broken or [checked.stderr.strip()])


def file_length(root):
    for path in tracked_files(root):
        if path.suffix in (".hpp", ".cpp", ".py", ".cmake"):
            lines = path.read_bytes().count(b"\n")
            if lines > LONG_FILE:
                yield f"warning: {path.relative_to(root)} has {lines} lines; does a second idea begin in it?"


def machine_paths(root):
    for path in tracked_files(root):
        try:
            text = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        for number, line in enumerate(text.splitlines(), 1):
            if match := MACHINE_PATHS.search(line):
                yield f"{path.relative_to(root)}:{number}: '{match.group()}' is a path of somebody's machine"


def isolated_interpreters(root):
    """Python, where the program and its scripts start it, imports nothing from the working directory or the environment."""
    for path in tracked_files(root):
        inside = path.relative_to(root)
        if inside.parts[0] not in ("scripts", "src"):
            continue
        try:
            text = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        for number, line in enumerate(text.splitlines(), 1):
            if STARTED_PYTHON.search(line) and not ISOLATED_PYTHON.search(line):
                yield f"{inside}:{number}: Python is started without -I: '{line.strip()}'"


RULES = {rule.__name__: rule for rule in (module_includes, public_headers, module_table, library_includes, decompositions, formatting,
                                         file_length, machine_paths, isolated_interpreters)}
WARNINGS = {"file_length"}  # printed, and kept all the same


def main(arguments):
    if len(arguments) != 2 or arguments[0] not in RULES:
        print(f"usage: check.py ({'|'.join(RULES)}) ROOT", file=sys.stderr)
        return 2
    broken = list(RULES[arguments[0]](Path(arguments[1]).resolve()))
    print("\n".join(broken) if broken else "kept")
    return 1 if broken and arguments[0] not in WARNINGS else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
