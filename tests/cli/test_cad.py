"""CAD models: faces, proposals, named surfaces, cuts, and the page that shows a model."""

import json
import math
import pathlib
import shutil
import subprocess
import unittest

from process_case import ProcessTest
from test_runs import PROGRAM
from waiting import LONGEST

HERE = pathlib.Path(__file__).parent
CAD = HERE / "cad"
VIEWER = pathlib.Path(PROGRAM).resolve().parents[1] / "viewer"

MODEL = """units = "mm, N, MPa, h, degC"
[mesh]
file = "model.step"
size = 8
%s
[surfaces.hole]
body = "plate"
kind = "cylinder"
radius = 8
[surfaces.pin_side]
face = 8
[bodies.plate]
region = "plate"
material = "steel"
[bodies.pin]
region = "pin _1_"
material = "steel"
[bodies.washer]
region = "washer"
material = "steel"
[materials.steel]
young_modulus = 2e5
poisson_ratio = 0.3
[[supports]]
on = "plate_bottom"
displacement = { x = 0, y = 0, z = 0 }
[surfaces.plate_bottom]
plane = { origin = [0, 0, 0], normal = [0, 0, 1] }
[[contacts]]
name = "fit"
between = ["pin_side", "hole"]
gap = -0.02
[surfaces.washer_below]
touches = "plate"
body = "washer"
[surfaces.plate_top]
touches = "washer"
[[contacts]]
name = "washer"
type = "tied"
between = ["washer_below", "plate_top"]
[time]
end = 1
[[probes]]
name = "hole_area"
quantity = "contact_area"
on = "pin_side"
"""


