#!/usr/bin/env python3
"""scripts/check_prose finds what readers stumble over, where it is, and nothing in good pages."""

import contextlib
import importlib.util
import io
import shutil
import sys
import tempfile
import unittest
from importlib.machinery import SourceFileLoader
from pathlib import Path

sys.dont_write_bytecode = True
SCRIPT = Path(__file__).resolve().parents[2] / "scripts/check_prose"
LOADER = SourceFileLoader("check_prose", str(SCRIPT))
prose = importlib.util.module_from_spec(importlib.util.spec_from_loader("check_prose", LOADER))
LOADER.exec_module(prose)

# One sample per rule, in the order of the rules: what must be found, and how to say it.
SAMPLES = (
    ("The file has a row a run.", "The file has one row per run."),
    ("That comes of friction.", "That follows from friction."),
    ("The key stands in the table.", "The key is in the table. The stand-in follows the standard."),
    ("Mend the first error.", "Amend the text; fix the first error."),
    ("Steps get dearer.", "Steps get more expensive, dearly paid."),
    ("The table is beside it.", "The table is next to it."),
    ("A motion is no error.", "There is no error, and the run is no longer slow."),
    ("It shows what heating leaves of the interference.", "It shows the interference that remains. What is left of x is negative."),
    ("It stops all the same.", "It still stops. All the samples are equal."),
    ("Use cg in place of sweeps.", "Use cg instead of sweeps, in the place where it matters."),
    ("Short zones are warned of.", "Short zones cause a warning."),
    ("It starts anew.", "It starts again."),
    ("A load comes upon it.", "A load acts on it."),
    ("The stress of the moment counts.", "The current stress counts."),
    ("It does without friction.", "It does so without friction."),
    ("Further columns are passed over.", "It passed overnight; columns are ignored."),
    ("It goes over to BDF.", "It switches to BDF; the bolt goes over the gap."),
    ("The joint gapes.", "The joint opens; it has gaps."),
    ("The steps cease to grow.", "The steps no longer grow, without ceasefire."),
    ("A wall, and the bore thereof.", "A wall, and its bore."),
    ("The imbalance falls.", "The residual falls."),
    ("It has turning points.", "It has maxima and minima."),
    ("Its rigid motions are free.", "Its rigid-body modes are free."),
)
COUNTED = ("2 solves a step", "one a line", "One table a body", "6 iterations a set", "3000 revolutions a minute", "four a decade",
           "an eigenvalue problem a point", "one forward and one backward pass a body", "0.5 steps a second", "once a table")
NOT_COUNTED = ("such a run takes a second", "a load lifts a body", "one of the tables in a file", "two at a time",
               "each node may carry a point", "how many solves a step costs", "an error for a run", "the first 2 of a set")


