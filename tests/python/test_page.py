"""The page on Python is what its notebook does today, and the package is described and typed."""

import inspect
import pathlib
import subprocess
import sys
import unittest

import creepcontact as cc

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = pathlib.Path(cc.__file__).parent


class Page(unittest.TestCase):
    def test_it_is_up_to_date(self):
        done = subprocess.run([sys.executable, "-I", ROOT / "scripts/renew_notebook", "--check", PACKAGE.parent],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_everything_is_described(self):
        for name in cc.__all__:
            thing = getattr(cc, name)
            if not callable(thing):
                continue
            self.assertTrue(inspect.getdoc(thing), name)
            if not inspect.isclass(thing):
                self.assertNotIn(inspect.Parameter.empty, [p.annotation for p in inspect.signature(thing).parameters.values()], name)
                continue
            for member, value in vars(thing).items():
                if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                    function = value.fget if isinstance(value, property) else value
                    if not isinstance(function, classmethod) and inspect.isfunction(function):
                        self.assertIn("return", inspect.get_annotations(function), f"{name}.{member}")

    def test_the_module_has_what_its_stub_says(self):
        stub = (PACKAGE / "_core.pyi").read_text()
        from creepcontact import _core
        for line in stub.splitlines():
            if line.startswith(("def ", "class ")):
                name = line.split()[1].split("(")[0].rstrip(":")
                self.assertTrue(hasattr(_core, name), name)
        for name in vars(_core):
            if not name.startswith("_") and name not in ("RunResult", "State"):
                self.assertIn(name, stub)


if __name__ == "__main__":
    unittest.main()