class Cad(ProcessTest):
    def copied(self, name="model.step"):
        shutil.copy(CAD / "plate_and_pin.step", self.directory / name)

    def faces(self, *words):
        done = self.call("faces", *words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_faces_have_kinds_radii_and_neighbours(self):
        self.copied("M.STEP")  # whatever the case
        text = self.faces("M.STEP")
        self.assertSays(text, "3 bodies, 14 faces", "lengths in mm (in the file: millimetre)", "body 'plate'",
                        "cylinder, hollow radius 8, axis z", "interference 0.02: 8 of 'pin _1_'", "body 'washer'")
        data = json.loads(self.faces("M.STEP", "--json"))
        faces = {face["number"]: face for face in data["faces"]}
        self.assertEqual(len(faces), 14)
        hole, pin = faces[7], faces[8]
        self.assertEqual((hole["kind"], hole["hollow"], pin["hollow"]), ("cylinder", True, False))
        self.assertAlmostEqual(hole["radius"], 8, delta=1e-6)
        self.assertAlmostEqual(pin["radius"], 8.02, delta=1e-6)
        self.assertAlmostEqual(hole["area"], 2 * math.pi * 8 * 10, delta=1e-6)  # of the surface, not of facets
        pairs = {tuple(pair["faces"]): pair for pair in data["pairs"]}
        self.assertEqual(set(pairs), {(7, 8), (3, 13)})
        self.assertEqual(pairs[7, 8]["state"], "interference")
        self.assertAlmostEqual(pairs[7, 8]["distance"], -0.02, delta=1e-6)
        self.assertEqual(pairs[3, 13]["state"], "touching")
        self.assertAlmostEqual(pairs[3, 13]["area"], math.pi * (18**2 - 10**2), delta=0.06 * math.pi * 224)

    def test_lengths_are_converted(self):
        step = (CAD / "plate_and_pin.step").read_text()
        self.write("metres.step", step.replace("SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT($,.METRE.)"))
        data = json.loads(self.faces("metres.step", "--json", "--unit", "m"))
        self.assertEqual((data["unit"], data["unit_of_file"]), ("m", "metre"))
        self.assertAlmostEqual(data["faces"][6]["radius"], 8, delta=1e-5)
        self.assertSays(self.faces("metres.step"), "lengths in mm (in the file: metre)", "radius 8000")

    def test_a_proposal_is_a_configuration(self):
        self.copied()
        self.assertSays(self.faces("model.step", "--propose", "mine.toml"), "proposed: ", "mine.toml")
        text = (self.directory / "mine.toml").read_text()
        self.assertSays(text, "plate_to_washer", "plate_to_pin _1_", "touching", "plate_washer", "interference of 0.02", "gap = -0.02")
        check = self.call("check", "mine.toml")
        self.assertSays(check.stdout, "contact 'plate_washer'", "distance in the mesh 0", "contact 'plate_pin _1_'", "gap -0.02")
        again = self.call("faces", "model.step", "--propose", "mine.toml")
        self.assertEqual(again.returncode, 2)
        self.assertSays(again.stderr, "mine.toml", "exists")

    def test_surfaces_by_rules_and_numbers(self):
        self.copied()
        self.write("model.toml", MODEL % "")
        check = self.call("check", "model.toml", "--start")
        self.assertEqual(check.returncode, 0, check.stderr)
        self.assertSays(check.stdout, "contact 'fit'", "master 'hole' on 'plate'", "contact 'washer'", "tied",
                        "no mistakes found")

    def test_a_cut_keeps_numbers_and_names_its_faces(self):
        self.copied()
        cut = 'cut = [{ axis = "x", keep = "+" }, { axis = "y", keep = "-" }]'
        whole = MODEL % ""
        quarter = (MODEL % cut).replace("[time]", "[[supports]]\non = 'cut_x'\ndisplacement = { x = 0 }\n"
                                        "[[supports]]\non = 'cut_y'\ndisplacement = { y = 0 }\n[time]")
        areas = []
        for name, text in (("whole", whole), ("quarter", quarter)):
            self.write(f"{name}.toml", text)
            run = self.call("run", f"{name}.toml", "--output", name, "--quiet")
            self.assertEqual(run.returncode, 0, run.stderr)
            areas.append(json.loads((self.directory / name / "summary.json").read_text())["probes"]["hole_area"]["start"])
        self.assertAlmostEqual(areas[1] / areas[0], 0.25, delta=0.02)

    def test_sizes_are_those_of_the_elements(self):
        self.copied()
        count = {}
        for name, more in (("coarse", ""), ("fine", 'sizes = [{ on = "plate_bottom", size = 2 }]'),
                           ("pin", 'sizes = [{ body = "pin", size = 1.5 }]')):
            self.write("model.toml", MODEL % more)
            text = self.call("check", "model.toml").stdout
            count[name] = {line.split("'")[1]: int(line.split(":")[1].split()[0])
                           for line in text.splitlines() if line.startswith("body ")}
        self.assertGreater(count["fine"]["plate"], 3 * count["coarse"]["plate"])
        self.assertGreater(count["pin"]["pin"], 3 * count["coarse"]["pin"])
        self.assertLess(count["pin"]["washer"], 3 * count["coarse"]["washer"])

    def test_mistakes_are_named(self):
        self.copied()
        shutil.copy(CAD / "shell.step", self.directory)
        self.write("words.step", "no CAD at all\n")
        for words, status, *facts in (
            (("faces", "shell.step"), 3, "shell.step", "no solid", "2 faces"),
            (("faces", "words.step"), 3, "words.step", "not what the name says", "ISO-10303-21"),
            (("faces", "missing.step"), 3, "missing.step"),
            (("faces", "model.txt"), 2, ".step", ".toml"),
            (("check", "model.step"), 2, "--page"),
        ):
            done = self.call(*words)
            self.assertEqual(done.returncode, status, (words, done.stderr))
            self.assertSays(done.stderr, *facts)
        for change, *facts in (
            (("face = 8", "face = 99"), "pin_side", "no face 99", "1 to 14"),
            (("radius = 8\n", "radius = 7\n"), "hole", "no face is meant", "0 faces are of the radius 7", "8"),
            (('touches = "plate"', 'touches = "plat"'), "washer_below", "no body 'plat'", "plate"),
            (('kind = "cylinder"', 'kind = "zylinder"'), "zylinder", "cylinder"),
            (('units = "mm, N, MPa, h, degC"', 'units = "furlong"'), "units", "length"),
            (("size = 8", 'size = 8\nparameters = { h = 1 }'), "parameters", ".geo"),
            (("size = 8", 'size = 8\ncut = [{ axis = "x", keep = "+", at = 1000 }]'), "cut", "leaves nothing"),
            (("size = 8", 'size = 8\nsizes = [{ on = "nowhere", size = 1 }]'), "nowhere", "[surfaces]"),
        ):
            text = MODEL % ""
            self.assertIn(change[0], text)
            self.write("model.toml", text.replace(*change, 1))
            done = self.call("check", "model.toml")
            self.assertIn(done.returncode, (2, 3), (change, done.stdout))
            self.assertSays(done.stderr, *facts)

    def test_surfaces_of_a_mesh(self):
        self.write("block.geo", "SetFactory('OpenCASCADE');\nBox(1) = {0, 0, 0, 3, 2, 1};\nMesh.MeshSizeMax = 1;\n"
                                "Physical Volume('block') = {1};\n")
        self.assertSays(self.faces("block.geo"), "1 bodies, 6 faces", "plane", "area 2", "area 6")
        self.write("block.toml", """[mesh]
file = "block.geo"
[surfaces.low]
plane = { normal = [0, 0, 1] }
[surfaces.high]
box = [[0, 0, 1], [3, 2, 1]]
[bodies.block]
region = "block"
material = "m"
[materials.m]
young_modulus = 1000
poisson_ratio = 0
[[supports]]
on = "low"
displacement = { x = 0, y = 0, z = 0 }
[[loads]]
on = "high"
pressure = 2
[time]
end = 1
[[probes]]
name = "force"
quantity = "reaction_z"
on = "low"
""")
        run = self.call("run", "block.toml", "--output", "out")
        self.assertEqual(run.returncode, 0, run.stderr)
        force = json.loads((self.directory / "out/summary.json").read_text())["probes"]["force"]["start"]
        self.assertAlmostEqual(force, 12, delta=1e-9)


class Iges(ProcessTest):
    """A block of 30 x 20 x 10 with a bore: as a solid, and as faces alone, of which a solid is made."""

    def test_faces_with_their_lengths(self):
        for name in ("block.igs", "block_of_faces.iges"):
            shutil.copy(CAD / name, self.directory)
            for unit, scale in (("mm", 1), ("m", 1e-3)):
                with self.subTest(name, unit=unit):
                    done = self.call("faces", name, "--json", "--unit", unit)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    told = json.loads(done.stdout)
                    self.assertEqual([solid["name"] for solid in told["solids"]], ["solid_1"])
                    self.assertEqual((len(told["faces"]), told["loose_faces"]), (7, 0))
                    bore, = [face for face in told["faces"] if face["kind"] == "cylinder"]
                    self.assertAlmostEqual(bore["radius"] / scale, 4, delta=1e-6)
                    self.assertTrue(bore["hollow"])
                    self.assertAlmostEqual(sum(face["area"] for face in told["faces"]) / scale**2,
                                           2 * (600 + 300 + 200) - 2 * math.pi * 16 + 80 * math.pi, delta=1e-3)

    def test_of_other_bytes(self):
        for content in (b"", b"no model", (CAD / "block.igs").read_bytes()[:4000]):
            (self.directory / "block.igs").write_bytes(content)
            done = self.call("faces", "block.igs")
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertSays(done.stderr, "error: ", "block.igs")


class ModelPage(ProcessTest):
    """Opened in headless Chromium: pick, name, export, read back."""

    def check_in_browser(self):
        script = VIEWER / "test" / "check_model.mjs"
        done = subprocess.run(["node", script, self.directory / "page.html", self.directory / "names.toml"],
                              capture_output=True, text=True, timeout=LONGEST)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_names_that_are_given_come_back(self):
        shutil.copy(CAD / "plate_and_pin.step", self.directory / "model.step")
        self.write("model.toml", MODEL % "")
        page = self.call("check", "model.toml", "--page", "page.html")
        self.assertEqual(page.returncode, 0, page.stderr)
        self.assertSays(page.stdout, "page: page.html", "no mistakes found")
        self.check_in_browser()
        names = (self.directory / "names.toml").read_text()
        self.write("named.toml", MODEL % "" + names)
        check = self.call("check", "named.toml")
        self.assertEqual(check.returncode, 0, check.stderr)

    def test_a_section(self):
        """Its faces are lines, which have a band on the inner side."""
        for name in ("shrink_fit_section.toml", "shrink_fit_section.geo"):
            shutil.copy(HERE.parents[1] / "configs" / name, self.directory)
        page = self.call("check", "shrink_fit_section.toml", "--page", "page.html")
        self.assertEqual(page.returncode, 0, page.stderr)
        self.check_in_browser()

    def test_a_model_alone(self):
        shutil.copy(CAD / "plate_and_pin.brep", self.directory)
        page = self.call("check", "plate_and_pin.brep", "--page", "page.html")
        self.assertEqual((page.returncode, page.stderr), (0, ""))
        self.check_in_browser()


if __name__ == "__main__":
    unittest.main()
