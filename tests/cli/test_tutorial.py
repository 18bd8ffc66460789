"""The tutorials done word by word: their files are written, their commands run, and they print what is quoted."""

import os
import pathlib
import re
import struct
import subprocess
import tempfile
import unittest

from waiting import LONGEST

PROGRAM = pathlib.Path(os.environ["CREEPCONTACT_PROGRAM"])
DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"
BLOCK = re.compile(r"^```(\w+)(?: (\S+))?\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NUMBER = re.compile(r"(?<![\w.])([-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?)(?![\w.]*\w)")
MACHINE = re.compile(r"\d+(?:\.\d+)? (?=s\b|MB\b)")  # seconds and memory
# They differ a little with the compiler.
COUNTERS = ("done: ", "  cvode_", "  log_adams: ", "  steps ", "  elastic solves ", "  contact ", "  accuracy ")


def blocks(text):
    """(language, file name or "", content) of every block with a language, in the order of the text."""
    return [match.groups(default="") for match in BLOCK.finditer(text)]


def files(text):
    """Blocks with a file's name, those of one name put together with an empty line between."""
    parts = {}
    for _, name, content in blocks(text):
        if name:
            parts.setdefault(name, []).append(content)
    return {name: "\n".join(pieces) for name, pieces in parts.items()}


def commands(content):
    """[command, quoted lines] of a console block."""
    result = []
    for line in content.splitlines():
        if line.startswith("$ "):
            result.append((line[2:], []))
        else:
            result[-1][1].append(line)
    return result


def last_digit(number):
    """What one unit of the last quoted digit is worth."""
    mantissa, _, exponent = number.lower().partition("e")
    return 10.0**(int(exponent or 0) - len(mantissa.partition(".")[2]))


def same_number(quoted, printed, is_counter):
    difference = abs(float(quoted) - float(printed))
    if is_counter:
        return difference <= max(1, 0.1 * abs(float(quoted)))
    is_integer = re.fullmatch(r"[-+]?\d+", quoted)
    return difference == 0 if is_integer else difference < 1.01 * last_digit(quoted)


def same_line(quoted, printed):
    if quoted.startswith("  time ") and printed.startswith("  time "):
        return True
    quoted_parts, printed_parts = (NUMBER.split(" ".join(MACHINE.sub("# ", line).split())) for line in (quoted, printed))
    return (quoted_parts[::2] == printed_parts[::2] and
            all(same_number(q, p, quoted.startswith(COUNTERS)) for q, p in zip(quoted_parts[1::2], printed_parts[1::2])))


def first_difference(quoted, printed):
    """The first quoted line that was not printed, or None. A line of three dots stands for any lines."""
    position, skipping = 0, False
    for line in quoted:
        if line == "...":
            skipping = True
            continue
        while skipping and position < len(printed) and not same_line(line, printed[position]):
            position += 1
        if position == len(printed) or not same_line(line, printed[position]):
            return line
        position, skipping = position + 1, False
    return None if skipping or position == len(printed) else f"nothing beyond line {position}"


class Tutorial(unittest.TestCase):
    page, directory_name, pictures, commands = "tutorial", "press_fit", 1, 10
    copied = False  # the page says to copy the directory, and quotes parts of its files

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.directory = pathlib.Path(scratch.name)
        self.text = (DOCS / f"{self.page}.md").read_text(encoding="utf-8")
        directory = DOCS / self.page
        self.there = {path.name: path.read_text(encoding="utf-8") for path in (directory.iterdir() if directory.exists() else ())}

    def run_command(self, command):
        environment = {**os.environ, "OMP_NUM_THREADS": "1", "PATH": f"{self.directory / 'bin'}:{os.environ['PATH']}"}
        return subprocess.run(["bash", "-c", command], cwd=self.directory / self.directory_name, env=environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=LONGEST)

    def test_commands_print_what_is_quoted(self):
        for name in ("bin", self.directory_name):
            (self.directory / name).mkdir()
        (self.directory / "bin" / "creepcontact").symlink_to(PROGRAM)
        for name, content in (self.there if self.copied else files(self.text)).items():
            (self.directory / self.directory_name / name).write_text(content)
        number = 0
        for language, _, content in blocks(self.text):
            for command, quoted in commands(content) if language == "console" else []:
                number += 1
                with self.subTest(command):
                    done = self.run_command(command)
                    fails = any(line.startswith("error: ") for line in quoted)
                    self.assertEqual(done.returncode != 0, fails, done.stdout)
                    missing = first_difference(quoted, done.stdout.splitlines())
                    self.assertIsNone(missing, f"quoted, but printed was:\n{done.stdout}")
        self.assertGreaterEqual(number, self.commands)

    def test_files_are_those_of_the_directory(self):
        if self.copied:
            quotations = [(name, content) for _, name, content in blocks(self.text) if name]
            self.assertTrue(quotations)
            for name, content in quotations:
                self.assertIn(f"\n{content}", f"\n{self.there[name]}")
        else:
            self.assertEqual(files(self.text), self.there)

    def test_pictures_and_pages_exist(self):
        pictures = re.findall(r"!\[[^\]]+\]\(([^)]+)\)", self.text)
        self.assertEqual(len(pictures), self.pictures)
        for name in pictures:
            content = (DOCS / name).read_bytes()
            self.assertEqual(content[:8], b"\x89PNG\r\n\x1a\n")
            width, height = struct.unpack(">II", content[16:24])
            self.assertTrue(600 < width < 1600 and 300 < height < 1600, (width, height))
        for name in re.findall(r"\]\(([^):#]+)(?:#[^)]*)?\)", self.text):
            self.assertTrue((DOCS / name).exists(), name)


class BoltedJointTutorial(Tutorial):
    page, directory_name, pictures, copied = "tutorial_bolted_joint", "bolted_joint", 1, True


class DeckTutorial(Tutorial):
    page, directory_name, pictures, commands, copied = "tutorial_deck", "fit", 0, 9, True


class HeatTutorial(Tutorial):
    page, directory_name, pictures, commands, copied = "tutorial_heat", "hot_fit", 1, 18, True


class CadTutorial(Tutorial):
    page, directory_name, pictures, commands, copied = "tutorial_cad", "valve", 1, 9, True
    sources = DOCS.parent / "configs"

    def setUp(self):
        super().setUp()
        self.there = {path.name: path.read_text(encoding="utf-8") for path in self.sources.glob("valve_from_step.*")}


class Comparison(unittest.TestCase):
    """What the comparison lets pass, and what it does not."""

    def test_numbers_count_to_the_quoted_digits(self):
        self.assertTrue(same_line("p 68.6 MPa", "p  68.7 MPa"))
        self.assertFalse(same_line("p 68.6 MPa", "p 68.8 MPa"))
        self.assertFalse(same_line("p 68.6 MPa", "p 68.6 Pa"))
        self.assertTrue(same_line("6e-04", "7e-04"))
        self.assertFalse(same_line("6e-04", "6e-03"))
        self.assertFalse(same_line("15 multipliers", "16 multipliers"))
        self.assertFalse(same_line("a.toml:12:3: hex20", "a.toml:13:3: hex20"))

    def test_machine_and_counters(self):
        self.assertTrue(same_line("done: 62 steps, 1.46 s", "done: 63 steps, 99 s"))
        self.assertFalse(same_line("done: 62 steps, 1.46 s", "done: 80 steps, 1.46 s"))
        self.assertTrue(same_line("estimated memory: 68 MB", "estimated memory: 70 MB"))

    def test_lines(self):
        self.assertIsNone(first_difference(["a", "...", "c"], ["a", "b", "b", "c"]))
        self.assertIsNone(first_difference(["a", "..."], ["a"]))
        self.assertEqual(first_difference(["a", "...", "c"], ["a", "b"]), "c")
        self.assertIsNotNone(first_difference(["a"], ["a", "b"]))
        self.assertIsNotNone(first_difference([], ["a"]))


if __name__ == "__main__":
    unittest.main()
