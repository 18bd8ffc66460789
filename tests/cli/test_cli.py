"""The command line: help, version, lists, exit statuses and the errors of a configuration; nothing is computed."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

from says import Says
from waiting import LONGEST

PROGRAM = os.environ["CREEPCONTACT_PROGRAM"]
COMMANDS = ("run", "check", "study", "plot", "list")

WRONG = """[mesh]
file = "block.msh"
[bodies.block]
region = "all"
material = "stel"
[materials.steel]
young_modulus = -1
poisson_ratio = 0.3
[[materials.steel.creep]]
  law = "norton"
  A = 1e-20
  exponent = 7
[time]
end = 10
output = [1, 20]
"""


def call(*arguments, directory=None):
    return subprocess.run([PROGRAM, *arguments], cwd=directory, capture_output=True, text=True, timeout=LONGEST)


class CliTest(Says, unittest.TestCase):
    def expect_error(self, done, *facts, status=2):
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertEqual(done.stdout, "")
        for line in done.stderr.splitlines():
            self.assertTrue(line.startswith("error: "), line)
        self.assertSays(done.stderr, *facts)


class Help(CliTest):
    def test_program(self):
        done = call("--help")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for command in COMMANDS:
            self.assertRegex(done.stdout, rf"(?m)^  {command} ")

    def test_every_command(self):
        for command in COMMANDS:
            done = call(command, "--help")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertTrue(done.stdout.startswith(f"creepcontact {command} "), done.stdout)

    def test_libraries(self):
        """The fast BLAS is used, although others are installed; where it is not, that is said."""
        done = call("--version", "--verbose")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for library in ("BLAS", "LAPACK"):
            self.assertRegex(done.stdout, rf"(?m)^{library}: .*openblas")
        self.assertNotIn("slow", done.stdout)
        loaded = subprocess.run([PROGRAM, "--version"], env={**os.environ, "LD_TRACE_LOADED_OBJECTS": "1"},
                                capture_output=True, text=True, timeout=LONGEST).stdout
        for name in ("atlas", "f77blas", "ceres"):
            self.assertNotIn(name, loaded)
        atlas = re.search(r"\S*libf77blas\.so\S*", subprocess.run(["ldconfig", "-p"], capture_output=True, text=True).stdout)
        if atlas:
            with_atlas = subprocess.run([PROGRAM, "--version", "--verbose"], env={**os.environ, "LD_PRELOAD": atlas[0]},
                                        capture_output=True, text=True, timeout=LONGEST)
            self.assertIn("is ATLAS", with_atlas.stdout)
        self.expect_error(call("--version", "--quiet"), "allowed: --verbose")

    def test_options_of_run(self):
        text = call("run", "--help").stdout
        for option in ("--set", "--output", "--threads", "--resume", "--quiet"):
            self.assertIn(option, text)


class Version(CliTest):
    def test_version(self):
        done = call("--version")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout, r"^creepcontact \d+\.\d+\.\d+\n$")


class CommandErrors(CliTest):
    def test_no_command(self):
        self.expect_error(call(), "no command", "--help")

    def test_unknown_command(self):
        self.expect_error(call("chekc"), "'chekc'", "'check'")

    def test_unknown_global_option(self):
        self.expect_error(call("--versoin"), "'--versoin'", "'--version'")

    def test_unknown_option_of_a_command(self):
        self.expect_error(call("run", "a.toml", "--quite"), "'--quite'", "'--quiet'")

    def test_abbreviated_option(self):
        self.expect_error(call("run", "a.toml", "--out", "x"), "'--out'", "'--output'")

    def test_option_of_another_name(self):
        self.expect_error(call("run", "a.toml", "--restart"), "'--restart'", "'--resume'")
        self.expect_error(call("list", "keys", "--colour"), "'--colour'", "creepcontact list --help")

    def test_nothing_near(self):
        self.expect_error(call("compute"), "'compute'", "creepcontact --help")

    def test_missing_argument(self):
        self.expect_error(call("run"), "run", "CONFIG.toml")
        self.expect_error(call("run", "a.toml", "--output"), "--output")

    def test_too_many_arguments(self):
        self.expect_error(call("check", "a.toml", "b.toml"), "check", "one")

    def test_wrong_number_of_threads(self):
        self.expect_error(call("run", "a.toml", "--threads", "0"), "--threads")
        self.expect_error(call("run", "a.toml", "--threads", "many"), "'many'", "'--threads'")


class List(CliTest):
    def test_lists(self):
        for what, name in (("integrators", "cvode_bdf"), ("laws", "norton"), ("elements", "hex20"),
                           ("quantities", "von_mises")):
            done = call("list", what)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn(name, done.stdout)

    def test_laws_for_the_documentation(self):
        done = call("list", "laws", "--markdown")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("### `norton`", done.stdout)
        for what in ("elements", "integrators", "quantities"):
            self.assertRegex(call("list", what, "--markdown").stdout, r"^\| \w+ \| (where \| dimension \| )?what \|\n\|---\|")

    def test_keys(self):
        done = call("list", "keys")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"(?m)^\[time\]  time integration; required\n  end  +number >= 0 \[time\]; required$")
        self.assertRegex(call("list", "keys", "bodies.shaft.region").stdout, r"^\[bodies\.<name>\].*\n  region  ")
        self.assertEqual(call("list", "keys", "contacts[0].type", "--values").stdout, "unilateral\ntied\n")
        self.assertIn("axes[].values\n", call("list", "study-keys", "--names").stdout)

    def test_materials(self):
        done = call("list", "materials", "1.4903")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"^grade_91  Grade 91 \(9Cr.*P91")
        self.assertRegex(done.stdout, r"\n  /en_10216_2 .*rupture.*500 to 670 °C.*fitted here")
        self.assertNotIn("grade_92", done.stdout)
        names = call("list", "materials", "--names").stdout.split()
        self.assertIn("grade_91/swindeman_1999", names)
        self.assertEqual(len([name for name in names if "/" not in name]), 28)
        self.assertIn("### Grade 91\n", call("list", "materials", "--markdown").stdout)
        self.assertIn("grade_91/omega\n", call("list", "keys", "materials.x.use", "--values").stdout)
        self.expect_error(call("list", "materials", "grade_19"), "'grade_19'", "'grade_91'")
        self.expect_error(call("list", "materials", "--values"), "list materials: --values")

    def test_material_command(self):
        done = call("material", "P91", "--temperature", "600")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"Grade 91 .*at 600 °C\nvariant .*\nswindeman_1999 .*one copy\n")
        self.expect_error(call("material", "grade_19"), "'grade_19'", "'grade_91'")

    def test_mistakes_with_keys(self):
        self.expect_error(call("list", "keys", "tolerence"), "'tolerence'", "'tolerance'")
        self.expect_error(call("list", "laws", "norton"), "--json-schema", "study-keys")
        self.expect_error(call("list", "keys", "--names", "--markdown"), "--names", "--json-schema")
        self.expect_error(call("list", "keys", "time", "mesh"), "list", "one or two")

    def test_unknown_list(self):
        self.expect_error(call("list", "law"), "'law'", "'laws'")

    def test_nothing_to_list(self):
        self.expect_error(call("list"), "integrators, laws, elements, quantities")


class ConfigErrors(CliTest):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.directory = pathlib.Path(scratch.name)
        (self.directory / "wrong.toml").write_text(WRONG)

    def expect_config_error(self, *arguments, facts):
        for command in ("run", "check"):
            self.expect_error(call(command, *arguments, directory=self.directory), *facts)

    def test_no_file(self):
        self.expect_config_error("none.toml", facts=["none.toml: ", "No such file or directory"])

    def test_directory(self):
        self.expect_config_error(".", facts=["directory"])

    def test_syntax(self):
        (self.directory / "broken.toml").write_text('title = "a"\nend = = 3\n')
        self.expect_config_error("broken.toml", facts=["error: broken.toml:2:7: "])

    def test_every_mistake_in_one_go(self):
        self.expect_config_error("wrong.toml", facts=[
            "wrong.toml:5:12: bodies.block.material: ", "'stel'", "'steel'",
            "wrong.toml:7:17: materials.steel.young_modulus: ", "-1", "> 0",
            "wrong.toml:9:1: materials.steel.creep[0].n: ", "missing",
            "wrong.toml:12:3: materials.steel.creep[0].exponent: ", "'n'",
            "wrong.toml:15:14: time.output[1]: ", "20", "time.end",
        ])

    def test_override(self):
        self.expect_config_error("wrong.toml", "--set", "time.ende=3", "--set=time.beta=0.1", facts=[
            "wrong.toml:15:14: ",
            "--set time.ende=3: time.ende: ", "'end'",
            "--set time.beta=0.1: time.beta: ", "0.1", "[0.5, 1]",
        ])

    def test_unknown_law_and_integrator(self):
        self.expect_config_error("wrong.toml", "--set", "time.integrator=cvode_bfd", "--set",
                                 "materials.steel.creep.0.law=nortan", facts=[
            "materials.steel.creep[0].law: ", "'nortan'", "'norton'",
            "time.integrator: ", "'cvode_bfd'", "'cvode_bdf'",
        ])


if __name__ == "__main__":
    unittest.main()
