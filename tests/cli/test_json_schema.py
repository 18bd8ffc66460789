"""The JSON Schema of the keys, for editors: every configuration and study in the repository satisfies it; mistakes do not."""

import copy
import json
import os
import pathlib
import subprocess
import tomllib
import unittest

import jsonschema

from waiting import LONGEST

PROGRAM = os.environ["CREEPCONTACT_PROGRAM"]
ROOT = pathlib.Path(__file__).resolve().parents[2]
CONFIGS = sorted([*ROOT.glob("configs/*.toml"), *ROOT.glob("docs/tutorial*/*.toml")])
STUDIES = sorted(ROOT.glob("studies/*/*.toml"))


def call(*arguments):
    return subprocess.run([PROGRAM, "list", *arguments], capture_output=True, text=True, timeout=LONGEST)


def schema(what):
    return json.loads(call(what, "--json-schema").stdout)


def read(path):
    return tomllib.loads(path.read_text(encoding="utf-8"))


class JsonSchema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.schemas = {what: schema(what) for what in ("keys", "study-keys")}

    def mistakes(self, document, what="keys"):
        return [error.message for error in jsonschema.Draft7Validator(self.schemas[what]).iter_errors(document)]

    def test_schemas_are_valid(self):
        for one in self.schemas.values():
            jsonschema.Draft7Validator.check_schema(one)

    def test_every_file_of_the_repository_satisfies_its_schema(self):
        self.assertGreater(len(CONFIGS), 8)
        self.assertGreater(len(STUDIES), 8)
        for path in [*CONFIGS, *STUDIES]:
            document = read(path)
            with self.subTest(path.name):
                self.assertEqual(self.mistakes(document, "study-keys" if "base" in document else "keys"), [])

    def test_mistakes_are_found(self):
        right = read(ROOT / "configs/shrink_fit.toml")
        self.assertEqual(self.mistakes(right), [])

        def with_change(change):
            document = copy.deepcopy(right)
            change(document)
            return self.mistakes(document)

        def set_law_key(document, key, value):
            next(iter(document["materials"].values()))["creep"][0][key] = value

        changes = {
            "a key that there is not": lambda one: one["time"].update(finish=3),
            "a number out of bounds": lambda one: one["time"].update(tolerance=0.9),
            "a word that is none of them": lambda one: one.setdefault("contact_solver", {}).update(acceleration="fast"),
            "a missing key": lambda one: one["time"].pop("end"),
            "a key of another law": lambda one: set_law_key(one, "chi", 3),
            "a law that there is not": lambda one: set_law_key(one, "law", "nortn"),
            "a table without values": lambda one: one["contacts"][0].update(gap={"t": [0, 1]}),
            "a quantity that there is not": lambda one: one["probes"][0].update(quantity="pressure"),
        }
        for what, change in changes.items():
            with self.subTest(what):
                self.assertNotEqual(with_change(change), [])

    def test_editors_get_descriptions_defaults_and_words(self):
        time = self.schemas["keys"]["properties"]["time"]["properties"]
        self.assertIn("[time]", time["end"]["description"])
        self.assertEqual(time["tolerance"]["default"], 1e-4)
        self.assertEqual(time["linear_solver"]["enum"], ["krylov", "tangent"])

    def test_it_describes_all_keys_and_goes_with_no_other_form(self):
        for arguments in (["laws"], ["keys", "time"], ["keys", "--names"]):
            done = call(*arguments, "--json-schema")
            self.assertEqual(done.returncode, 2)
            self.assertIn("--json-schema", done.stderr)


if __name__ == "__main__":
    unittest.main()
