"""creepcontact fit: from a file of tests to a run with the law."""

import json
import math
import os
import pathlib
import subprocess
import tempfile
import tomllib
import unittest

from says import Says, first_missing
from waiting import LONGEST

PROGRAM = os.environ["CREEPCONTACT_PROGRAM"]
CONFIGS = pathlib.Path(__file__).parents[2] / "configs"

RUN = """[mesh]
file = "block.geo"
[bodies.block]
region = "all"
material = "steel"
[[supports]]
on = "bottom"
displacement = { x = 0, y = 0, z = 0 }
[[loads]]
on = "top"
traction = [0, 0, 300]
[time]
end = 1e-3
output = [1e-3]
integrator = "cvode_bdf"
"""
GEO = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Physical Volume("all") = {1};
Physical Surface("bottom") = {5};
Physical Surface("top") = {6};
Transfinite Curve {:} = 2; Transfinite Surface {:}; Transfinite Volume {:}; Recombine Surface {:};
"""


class Fit(Says, unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = pathlib.Path(directory.name)

    def fit(self, data, *arguments):
        if isinstance(data, str):
            path = self.directory / "data.csv"
            path.write_text(data, encoding="utf-8")
            data = path
        return subprocess.run([PROGRAM, "fit", str(data), *arguments], capture_output=True, text=True, timeout=LONGEST,
                              cwd=self.directory)

    def refused(self, data, *arguments):
        done = self.fit(data, *arguments)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        return done.stderr

    def test_constants_of_the_example(self):
        done = self.fit(CONFIGS / "creep_tests.csv", "--law", "kachanov_rabotnov")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = {words[0]: words for line in done.stdout.split("correlation")[0].splitlines()
                if len(words := line.split()) > 4}
        for key, truth in {"A": 2e-17, "n": 5, "B": 4e-15, "r": 4.5, "phi": 6}.items():
            low, high = float(rows[key][2]), float(rows[key][4])
            self.assertTrue(low / 1.3 < truth < high * 1.3, done.stdout)
            self.assertLess(low, float(rows[key][1]))
        self.assertIn("[[materials.fitted.creep]]\nlaw = \"kachanov_rabotnov\"", done.stdout)

    def test_thousands_of_the_office(self):
        rows = [f"{t:,.0f}".replace(",", ".") + f";{s};" + f"{1e-12 * s ** 4 * t:.6f}".replace(".", ",")
                for s in (60, 80, 100) for t in (500, 1000, 2000)]
        data = "time [h];stress [MPa];strain\n" + "\n".join(rows) + "\n"
        self.assertIn("1.000;", data)
        self.assertSays(self.refused(data, "--law", "norton"), "data.csv: ", "6 rows", "lines 3-4", "'1.000'", "line 2", '--thousands "."')
        done = self.fit(data, "--law", "norton", "--thousands", ".")
        self.assertEqual(done.returncode, 0, done.stderr)
        constants = dict(line.split("#")[0].split(" = ") for line in done.stdout.splitlines() if line.startswith(("A = ", "n = ")))
        self.assertAlmostEqual(float(constants["A"]) / 1e-12, 1, delta=0.01)
        self.assertAlmostEqual(float(constants["n"]), 4, delta=0.01)
        self.assertSays(self.refused(data, "--law", "norton", "--thousands", ";"), "--thousands: ", "';'")

    def test_names_of_files_end_no_comment(self):
        for name in ("a\nlaw = 3\n.csv", "\x1b[31m\r.csv", os.fsdecode(b"Pr\xfcfung.csv")):
            path = self.directory / name
            path.write_text("stress,rate\n" + "".join(f"{s},{1e-12 * s ** 4}\n" for s in (50, 60, 70, 80)))
            done = self.fit(path, "--law", "norton", "--output", "block.toml")
            self.assertEqual(done.returncode, 0, done.stderr)
            block = (self.directory / "block.toml").read_text(encoding="utf-8")
            tomllib.loads(block)
            self.assertNotIn("\x1b", block)
            self.assertNotIn("\nlaw = 3", block)

    def test_many_readings(self):
        """Those of the search are some, those of the minimum all."""
        with open(self.directory / "many.csv", "w", encoding="utf-8") as file:
            file.write("test,time [h],stress [MPa],strain\n")
            for test, s in enumerate((60, 80, 100)):
                for i in range(1, 8001):
                    file.write(f"t{test},{i},{s},{1e-12 * s ** 4 * i * (1 + 0.01 * (-1) ** i):.9g}\n")
        done = self.fit(self.directory / "many.csv", "--law", "norton")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertSays(done.stderr, "24000 readings")
        self.assertIn("24000 readings of 3 tests", done.stdout)
        self.assertRegex(done.stdout, r"(?m)^n = (4|3\.9999|4\.0000)")

    def test_the_block_runs_and_its_range_is_watched(self):
        done = self.fit(CONFIGS / "creep_tests.csv", "--law", "norton", "--material", "steel", "--young-modulus", "1.5e5",
                        "--output", "steel.toml")
        self.assertEqual(done.returncode, 2)  # the strain is creep strain, below the elastic one
        self.assertSays(done.stderr, "below the elastic strain")
        data = "time [h],stress [MPa],creep_strain\n" + "".join(
            f"{t},{s},{1e-16 * s**5 * t * f}\n" for s in (50, 100, 150) for t, f in ((10, 1.02), (100, 0.97), (1000, 1.01)))
        done = self.fit(data, "--law", "norton", "--material", "steel", "--young-modulus", "1.5e5", "--output", "steel.toml")
        self.assertEqual(done.returncode, 0, done.stderr)
        for picture in ("creep.png", "residuals.png"):
            self.assertGreater((self.directory / "steel_plots" / picture).stat().st_size, 5000)
        (self.directory / "block.geo").write_text(GEO, encoding="utf-8")
        block = (self.directory / "steel.toml").read_text(encoding="utf-8")
        (self.directory / "run.toml").write_text(RUN + block, encoding="utf-8")
        run = subprocess.run([PROGRAM, "run", "run.toml", "-o", "out"], capture_output=True, text=True, timeout=LONGEST,
                             cwd=self.directory)
        self.assertEqual(run.returncode, 0, run.stderr)
        warnings = json.loads((self.directory / "out/summary.json").read_text(encoding="utf-8"))["warnings"]
        self.assertEqual(len([w for w in warnings if "stress_range" in w and "(50 .. 150)" in w]), 1)
        (self.directory / "run.toml").write_text((RUN + block).replace("end = 1e-3", "end = 1e4"), encoding="utf-8")
        check = subprocess.run([PROGRAM, "check", "run.toml"], capture_output=True, text=True, timeout=LONGEST,
                               cwd=self.directory)
        self.assertSays(check.stdout + check.stderr, "t = 10000", "10 times", "time_range", "(10 .. 1000)")

    def test_the_file_is_taken_by_use_and_converted(self):
        data = "Zeit [h];Spannung [MPa];Kriechdehnung [%]\n" + "".join(
            f"{t};{s};{1e-14 * s**5 * t * f:.6g}\n" for s in (50, 100, 150) for t, f in ((10, 1.02), (100, 0.97), (1000, 1.01)))
        (self.directory / "block.geo").write_text(GEO, encoding="utf-8")
        for options, use in (((), '["steel.toml/fitted", "grade_91"]'), (("--young-modulus", "1.6e5"), '"steel.toml/fitted"')):
            done = self.fit(data, "--law", "norton", "--output", "steel.toml", *options)
            self.assertEqual(done.returncode, 0, done.stderr)
            fitted = tomllib.loads((self.directory / "steel.toml").read_text(encoding="utf-8"))["materials"]["fitted"]["creep"][0]
            text = RUN.replace("[time]", f"[materials.steel]\nuse = {use}\nreference_temperature = 823.15\n[temperature]\nvalue = 823.15\n[time]").replace(
                "traction = [0, 0, 300]", "traction = [0, 0, 1e8]").replace("1e-3", "3.6e6")
            probe = '[[probes]]\nname = "creep"\nquantity = "creep_strain_equivalent"\nbody = "block"\nreduce = "mean"\n'
            (self.directory / "run.toml").write_text('units = "m, N, Pa, s, K"\n' + text + probe, encoding="utf-8")
            run = subprocess.run([PROGRAM, "run", "run.toml", "-o", "out"], capture_output=True, text=True, timeout=LONGEST,
                                 cwd=self.directory)
            self.assertEqual(run.returncode, 0, run.stderr)
            summary = json.loads((self.directory / "out/summary.json").read_text(encoding="utf-8"))
            expected = fitted["A"] * 100**fitted["n"] * 1000
            self.assertAlmostEqual(summary["probes"]["creep"]["end"] / expected, 1, delta=0.25)  # the bottom is held sideways
            self.assertIn("steel.toml/fitted", json.dumps(summary))

    def constants(self, output):
        """Value and interval of each fitted constant."""
        return {words[0]: (float(words[1]), float(words[2]), float(words[4])) for line in output.split("correlation")[0].splitlines()
                if len(words := line.split()) > 4 and words[3] == ".."}

    def test_published_times_to_rupture(self):
        """They lie along log t = const - r log S, whose regression and intervals are closed forms."""
        rows = [line.split(",") for line in (CONFIGS / "cmsx6_creep.csv").read_text(encoding="utf-8").splitlines()
                if not line.startswith("#")][1:]
        ruptures = [(float(row[1]), float(row[5])) for row in rows if row[5]]
        self.assertEqual(len(ruptures), 9)
        x, y = ([math.log(value) for value in column] for column in zip(*ruptures))
        mean_x, mean_y = sum(x) / 9, sum(y) / 9
        spread = sum((a - mean_x)**2 for a in x)
        r = -sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / spread
        scatter = math.sqrt(sum((b - mean_y + r * (a - mean_x))**2 for a, b in zip(x, y)) / 7)
        done = self.fit("time [h],stress [MPa]\n" + "".join(f"{time},{stress}\n" for stress, time in ruptures),
                        "--law", "kachanov_rabotnov", "--set", "A=1e-20", "--set", "n=7", "--set", "phi=5")
        self.assertEqual(done.returncode, 0, done.stderr)
        value, low, high = self.constants(done.stdout)["r"]
        self.assertAlmostEqual(value / r, 1, places=4)
        half_width = 2.36462 * scatter / math.sqrt(spread) / r  # Student's t of seven degrees of freedom
        self.assertAlmostEqual(math.log(high / value) / half_width, 1, places=2)
        self.assertAlmostEqual(math.log(value / low) / half_width, 1, places=2)

    def test_relaxation(self):
        """A bar of Norton's law relaxes by s = s0 (1 + (n - 1) E A s0^(n-1) t)^(-1/(n-1))."""
        E, A, n = 1.5e5, 3e-17, 5.5
        data = "time [h],stress [MPa],strain,kind\n"
        for start in (150, 250):
            data += f"0,{start},,relaxation\n"
            for t, error in ((1, 1.01), (10, 0.99), (100, 1.005), (1000, 0.995), (10000, 1)):
                data += f"{t},{error * start * (1 + (n - 1) * E * A * start**(n - 1) * t)**(-1 / (n - 1))},,relaxation\n"
        done = self.fit(data, "--law", "norton", "--young-modulus", str(E))
        self.assertEqual(done.returncode, 0, done.stderr)
        constants = self.constants(done.stdout)
        for key, truth in (("A", A), ("n", n)):
            self.assertTrue(constants[key][1] < truth < constants[key][2], done.stdout)
        self.assertAlmostEqual(constants["n"][0] / n, 1, places=2)

    def test_a_run_outside_of_the_temperatures_of_the_tests(self):
        rows = [(t, s, T, 1e4 * s**5 * math.exp(-4e5 / (8.314462618 * (T + 273.15))) * t * error)
                for T in (500, 550) for s in (100, 300) for t, error in ((10, 1.02), (100, 0.97), (1000, 1.01))]
        done = self.fit("time [h],stress [MPa],temperature [degC],creep_strain\n" + "".join(f"{t},{s},{T},{e}\n" for t, s, T, e in rows),
                        "--law", "norton", "--material", "steel", "--young-modulus", "1.5e5", "--output", "steel.toml")
        self.assertEqual(done.returncode, 0, done.stderr)
        (self.directory / "block.geo").write_text(GEO, encoding="utf-8")
        block = (self.directory / "steel.toml").read_text(encoding="utf-8")
        for temperature, is_outside in ((620, True), (450, True), (525, False)):
            (self.directory / "run.toml").write_text(
                (RUN + block).replace("[time]", f"[temperature]\nvalue = {temperature}\n[time]"), encoding="utf-8")
            run = subprocess.run([PROGRAM, "run", "run.toml", "-o", f"out{temperature}"], capture_output=True, text=True,
                                 timeout=LONGEST, cwd=self.directory)
            self.assertEqual(run.returncode, 0, run.stderr)
            warnings = [line for line in run.stderr.splitlines()
                        if first_missing(line, (f" {temperature},", "temperature_range", "(500 .. 550)")) is None]
            self.assertEqual(len(warnings), 1 if is_outside else 0, run.stderr)

    def test_bad_rows_are_named(self):
        message = self.refused("time [h],stress [MPa],strain [%]\n1,100,0.1\n2,100,abc\n3,-100,0.2\n4,100\n5,100,0.3\n",
                               "--law", "norton")
        self.assertSays(message, "data.csv:3: ", "'strain [%]'", "'abc'", "data.csv:4: ", "-100", "data.csv:5: ", "2", "3 columns")
        message = self.refused("time [h],stress [MPa],strain [%]\n1,100,0.1\n2,100,abc\n3,-100,0.2\n5,100,0.3\n2,100,0.4\n",
                               "--law", "norton")
        self.assertSays(message, "data.csv:3: ", "'strain [%]'", "'abc'", "data.csv:4: ", "-100", "> 0", "data.csv:6: ", "time 2 ", "5", "line 5")

    def test_units_that_cannot_be(self):
        self.assertSays(self.refused("time [MPa],stress,strain\n1,100,1\n", "--law", "norton"), "'time [MPa]'", "'MPa'", "hours")
        self.assertSays(self.refused("time,stress,strain\n1,100,1.5\n", "--law", "norton"), "data.csv:2: ", "1.5", "100 %")

    def test_one_stress(self):
        message = self.refused("time,stress,strain\n1,100,0.001\n2,100,0.002\n3,100,0.0031\n", "--law", "norton")
        self.assertSays(message, "stress 100", "A and n")
        done = self.fit("time,stress,strain\n1,100,0.001\n2,100,0.002\n3,100,0.0031\n", "--law", "norton", "--set", "n=5")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_what_cannot_be_right_is_said_with_numbers(self):
        norton = "time,stress,strain\n" + "".join(f"{t},{s},{1e-13 * s**5 * t}\n" for s in (50, 100) for t in (1, 2, 3))
        done = self.fit(norton, "--law", "norton", "--young-modulus", "2e11")
        self.assertSays(done.stderr, "elastic strain", "100", "5e-10", "modulus")
        done = self.fit(norton, "--law", "norton", "--set", "A=1e300")
        self.assertEqual(done.returncode, 4)
        self.assertSays(done.stderr, "finite", "50 to 100", "A = 1e+300")
        done = self.fit("time,stress,strain\n1,50,3e-3\n2,50,1e-3\n1,100,1e-2\n2,100,2e-2\n", "--law", "norton")
        self.assertSays(done.stderr, "test '50'", "0.003 (line 2)", "0.001 (line 3)")
        done = self.fit("time,stress,strain\n1,50,3e-3\n2,50,6e-3\n1,100,2e-3\n2,100,4e-3\n", "--law", "norton")
        self.assertSays(done.stderr, "n ", "range, 1")

    def test_a_modulus_in_another_unit(self):
        data = "time [h],stress [MPa],kind\n" + "".join(
            f"{t},{s / (1 + 0.1 * math.log1p(t))},relaxation\n" for s in (150, 110) for t in (0, 1, 10, 100, 1000))
        message = self.refused(data, "--law", "norton", "--young-modulus", "150")
        self.assertSays(message, "elastic strain", "100 %", "150", "150", "--young-modulus", "MPa")
        self.assertSays(self.fit(data, "--law", "norton", "--young-modulus", "5000").stderr, "elastic strain", "3 %", "--young-modulus")
        self.assertNotIn("elastic strain", self.fit(data, "--law", "norton", "--young-modulus", "150000").stderr)

    def test_a_law_that_does_not_describe_the_data_gives_no_block(self):
        data = "time,stress,creep_strain\n" + "".join(f"{t},{s},{1e-20 * s**6.5 * t}\n" for s in (50, 100, 200) for t in (10, 20, 30))
        done = self.fit(data, "--law", "omega", "--set", "omega=1", "--output", "omega.toml")
        self.assertEqual(done.returncode, 4, done.stdout + done.stderr)
        self.assertSays(done.stderr, "law 'omega'", "--set 'rate0=EXPRESSION in q, T'")
        self.assertIn("residuals", done.stdout)
        self.assertFalse((self.directory / "omega.toml").exists())
        done = self.fit(data, "--law", "omega", "--set", "rate0=1e-20*q^6.5")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("[[materials.fitted.creep]]", done.stdout)

    def test_values_that_are_impossible_together(self):
        message = self.refused(CONFIGS / "creep_tests.csv", "--law", "chaboche", "--set", "C=[1]")
        self.assertSays(message, "C: ", "'gamma'")

    def test_all_undetermined_constants_are_named(self):
        message = self.refused("time,stress\n100,100\n50,120\n30,150\n90,100\n52,120\n29,150\n10,200\n", "--law", "kachanov_rabotnov")
        self.assertSays(message, "A, n,", "B and phi", "--set A=... --set n=... --set phi=...")

    def test_specimens_are_counted_once(self):
        done = self.fit(CONFIGS / "cmsx6_creep.csv", "--law", "kachanov_rabotnov")
        self.assertIn("177 readings of 12 tests", done.stdout)

    def test_rupture_needs_damage(self):
        self.assertSays(self.refused("time,stress\n100,100\n50,120\n30,150\n", "--law", "norton"), "rupture")

    def test_a_foreign_file_is_kept(self):
        (self.directory / "mine.toml").write_text("title = 'mine'\n", encoding="utf-8")
        self.assertSays(self.refused("time,stress,strain\n1,1,1\n", "--law", "norton", "--output", "mine.toml"), "mine.toml")
        self.assertEqual((self.directory / "mine.toml").read_text(encoding="utf-8"), "title = 'mine'\n")


if __name__ == "__main__":
    unittest.main()
