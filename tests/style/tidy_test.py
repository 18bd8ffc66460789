#!/usr/bin/env python3
"""scripts/tidy looks at the files that changed, and finds what is wrong with them."""

import contextlib
import importlib.util
import io
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from importlib.machinery import SourceFileLoader
from pathlib import Path

sys.dont_write_bytecode = True
SCRIPT = Path(__file__).resolve().parents[2] / "scripts/tidy"
LOADER = SourceFileLoader("tidy", str(SCRIPT))
tidy = importlib.util.module_from_spec(importlib.util.spec_from_loader("tidy", LOADER))
LOADER.exec_module(tidy)

DAY = 24 * 3600


class Tree(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name).resolve() / "work"
        self.root.mkdir()

    def write(self, name, text=""):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


@unittest.skipUnless(shutil.which("git"), "git is not installed")
class Changes(Tree):
    def setUp(self):
        super().setUp()
        self.git("init", "--quiet", "--initial-branch=main")

    def git(self, *arguments, days=0):
        date = f"{1700000000 + int(days * DAY)} +0000"
        who = {f"GIT_{role}_{what}": value for role in ("AUTHOR", "COMMITTER")
               for what, value in (("NAME", "n"), ("EMAIL", "e"), ("DATE", date))}
        subprocess.run(["git", "-C", str(self.root), *arguments], check=True, capture_output=True,
                       env={**os.environ, **who, "GIT_CONFIG_GLOBAL": "/dev/null"})

    def commit(self, days, *names):
        for name in names:
            self.write(name, f"// {days}\n")
        self.git("add", ".")
        self.git("commit", "--quiet", "--message", "m", days=days)

    def test_the_last_day_of_main_the_newest_first(self):
        self.commit(0, "src/a.cpp", "src/b.cpp")
        self.commit(1, "src/a.cpp")
        self.commit(1.5, "src/b.cpp", "README.md")
        self.commit(2.2, "include/c.hpp", "src/gone.cpp")
        self.commit(2.4, "tests/d.cpp", "scripts/e.cpp")
        self.git("rm", "--quiet", "src/gone.cpp")
        self.git("commit", "--quiet", "--message", "m", days=2.4)
        self.assertEqual(tidy.changed_files(self.root), ["tests/d.cpp", "include/c.hpp", "src/b.cpp"])

    def test_an_old_commit_alone_counts(self):
        self.commit(0, "src/a.cpp", "src/b.cpp")
        self.commit(9, "src/a.cpp")
        self.assertEqual(tidy.changed_files(self.root), ["src/a.cpp"])

    def test_what_is_not_committed_comes_first(self):
        self.commit(0, "src/a.cpp", "src/b.cpp")
        self.commit(9, "src/a.cpp")
        self.write("src/b.cpp", "changed")
        self.write("src/new.cpp")
        self.assertEqual(tidy.changed_files(self.root), ["src/b.cpp", "src/new.cpp", "src/a.cpp"])

    def test_a_branch_is_compared_with_where_it_left_main(self):
        self.commit(0, "src/a.cpp", "src/b.cpp")
        self.git("update-ref", "refs/remotes/origin/main", "HEAD")
        self.commit(1, "src/a.cpp")
        self.commit(9, "src/c.cpp")
        self.assertEqual(tidy.changed_files(self.root), ["src/c.cpp", "src/a.cpp"])
        self.assertEqual(tidy.changed_files(self.root, "HEAD~1"), ["src/c.cpp"])

    def test_a_clone_of_one_commit_has_all_files_in_an_order_of_its_own(self):
        names = [f"src/{letter}.cpp" for letter in "abcdefgh"]
        self.commit(0, *names)
        whole = self.root
        orders = []
        for days in (1, 2):
            self.root = whole
            self.commit(days, "src/a.cpp")
            clone = whole.parent / f"clone{days}"
            self.git("clone", "--quiet", "--depth", "1", f"file://{whole}", str(clone))
            orders.append(tidy.changed_files(clone))
        self.assertEqual([sorted(order) for order in orders], [names, names])
        self.assertNotEqual(*orders)


class Sources(Tree):
    def test_a_header_is_checked_through_a_source_that_includes_it(self):
        self.write("include/creepcontact/fem/a.hpp")
        self.write("src/base/z.cpp", '#include "creepcontact/fem/a.hpp"\n')
        self.write("src/fem/a.cpp", '#include "creepcontact/fem/a.hpp"\n#include "b.hpp"\n')
        self.write("src/fem/b.hpp", '#include "c.hpp"\n')
        self.write("src/fem/c.hpp")
        self.write("src/fem/unused.hpp")
        known = {"src/base/z.cpp", "src/fem/a.cpp"}
        files = ["src/fem/c.hpp", "src/fem/unused.hpp", "src/base/z.cpp", "include/creepcontact/fem/a.hpp", "src/fem/new.cpp"]
        self.assertEqual(tidy.sources_to_check(self.root, files, known), ["src/fem/a.cpp", "src/base/z.cpp"])


@unittest.skipUnless(shutil.which("clang-tidy"), "clang-tidy is not installed")
class Findings(Tree):
    def setUp(self):
        super().setUp()
        shutil.copy(SCRIPT.parents[1] / ".clang-tidy", self.root)
        self.write("src/good.cpp", "int* f() { return nullptr; }\n")
        self.write("src/bad.cpp", '#include "include/creepcontact/a.hpp"\nint* g() { return nullptr; }\n')
        self.write("include/creepcontact/a.hpp", "inline int* h() { return 0; }\n")
        commands = [{"directory": str(self.root), "file": str(self.root / f"src/{name}.cpp"),
                     "command": f"c++ -std=c++20 -I{self.root} -c {self.root}/src/{name}.cpp"} for name in ("good", "bad")]
        self.write("build/compile_commands.json", json.dumps(commands))
        self.known = sorted(tidy.known_sources(self.root, self.root / "build"))

    def check(self, **bounds):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            return *tidy.check(self.root, self.root / "build", self.known, **bounds), printed.getvalue()

    def test_in_a_header(self):
        bad, late, printed = self.check()
        self.assertEqual((bad, late), (["src/bad.cpp"], []))
        self.assertRegex(printed, r"creepcontact/a\.hpp:1:\d+: error: use nullptr")

    def test_what_is_too_late_is_told(self):
        bad, late, _ = self.check(seconds=1e-9)
        self.assertEqual((bad, late), ([], self.known))


if __name__ == "__main__":
    unittest.main()
