"""What the program writes in the documentation is what it says today, and the documentation has all of it."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from waiting import LONGEST

PROGRAM = os.environ["CREEPCONTACT_PROGRAM"]
ROOT = pathlib.Path(__file__).resolve().parents[2]


def call(*arguments):
    done = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=LONGEST)
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return done.stdout


def renew(root, *options):
    return subprocess.run([sys.executable, str(root / "scripts/renew_docs"), *options, PROGRAM], capture_output=True,
                          text=True, timeout=LONGEST)


def document(name):
    return (ROOT / "docs" / name).read_text(encoding="utf-8")


class Renewal(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.root = pathlib.Path(temporary.name)
        (self.root / "scripts").mkdir()
        (self.root / "docs").mkdir()
        shutil.copy(ROOT / "scripts/renew_docs", self.root / "scripts")
        self.page = self.root / "docs/page.md"

    def test_documentation_is_up_to_date(self):
        done = renew(ROOT, "--check")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_stale_lines_are_named_and_renewed(self):
        right = document("configuration.md").split("## `[contact_solver]`\n")[1].split("\n## ")[0]
        wrong = right.replace("| `\"cg\"` |", "| `\"none\"` |")
        self.assertNotEqual(wrong, right)
        self.page.write_text(wrong, encoding="utf-8")
        line = 1 + next(n for n, (a, b) in enumerate(zip(right.splitlines(), wrong.splitlines())) if a != b)
        done = renew(self.root, "--check")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, rf"docs/page\.md:{line}: .*scripts/renew_docs ")
        self.assertEqual(self.page.read_text(encoding="utf-8"), wrong)
        self.assertEqual(renew(self.root).returncode, 0)
        self.assertEqual(self.page.read_text(encoding="utf-8"), right)

    def test_marks_without_a_partner(self):
        self.page.write_text("<!-- begin: creepcontact list elements --markdown -->\ntext\n", encoding="utf-8")
        done = renew(self.root)
        self.assertEqual(done.returncode, 1)
        self.assertIn("'<!-- end -->'", done.stderr)

    def test_command_that_the_program_does_not_know(self):
        self.page.write_text("<!-- begin: creepcontact list planets -->\n<!-- end -->\n", encoding="utf-8")
        done = renew(self.root)
        self.assertEqual(done.returncode, 1)
        self.assertIn("'planets'", done.stderr)


class Completeness(unittest.TestCase):
    def test_every_list(self):
        for name, *lists in (("configuration.md", "elements", "integrators", "quantities"), ("materials.md", "laws"),
                             ("studies.md", "study-keys")):
            for what in lists:
                self.assertIn(call("list", what, "--markdown"), document(name), f"docs/{name} lacks list {what}")

    def test_every_table_of_keys_under_its_heading(self):
        page = document("configuration.md")
        parts = re.split(r"(?m)^### `(.*)`\n", call("list", "keys", "--markdown"))
        self.assertGreater(len(parts), 20)
        first = {}  # the heading of each table of keys; one that stands there already may be a link to it
        for heading, keys in zip(["Top level", *(f"`{title}`" for title in parts[1::2])], parts[::2]):
            self.assertRegex(page, rf"(?m)^##+ {re.escape(heading)}$")
            section = re.split(rf"(?m)^##+ {re.escape(heading)}$", page)[1].split("\n#")[0]
            wanted = keys.strip() if keys not in first else f"[{first[keys]}](#"
            self.assertIn(wanted, section, f"docs/configuration.md: {heading}")
            first.setdefault(keys, heading)

    def test_keys_in_running_text_exist(self):
        names = call("list", "keys", "--names").split()
        tables = "time|contact_solver|output|mesh|temperature"
        for page in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]:
            text = re.sub(r"(?m)^\| `.*$", "", page.read_text(encoding="utf-8"))  # rows name keys of their table
            for key in re.findall(rf"`((?:{tables})\.[a-z_.]+)(?:`| = )", text):
                if not key.startswith("mesh.parameters."):
                    self.assertIn(key, names, f"{page.name} names a key that does not exist")


EVERY_TABLE = """[mesh]
file = "missing.geo"
[bodies.steel]
region = "all"
material = "steel"
[materials.steel]
young_modulus = 2e5
poisson_ratio = 0.3
[[materials.steel.creep]]
law = "norton"
A = 1e-20
n = 5
[materials.steel.plasticity]
yield_stress = 200
[[materials.steel.plasticity.kinematic]]
C = 1
[bodies.rolled]
region = "rolled"
material = "rolled"
[materials.rolled]
young_modulus = 2e5
poisson_ratio = 0.3
[gaskets.steel]
thickness = 2
loading = { closure = [0, 1], pressure = [0, 100] }
relaxation = { factor = 0.9, pressure = 50, stiffness = 1e6, area = 4762, time = 4 }
[materials.steel.rupture]
stress = [50, 100]
parameter = [2e4, 1e4]
[[supports]]
on = "end"
displacement = { radial = 0 }
[[equations]]
terms = [{ node = 1, x = 1 }]
[[loads]]
body = "steel"
rotation = { angular_velocity = 1, density = 1 }
[temperature]
value = 20
[[contacts]]
between = ["a", "b"]
preload = { force = 1 }
[[springs]]
name = "steel"
at = [[0, 0, 0], [0, 0, 1]]
direction = [0, 0, 1]
stiffness = 1
[[cyclic]]
between = ["low", "high"]
angle = 30
[[rigid]]
on = "end"
[[coupling]]
on = "other_end"
[time]
end = 10
cycle = 5
[[probes]]
name = "q"
quantity = "stress_theta"
body = "steel"
[[events]]
name = "e"
when = "q < 1"
"""


class Defaults(unittest.TestCase):
    """What the reference calls a default may be written."""

    def mistakes(self, settings):
        with tempfile.TemporaryDirectory() as directory:
            config = pathlib.Path(directory) / "case.toml"
            config.write_text(EVERY_TABLE, encoding="utf-8")
            options = [option for setting in settings for option in ("--set", setting)]
            done = subprocess.run([PROGRAM, "check", str(config), *options], capture_output=True, text=True, timeout=LONGEST)
        self.assertIn("missing.geo" if done.returncode != 2 else "error: ", done.stderr)
        return [line for line in done.stderr.splitlines() if done.returncode == 2]

    def defaults(self):
        tables = re.split(r"(?m)^### `\[*(.*?)\]*`\n", call("list", "keys", "--markdown"))
        for table, rows in zip(tables[1::2], tables[2::2]):
            if table in ("generalized_plane_strain", "heat", "surfaces.<name>", "initial_stress.<name>", "criteria"):  # what they need is not there
                continue
            has_axes = table in ("bodies.<name>.material_axes", "materials.<name>.hill")  # not next to plasticity
            place = table.replace("<name>", "rolled" if has_axes else "steel")
            if re.search(rf"(?m)^\[\[{re.escape(place)}\]\]", EVERY_TABLE):
                place += "[0]"
            for key, default in re.findall(r"(?m)^\| `([\w.]+)` \| .*? \| `([^`]*)` \| .* \|$", rows):
                if "<" not in default and key != "output.spacing":  # a word for a place; a table that is not there
                    yield f"{place}.{key}={default}"

    def test_may_be_written(self):
        settings = list(self.defaults())
        self.assertGreater(len(settings), 30)
        self.assertEqual(self.mistakes(settings), [])

    def test_a_wrong_one_would_be_found(self):
        self.assertEqual(len(self.mistakes(["time.beta=3", "contact_solver.method=\"newton\""])), 2)


if __name__ == "__main__":
    unittest.main()