class Text(unittest.TestCase):
    def found(self, text):
        return [what for _, what, _ in prose.findings(prose.markdown_prose(text))]

    def test_each_rule_fails_on_a_sample_and_passes_on_a_good_one(self):
        self.assertEqual(len(SAMPLES), len(prose.RULES))
        for (pattern, instead), (bad, good) in zip(prose.RULES, SAMPLES):
            with self.subTest(pattern.pattern):
                self.assertEqual([said for _, _, said in prose.findings(bad)], [instead])
                self.assertEqual(self.found(good), [])

    def test_distributive_a(self):
        for text in COUNTED:
            self.assertEqual(len(self.found(f"It has {text}.")), 1, text)
        for text in NOT_COUNTED:
            self.assertEqual(self.found(f"It says {text}."), [], text)

    def test_lines_and_breaks(self):
        text = "# Title\n\nIt has one\nrow a\nrun, and it\nstands.\n"
        self.assertEqual(prose.findings(text), [(3, "one row a run", prose.RULES[0][1]), (6, "stands", prose.RULES[2][1])])

    def test_paragraphs_are_apart(self):
        for text in ("One row\n\na run.", "What is a row\n\nleaves of it.", "| one row | a run |"):
            self.assertEqual(self.found(text), [], text)

    def test_what_is_not_prose(self):
        for text in ("```\nanew\n```", "- item\n\n  ```\n  anew\n  ```", "`anew`", "`a\nnew anew`", "    u = anew", "<!-- anew -->",
                     "<!-- begin: creepcontact list -->\nanew\n<!-- end -->", 'It says "begin anew" then.', "[page](anew.md)"):
            self.assertEqual(self.found(f"Text.\n\n{text}\n\nText."), [], text)
        for text in ("- item\n\n    anew in the item", "| a | anew |", "[anew](page.md)", "## Anew"):
            self.assertEqual(self.found(f"Text.\n\n{text}\n\nText."), [self.found(text)[0]], text)

    def test_code_counts_as_one_word(self):
        self.assertEqual(self.found("It has one `steps.csv` row a run."), ["one ___________ row a run"])

    def test_manual_page(self):
        page = '.TH ANEW 1\n.SH NAME\n.B anew\nOne a line, begun\n.I anew\nanew \\-\\-anew.\n.EX\nanew\n.EE\n'
        self.assertEqual([(line, what) for line, what, _ in prose.findings(prose.manual_prose(page))],
                         [(4, "One a line"), (6, "anew")])

    def test_comments_and_messages_of_code(self):
        code = ('#include "anew.hpp"\n// begins anew\nint anew = f("anew");  /// One row a\n/// run.\n'
                'fail("It begins anew at \\"{anew}\\" of "\n     "anew, a row " + anew, \'"\');  // `anew`\n'
                'R"(begins\nanew)"; /* begins anew */ g("in order", \'\\\'\');\n'
                'h();  // one row\nh();  // a run\nh("the file stands");\n')
        self.assertEqual([(line, what) for line, what, _ in prose.findings(prose.code_prose(code))],
                         [(2, "anew"), (3, "One row a run"), (5, "anew"), (6, "anew"), (11, "stands")])

    def test_beginnings_of_comments(self):
        for code in ("/// Of the normal rows.", "int a;  ///< By row of the problem", "/// Area. The same for edges.",
                     "int a;  ///< rows\n/// Of the body.", "/// One.\n/// Of the body."):
            self.assertEqual(len(prose.beginnings(f"int b;\n{code}\n")), 1, code)
        for code in ("// Of the normal rows.", "/// Normal rows. By default all.", "/// Rows\n/// Of a body.", "int a;  ///< of the body",
                     'f("/// Of");'):
            self.assertEqual(prose.beginnings(f"int b;\n{code}\n"), [], code)

    def test_long_sentences(self):
        words = " ".join(["word"] * prose.LONG_SENTENCE)
        for text in (f"{words}. {words}.", f"- {words}\n- {words}", f"{words}\n\n{words}", f"| {words} | {words} |"):
            self.assertEqual(list(prose.long_sentences(text)), [], text)
        self.assertEqual(list(prose.long_sentences(f"Short.\n\n{words}\nand more.")), [(3, prose.LONG_SENTENCE + 2)])


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        (self.root / "docs").mkdir()

    def check(self, **pages):
        for name, text in pages.items():
            (self.root / f"docs/{name}.md").write_text(text, encoding="utf-8")
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            count = prose.check(self.root, [f"docs/{name}.md" for name in pages])
        return count, printed.getvalue()

    def test_findings_name_file_and_line(self):
        self.assertEqual(self.check(bad="Good.\n\nIt begins anew.\n", good="It begins again.\n"),
                         (1, "docs/bad.md:3: anew; 'again'\n"))

    def test_code_files(self):
        (self.root / "include").mkdir()
        name = "include/a.hpp"
        (self.root / name).write_text("/// Of a row, begun anew.\n// begun anew\n", encoding="utf-8")
        with contextlib.redirect_stdout(io.StringIO()):
            self.assertEqual(prose.check(self.root, [name]), 3)

    def test_long_sentences_are_warnings(self):
        count, printed = self.check(long=f"{'word ' * 50}end.\n")
        self.assertEqual(count, 0)
        self.assertRegex(printed, r"^docs/long\.md:1: warning: a sentence of 51 words")

    @unittest.skipUnless(shutil.which("codespell"), "codespell is not installed")
    def test_misspelled_words(self):
        self.assertEqual(self.check(bad="Good.\nWe recieve it; Numer. Math.\n"), (1, "docs/bad.md:2: recieve; receive\n"))


if __name__ == "__main__":
    unittest.main()
