"""Completion of arguments in bash: the function on given lines, and once in a shell at a terminal."""

import os
import pathlib
import pty
import re
import select
import subprocess
import tempfile
import unittest

from waiting import LONGEST

PROGRAM = os.environ["CREEPCONTACT_PROGRAM"]
SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "completions/creepcontact"

CONFIG = """[bodies.shaft]
[bodies.ring]
[materials.steel]
[[materials.steel.creep]]
[[materials.steel.creep]]
[[contacts]]
  [[probes]]
[materials."$(touch trap)"]
"""


class CompletionTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = pathlib.Path(temporary.name)
        (self.directory / "case.toml").write_text(CONFIG, encoding="utf-8")
        (self.directory / "two words.toml").write_text("", encoding="utf-8")
        (self.directory / "case.geo").write_text("", encoding="utf-8")
        (self.directory / "deck.inp").write_text("", encoding="utf-8")
        (self.directory / "results").mkdir()


class Completion(CompletionTest):
    def complete(self, arguments):
        """What bash would put in place of the last part of the line, cut at blanks and '=' as bash cuts it."""
        line = f"{PROGRAM} {arguments}"
        words = re.findall(r"=|[^\s=]+", line)
        if line.endswith(" "):
            words.append("")
        shell = f'source {SCRIPT}; _creepcontact; for reply in "${{COMPREPLY[@]}}"; do echo "$reply"; done'
        array = " ".join(f"'{word}'" for word in words)
        setting = f"COMP_LINE='{line}' COMP_POINT={len(line)} COMP_WORDS=({array}) COMP_CWORD={len(words) - 1}\n"
        done = subprocess.run(["bash", "--norc", "-c", setting + shell], cwd=self.directory, capture_output=True,
                              text=True, timeout=LONGEST)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return sorted(done.stdout.splitlines())

    def test_commands(self):
        self.assertEqual(self.complete(""), ["--help", "--version", "check", "faces", "fit", "heat", "import", "list", "material", "new", "picture", "plot", "report", "run", "study"])
        self.assertEqual(self.complete("pl"), ["plot"])

    def test_every_command_of_the_program(self):
        text = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True).stdout
        commands = re.findall(r"(?m)^  ([a-z]+) ", text.split("Options")[0])
        self.assertEqual(self.complete(""), sorted(["--help", "--version", *commands]))

    def test_options_are_those_of_the_command(self):
        self.assertEqual(self.complete("run case.toml --l"), ["--log-contact"])
        self.assertEqual(self.complete("study --"), ["--gather", "--help", "--jobs", "--list", "--output", "--run", "--shard",
                                                     "--shards", "--slurm", "--together", "--trust-geometry"])

    def test_files(self):
        self.assertEqual(self.complete("run "), ["case.toml", "results", "two words.toml"])
        self.assertEqual(self.complete("check --set time.end=1 c"), ["case.toml"])
        self.assertEqual(self.complete("plot "), ["results"])
        self.assertEqual(self.complete("import "), ["deck.inp", "results"])
        self.assertEqual(self.complete("report r"), ["results"])
        self.assertEqual(self.complete("picture r"), ["results"])
        self.assertEqual(self.complete("picture results --view -"), ["-x", "-y", "-z"])
        self.assertEqual(self.complete("new x --template b"), ["ball_on_block", "blade_root", "bolted_joint"])
        self.assertEqual(self.complete("run --output "), ["results"])
        self.assertEqual(self.complete("run --output=res"), ["results"])
        self.assertEqual(self.complete("run --log-contact case."), ["case.geo", "case.toml"])

    def test_lists(self):
        self.assertEqual(self.complete("list "),
                         ["elements", "integrators", "keys", "laws", "materials", "quantities", "study-keys", "templates"])
        self.assertEqual(self.complete("list keys con"), ["contact_solver", "contacts"])
        self.assertEqual(self.complete("list study-keys ax"), ["axes"])
        self.assertEqual(self.complete("plot results --log-time "), ["auto", "no", "yes"])

    def test_keys(self):
        self.assertEqual(self.complete("run --set time.in"), ["time.inner=", "time.inner_anderson=",
                                                              "time.inner_tolerance=", "time.integrator="])
        self.assertEqual(self.complete("run --set=time.be"), ["time.beta="])

    def test_keys_know_the_names_in_the_configuration(self):
        self.assertEqual(self.complete("run case.toml --set bodies."),
                         [f"bodies.{body}.{key}=" for body in ("ring", "shaft")
                          for key in ("axial_force", "material", "material_axes.cylindrical.axis", "material_axes.cylindrical.origin", "material_axes.cylindrical", "material_axes.first", "material_axes.second", "region", "thickness")])
        self.assertEqual(self.complete("run case.toml --set materials.steel.creep.1.flu"),
                         ["materials.steel.creep.1.fluidity="])
        self.assertEqual(self.complete("run case.toml --set contacts.0.ga"), ["contacts.0.gap=", "contacts.0.gasket="])
        self.assertEqual(self.complete("run case.toml --set materials.steel.yo"), ["materials.steel.young_modulus="])
        self.assertEqual(self.complete("run --set bodies."), [])
        self.assertFalse((self.directory / "trap").exists())

    def test_values(self):
        self.assertEqual(self.complete("run --set time.integrator=cvode"), ["cvode_adams", "cvode_bdf"])
        self.assertEqual(self.complete("run --set output.fields="), ["false", "true"])
        self.assertEqual(self.complete("run case.toml --set contacts.0.type=t"), ["tied"])
        self.assertEqual(self.complete("run --set time.end="), [])

    def test_nothing_where_the_program_is_missing(self):
        line = "COMP_LINE='/nowhere/creepcontact run --set t' COMP_POINT=34 COMP_WORDS=(/nowhere/creepcontact run --set t)"
        done = subprocess.run(["bash", "--norc", "-c", f"{line} COMP_CWORD=3; source {SCRIPT}; _creepcontact"],
                              capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual((done.returncode, done.stderr), (0, ""))


class CompletionAtTerminal(CompletionTest):
    def type(self, text):
        """The line as it stands in the shell after these keys, which end with tabulators."""
        pid, terminal = pty.fork()
        if pid == 0:
            os.chdir(self.directory)
            os.execvpe("bash", ["bash", "--norc", "--noprofile", "-i"],
                       {"PATH": f"{pathlib.Path(PROGRAM).parent}:{os.environ['PATH']}", "PS1": "$ ", "TERM": "dumb"})
        self.addCleanup(os.waitpid, pid, 0)
        self.addCleanup(os.close, terminal)

        def read_until(mark):
            heard = b""
            while mark not in heard:
                self.assertTrue(select.select([terminal], [], [], LONGEST)[0], heard)
                heard += os.read(terminal, 4096)
            return heard.decode()

        os.write(terminal, f"stty -echo; source {SCRIPT}; echo rea''dy\n".encode())
        read_until(b"ready")
        # what was completed becomes the arguments of printf, whose output ends with a mark
        os.write(terminal, text.encode() + b"\x01printf '<%s>' \x05 en''d\n")
        heard = read_until(b"<end>")
        os.write(terminal, b"exit\n")
        return re.findall(r"<([^>\n]*)>", heard.replace("<%s>", ""))

    def test_key_and_value_after_set(self):
        self.assertEqual(self.type("creepcontact run ca\t--set time.integ\tcvode_b\t"),
                         ["creepcontact", "run", "case.toml", "--set", "time.integrator=cvode_bdf", "end"])


if __name__ == "__main__":
    unittest.main()
