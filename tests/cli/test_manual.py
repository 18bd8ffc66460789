"""The manual page has the commands and options that the program has, and no others."""

import os
import pathlib
import re
import shutil
import subprocess
import unittest

from waiting import LONGEST

PROGRAM = os.environ["CREEPCONTACT_PROGRAM"]
PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/creepcontact.1"


def help_of(*arguments):
    return subprocess.run([PROGRAM, *arguments, "--help"], capture_output=True, text=True, timeout=LONGEST).stdout


def plain(roff):
    r"""Without fonts and the quotation marks around pieces of a line: '.BR \-o ", " \-\-output' is '-o, --output'."""
    text = re.sub(r"\\f.|^\.(TP|B|I|BR|IR|RB|RI)\b *", "", roff).replace("\\-", "-")
    return re.sub(r'"([^"]*)"|(\S+) ?', lambda match: match[1] if match[1] is not None else match[2] + " ", text).strip()


def option(words):
    """Long name, short name or nothing, and what its value is called, of '-o [ --output ] DIR' or '-o , --output DIR'."""
    match = re.fullmatch(r"(?:(-\w)\b[\s,\[]*)?(--[\w-]+)[\s\]]*(\S.*)?", words.strip())
    return match and (match[2], match[1], match[3])


def options_of_help(text):
    column = re.search(r"(?m)^.*(?=show this help)", text)[0]
    found = {option(line[:len(column)]) for line in text.splitlines() if line.startswith("  -")}
    assert found and None not in found, text
    return found


class Manual(unittest.TestCase):
    def setUp(self):
        self.roff = PAGE.read_text(encoding="utf-8")
        self.sections = dict(re.findall(r"(?ms)^\.SH (.*?)\n(.*?)(?=^\.SH |\Z)", self.roff))
        self.commands = dict(re.findall(r"(?ms)^\.SS (\S+).*?\n(.*?)(?=^\.SS |\Z)", self.sections["COMMANDS"]))

    def options_of_page(self, text):
        tags = re.findall(r"(?m)^\.TP\n(.*)", text)
        return {found for tag in tags if (found := option(plain(tag)))}

    def test_commands(self):
        commands = re.findall(r"(?m)^  ([a-z]+) ", help_of().split("Options")[0])
        self.assertEqual(list(self.commands), commands)
        for command in commands:
            self.assertIn(f".B creepcontact {command}\n", self.sections["SYNOPSIS"])

    def test_options_of_every_command(self):
        common = ("--help", "-h", None)
        for command, text in self.commands.items():
            self.assertEqual(self.options_of_page(text) | {common}, options_of_help(help_of(command)), command)

    def test_options_of_the_program(self):
        names = {name for name, _, _ in self.options_of_page(self.sections["OPTIONS"])}
        self.assertEqual(names, set(re.findall(r"(?m)^  (--\w+)", help_of())))

    def test_lists(self):
        lists = re.search(r"\((.*?)\)", help_of("list"))[1].split("|")
        for name in lists:
            self.assertIn(name, self.commands["list"].replace("\\-", "-"))

    def test_exit_statuses_are_those_of_the_interface(self):
        self.assertEqual(re.findall(r"(?m)^\.TP\n\.B (\d+)$", self.sections["EXIT STATUS"]), ["0", "2", "3", "4", "5", "130"])

    def test_version(self):
        version = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, timeout=LONGEST).stdout.strip()
        self.assertTrue(self.roff.startswith(f'.TH CREEPCONTACT 1 "" "{version}" '), version)

    def test_formats_without_complaint(self):
        if shutil.which("groff") is None:
            self.skipTest("groff is not installed (Debian package groff-base)")
        done = subprocess.run(["groff", "-ww", "-man", "-Tutf8", str(PAGE)], capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("CREEPCONTACT(1)", done.stdout)


if __name__ == "__main__":
    unittest.main()
