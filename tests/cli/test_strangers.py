"""Directories of results that come from others: nothing in them is executed, and nothing is written through their links."""

import os
import pathlib
import subprocess
import tempfile
import unittest

from study_case import BASE, GEOMETRY, PROGRAM
from waiting import LONGEST

MODULES = ("json", "math", "os", "shutil", "subprocess", "types", "numpy", "vtkmodules", "vtk", "site", "sitecustomize",
           "usercustomize", "encodings", "re", "codecs")


class ResultsOfOthers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.root = pathlib.Path(scratch.name)
        (cls.root / "cube.geo").write_text(GEOMETRY)
        (cls.root / "cube.toml").write_text(BASE + "[output]\nfields = true\n")
        done = cls.call("run", "cube.toml", "--output", "out")
        assert done.returncode == 0, done.stderr

    @classmethod
    def call(cls, *arguments, cwd=None, **environment):
        return subprocess.run([PROGRAM, *map(str, arguments)], cwd=cwd or cls.root, capture_output=True, text=True, timeout=LONGEST,
                              env={**os.environ, "OMP_NUM_THREADS": "1", **environment})


class Isolation(ResultsOfOthers):
    def plant(self, directory):
        """Whatever an interpreter may look for where it is started, in the home directory, or on the paths that are set."""
        told = self.root / "executed"
        for name in MODULES:
            (directory / (name + ".py")).write_text(f"open({str(told / name)!r}, 'w')\n")
        user = directory / ".local/lib/python3.11/site-packages"
        user.mkdir(parents=True, exist_ok=True)
        for name in ("usercustomize.py", "sitecustomize.py"):
            (user / name).write_text(f"open({str(told / 'user_site')!r}, 'w')\n")
        (user / "planted.pth").write_text(f"import os; open({str(told / 'pth')!r}, 'w')\n")
        for name in (".gnuplot", "gnuplotrc", ".gnuplotrc", "gnuplot.ini"):
            (directory / name).write_text(f"set print '{told / 'gnuplot'}'\nprint 1\n")
        for name in ("gnuplot", "python3", "python", "Xvfb", "env", "sh"):
            (directory / name).write_text(f"#!/bin/sh\ntouch {told}/program_{name}\n")
            (directory / name).chmod(0o755)
        return told

    def test_nothing_planted_is_executed(self):
        out = self.root / "out"
        told = self.plant(out)
        told.mkdir()
        settings = {"HOME": str(out), "PYTHONPATH": str(out), "PYTHONSTARTUP": str(out / "json.py"), "PYTHONHOME": "",
                    "GNUPLOT_LIB": str(out), "PATH": f".:{os.environ['PATH']}:"}
        for command, cwd in (("plot", out), ("picture", out), ("picture", self.root), ("report", out)):
            done = self.call(command, out, cwd=cwd, **settings)
            self.assertEqual(list(told.iterdir()), [], f"{command} in {cwd}: {done.stderr}")
        self.assertTrue((out / "report.html").stat().st_size > 1000)


class Links(ResultsOfOthers):
    def setUp(self):
        self.victims = self.root / "victims"
        self.victims.mkdir(exist_ok=True)
        self.victim = self.victims / "file"
        self.victim.write_text("precious\n")

    def intact(self, what):
        self.assertEqual(self.victim.read_text(), "precious\n", what)
        self.assertEqual([path.name for path in self.victims.iterdir()], ["file"], what)

    def link_everything(self, directory):
        """Puts links at the names of all files and of what they are made of."""
        for path in [path for path in directory.rglob("*") if path.is_file() and not path.is_symlink()]:
            for name in (path, path.with_name(path.name + ".part")):
                name.unlink(missing_ok=True)
                name.symlink_to(self.victim)

    def test_nothing_is_written_through_links_at_files(self):
        for command in (("run", "cube.toml", "--output", "linked"), ("plot", "linked"), ("report", "linked"), ("picture", "linked"),
                        ("check", "cube.toml")):
            self.call(*command)
        out = self.root / "linked"
        self.link_everything(out)
        done = self.call("run", "cube.toml", "--output", "linked")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.intact("run")
        for path in out.rglob("*"):
            if "plots" not in path.parts and path.suffix != ".html" and not path.name.endswith(".part"):
                self.assertFalse(path.is_symlink(), path)
        for command in ("plot", "report", "picture"):
            self.call(command, "linked")
            self.intact(command)

    def test_nor_of_a_resumed_run(self):
        for name in ("history.csv", "checkpoint.h5", "steps.csv", "summary.json", "fields.pvd"):
            config = BASE + "[output]\nfields = true\ncheckpoint_seconds = 0\n"
            (self.root / "cube.toml").write_text(config)
            self.call("run", "cube.toml", "--output", "resumed")
            path = self.root / "resumed" / name
            if not path.exists():
                continue
            part = path.with_name(name + ".part")
            part.symlink_to(self.victim)
            self.call("run", "cube.toml", "--output", "resumed", "--resume", "--set", "time.end=0.5")
            self.intact(name)
            part.unlink(missing_ok=True)
            path.unlink(missing_ok=True)
            path.symlink_to(self.victim)
            self.call("run", "cube.toml", "--output", "resumed", "--resume", "--set", "time.end=0.6")
            self.intact(name)
            path.unlink(missing_ok=True)

    def test_directories_that_are_links_are_refused(self):
        for name, command in (("fields", ("run", "cube.toml", "--output", "inner")), ("plots", ("plot", "inner")),
                              ("plots", ("picture", "inner"))):
            out = self.root / "inner"
            self.call("run", "cube.toml", "--output", "inner")
            for path in sorted((out / name).rglob("*")) if (out / name).exists() else []:
                path.unlink()
            if (out / name).exists():
                (out / name).rmdir()
            (out / name).symlink_to(self.victims)
            done = self.call(*command)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("symbolic link", done.stderr)
            self.intact(name)
            (out / name).unlink()

    def test_runs_of_a_study_that_are_links_are_refused(self):
        (self.root / "study.toml").write_text('base = "cube.toml"\n[[runs]]\nset = { time.end = 0.2, time.output = [0.2] }\n')
        self.call("study", "study.toml", "--output", "studied")
        runs = self.root / "studied" / "runs"
        self.assertTrue(runs.is_dir())
        runs.rename(self.root / "elsewhere")
        runs.symlink_to(self.victims)
        self.assertIn("symbolic link", self.call("study", "study.toml", "--output", "studied").stderr)
        self.intact("runs")
        runs.unlink()
        runs.mkdir()
        for run in (self.root / "elsewhere").iterdir():
            (runs / run.name).symlink_to(self.victims)
        self.assertIn("symbolic link", self.call("study", "study.toml", "--output", "studied").stderr)
        self.intact("run")

    def test_other_commands_write_through_no_link(self):
        (self.root / "data.csv").write_text("stress,rate\n" + "".join(f"{s},{1e-12 * s**4}\n" for s in (50, 60, 70, 80)))
        for name in ("fitted.toml.part", "r.html.part", "new/pipe.toml.part"):
            (self.root / name).parent.mkdir(exist_ok=True)
            (self.root / name).symlink_to(self.victim)
        for command in (("fit", "data.csv", "--law", "norton", "--output", "fitted.toml"), ("report", "out", "--output", "r.html"),
                        ("new", "new", "--template", "pipe")):
            self.assertEqual(self.call(*command).returncode, 0, command)
            self.intact(command)


class SizeOfFiles(ResultsOfOthers):
    def limited(self, blocks, *arguments):
        return subprocess.run(["bash", "-c", f'ulimit -f {blocks}; exec "$@"', "bash", PROGRAM, *arguments], cwd=self.root,
                              capture_output=True, text=True, timeout=LONGEST, env={**os.environ, "OMP_NUM_THREADS": "1"})

    def test_a_limit_is_told_like_a_full_disk(self):
        for blocks in (0, 1, 2, 4, 8):
            done = self.limited(blocks, "run", "cube.toml", "--output", f"limited_{blocks}")
            self.assertIn(done.returncode, (0, 4), f"{blocks}: {done.returncode} {done.stderr}")
            if done.returncode == 4:
                self.assertRegex(done.stderr, "error: .*limited_.*File too large .*ulimit -f")
                for line in done.stderr.splitlines():
                    self.assertRegex(line, r"^(error|warning|\[|  )|info", f"not in words of the program: {line}")
            self.assertEqual(list((self.root / f"limited_{blocks}").rglob("*.part")), [])
        self.assertEqual(self.limited(0, "run", "cube.toml", "--output", "none").returncode, 4)

    def test_what_a_limit_has_left_hinders_nothing(self):
        self.limited(1, "run", "cube.toml", "--output", "again")
        for name in ("history.csv", "summary.json", "model.json", "checkpoint.h5"):
            (self.root / "again" / (name + ".part")).write_text("left")
        self.assertEqual(self.call("run", "cube.toml", "--output", "again").returncode, 0)


if __name__ == "__main__":
    unittest.main()
