"""What the program says of wrong values of creep laws and rupture data; nothing is computed."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from says import Says
from waiting import LONGEST

PROGRAM = os.environ["CREEPCONTACT_PROGRAM"]

CONFIG = """[mesh]
file = "block.msh"
[bodies.block]
region = "all"
material = "steel"
[materials.steel]
young_modulus = 2e5
poisson_ratio = 0.3
[time]
end = 10
"""


class LawErrors(Says, unittest.TestCase):
    def errors(self, text):
        """Lines of the message, without the place before the key."""
        with tempfile.TemporaryDirectory() as directory:
            config = pathlib.Path(directory) / "block.toml"
            config.write_text(CONFIG + text, encoding="utf-8")
            done = subprocess.run([PROGRAM, "check", str(config)], capture_output=True, text=True, timeout=LONGEST)
        lines = [line for line in done.stderr.splitlines() if "materials.steel" in line]
        if lines:
            self.assertEqual(done.returncode, 2, done.stderr)
        return [line[line.index("materials.steel"):] for line in lines]

    def expect(self, law, keys, *errors):
        """@param errors  of each line the key after creep[0], with which it begins, and the facts"""
        found = self.errors(f'[[materials.steel.creep]]\nlaw = "{law}"\n{keys}\n')
        self.assertEqual(len(found), len(errors), found)
        for line, (key, *facts) in zip(found, errors):
            begin = f"materials.steel.creep[0]{key}: "
            self.assertTrue(line.startswith(begin), line)
            self.assertSays(line[len(begin):], *facts)

    def test_ranges(self):
        self.expect("time_hardening", "A = -1\nn = 5\nm = 0", (".A", "-1", ">= 0"), (".m", "0", "> 0"))
        self.expect("strain_hardening", "A = nan\nn = 0.5\nm = 1.1", (".A", "nan"), (".n", "0.5"), (".m", "1.1", "(0, 1]"))
        self.expect("kachanov_rabotnov", "A = 1\nn = 5\nB = 1\nr = 4\nphi = 5\nalpha = 1.5", (".alpha", "1.5", "[0, 1]"))
        self.expect("maxwell", "viscosity = 0", (".viscosity", "0", "> 0"))
        self.expect("norton", "A = 1\nn = 5\nactivation_energy = -1\ngas_constant = 0",
                    (".activation_energy", "-1"), (".gas_constant", "0", "> 0"))

    def test_missing_keys(self):
        self.expect("ageing", "A = 1", (".n", "missing"), (".m", "missing"))
        self.expect("hereditary", "times = [1]", (".compliances", "missing"))

    def test_lists(self):
        self.expect("graham_walles", "A = [1, 2]\nn = [1, 2]\nm = [1]", (".m", "1", "'A'", "2"))
        self.expect("hereditary", "compliances = [1, 2]\ntimes = [1, 2]\nvolumetric_compliances = [1]",
                    (".volumetric_compliances", "1", "'compliances'", "2"))
        self.expect("hereditary", "compliances = []\ntimes = []", (".compliances", "empty"), (".times", "empty"))

    def test_lists_that_go_together(self):
        loop = "K = 100\nn = 10\nyield = 100\n"
        self.expect("chaboche", loop + "C = [1e5]", (".C", "'gamma'"))
        self.expect("chaboche", loop + "gamma = [100]", (".gamma", "'C'"))
        self.expect("chaboche", loop + "C = [1e5]\ngamma = [100]\nrecovery_exponent = [2]", (".recovery_exponent", "'recovery'"))
        self.expect("chaboche", loop + "C = [1e5]\ngamma = [100]\nrecovery = [1e-4]")
        self.expect("chaboche", loop + "C = [1e5, 1e4]\ngamma = [100, 0]\nrecovery = [1e-4]", (".recovery", "1", "'C'", "2"))

    def test_an_exponent_that_must_be_a_number(self):
        self.expect("strain_hardening", 'A = 1\nn = 5\nm = "0.3 + T/1e4"', (".m", "'0.3 + T/1e4'", "(0, 1]"))

    def test_named_laws(self):
        self.expect("norton_bailey", 'A = 1\nn = 5\nm = 0.4\nhardening = "strian"', (".hardening", "'strian'", "'strain'"))
        self.expect("norton_bailey", "A = 1\nn = 5\nm = 1.5", (".m", "1.5", "(0, 1]"))
        self.expect("norton_bailey", 'A = 1\nn = 5\nm = 1.5\nhardening = "time"')
        self.expect("rcc_mr", "C1 = 1\nC2 = 1.5\nn1 = 4\nC = 1\nn = 5", (".C2", "1.5", "(0, 1]"))
        self.expect("omega", "rate0 = -1\nomega = 0", (".rate0", "-1", ">= 0"), (".omega", "0", "> 0"))
        self.expect("omega", 'rate0 = "1e-20*q^8"\nomega = 40\nactivation_energy = 3e5', ("", "[temperature]"))
        self.expect("omega", 'rate0 = "1e-20*q^8*exp(T)"\nomega = 40', (".rate0", "[temperature]"))
        self.expect("omega", 'rate0 = "1e-20*q^8*t"\nomega = 40', (".rate0", "'1e-20*q^8*t'"))
        self.expect("theta_projection", "theta_1 = 1e-3\ntheta_2 = 1\ntheta_3 = 1e-3", (".theta_4", "missing"))
        self.expect("soderberg", "C = 1\np = 3\nr = 0\nA = 1\nn = 5", (".r", "0", "> 0"))
        self.expect("mpc_omega", "", (".law", "'mpc_omega'", "'omega'"))

    def test_laws_of_alloys(self):
        km = "rate0 = 1.5e11\nA = -0.248\nB = -0.492\nshear_modulus = 57634\n[temperature]\nvalue = 600\n"
        self.expect("kocks_mecking", "burgers = 2.019e-7\n" + km)
        self.expect("kocks_mecking", "burgers = 2.019e-10\n" + km, (".burgers", "2.019e-10", "one system of units"))
        self.expect("kocks_mecking", "burgers = 2.019e-7\n" + km.replace("A = -0.248", "A = 0.1"), (".A", "0.1"))
        tests = "stress = [80, 100, 60, 80]\nrate = [19e-6, 102e-6, 60e-6, 318e-6]\n"
        self.expect("rate_table", tests + "T = [700, 700, 750, 750]\n[temperature]\nvalue = 700")
        self.expect("rate_table", tests + "T = [700, 700, 750, 750]\n", ("", "[temperature]"))
        self.expect("rate_table", tests + "T = [700, 700, 750]\n", (".T", "3", "'stress'", "4"))
        self.expect("rate_table", "stress = [80, 80]\nrate = [1e-6, 2e-6]", (".stress", "80 twice"))
        self.expect("rate_table", "stress = [80, 100]\nrate = [2e-6, 1e-6]", (".rate", "1e-06", "100", "2e-06", "increase"))
        self.expect("rate_table", "stress = [0, 100]\nrate = [2e-6, 1e-6]", (".stress[0]", "0", "> 0"))
        self.expect("hayhurst", "rate0 = 1e-10\nK = 10\nh1 = 3e4\nH1_limit = 1.3\nsigma0 = 20\nalpha = 2",
                    (".H1_limit", "1.3", "[0, 1]"), (".alpha", "2", "[0, 1]"))
        self.expect("hayhurst", "rate0 = 1e-10\nK = 10\nh1 = 3e4\nH1_limit = 0.3")
        self.expect("hayhurst", "rate0 = 1e-10\nK = 10\nh1 = 3e4\nH1_limit = 0.3\nA = 1e-6", ("", "'sigma0' is missing", "A", "> 0"))
        curve = "".join(f'{key}_{i} = "1e-6*q"\n' for key in ("limit", "speed", "rate") for i in (1, 2))
        self.expect("booker", 'strength = 400\nchange = "1e5*exp(-q/U)"\n' + curve)
        self.expect("booker", 'strength = "400 - U"\nchange = 1e5\n' + curve, (".strength", "'400 - U'", "U"))

    def test_expressions(self):
        self.expect("expression", 'rate = "1e-13*q^5*s"', (".rate", "'1e-13*q^5*s'", "s"))
        self.expect("expression", "rate = -1", (".rate", "-1"))

    def test_an_activation_energy_needs_a_temperature(self):
        self.expect("norton", "A = 1\nn = 5\nactivation_energy = 3e5", ("", "[temperature]"))
        self.expect("norton", "A = 1\nn = 5\nactivation_energy = 3e5\n[temperature]\nvalue = 500")

    def test_rupture_data(self):
        for data, facts in (("stress = [100, 50]\nparameter = [2e4, 1e4]\n", (".stress: ", "50", "100", "increase")),
                            ("stress = [50, 100]\nparameter = [1e4, 2e4]\n", (".parameter: ", "20000", "10000", "decrease"))):
            found = self.errors("[temperature]\nvalue = 500\n[materials.steel.rupture]\n" + data)
            self.assertEqual(len(found), 1, found)
            self.assertSays(found[0], "materials.steel.rupture" + facts[0], *facts[1:])


CUBE = """Point(1) = {0, 0, 0}; Point(2) = {1, 0, 0}; Point(3) = {1, 1, 0}; Point(4) = {0, 1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve{1, 2, 3, 4} = 2; Transfinite Surface{1}; Recombine Surface{1};
out[] = Extrude {0, 0, 1} { Surface{1}; Layers{1}; Recombine; };
Physical Volume("all") = {out[1]};
Physical Surface("z0") = {1}; Physical Surface("y0") = {out[2]};
Physical Surface("x1") = {out[3]}; Physical Surface("x0") = {out[5]};
"""
PULLED = """
[[loads]]
on = "x1"
pressure = -100
[[probes]]
name = "creep"
quantity = "creep_strain_xx"
body = "block"
""" + "".join(f'[[supports]]\non = "{axis}0"\ndisplacement = {{ {axis} = 0 }}\n' for axis in "xyz")


class LawRuns(Says, unittest.TestCase):
    """A cube under tension."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.directory = pathlib.Path(temporary.name)
        (self.directory / "cube.geo").write_text(CUBE, encoding="utf-8")

    def run_law(self, keys, *options, integrator="auto"):
        text = CONFIG.replace('"block.msh"', '"cube.geo"\norder = 1') + f'integrator = "{integrator}"\n'
        text += "[output]\ndirectory = \"out\"\n" + PULLED + keys
        (self.directory / "block.toml").write_text(text, encoding="utf-8")
        return subprocess.run([PROGRAM, "run", "block.toml", *options], cwd=self.directory, capture_output=True,
                              text=True, timeout=LONGEST)

    def creep(self, law, keys):
        return f'\n[[materials.steel.creep]]\nlaw = "{law}"\n{keys}\n'

    def summary(self):
        return json.loads((self.directory / "out/summary.json").read_text(encoding="utf-8"))

    def test_a_rate_that_overflows_names_material_place_and_stress(self):
        done = self.run_law(self.creep("expression", 'rate = "exp(q^3)"'))
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertSays(done.stderr, "t = 0", "material 'steel'", "body 'block' at (", " 100 ")

    def test_theories_that_do_not_mix(self):
        done = self.run_law(self.creep("ageing", "A = 1e-14\nn = 5\nm = 0.5"))
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn('time.integrator = "isochronous"', done.stderr)
        done = self.run_law(self.creep("norton", "A = 1e-14\nn = 5"), integrator="isochronous")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn('law = "ageing"', done.stderr)
        rupture = '\n[materials.steel.rupture]\nrupture_time = "1e12/q^4"\n'
        done = self.run_law(self.creep("ageing", "A = 1e-14\nn = 5\nm = 0.5") + rupture, integrator="isochronous")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertSays(done.stderr, "rupture")

    def test_rupture_is_an_end_as_good_as_any(self):
        # (phi + 1) B q^r = 1/5
        law = self.creep("kachanov_rabotnov", "A = 1e-14\nn = 5\nB = 4e-12\nr = 5\nphi = 4")
        for options, end in (([], "ruptured: t = 5;"), (["--resume"], "rupture at t = 5\n")):
            done = self.run_law(law, *options)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertNotIn("warning", done.stderr)
            self.assertIn(end, done.stdout)
            summary = self.summary()
            self.assertEqual(summary["status"], "ruptured")
            self.assertAlmostEqual(summary["rupture"]["time"], 5.0, places=4)
            self.assertEqual(summary["rupture"]["body"], "block")
            rows = (self.directory / "out/history.csv").read_text(encoding="utf-8").splitlines()
            self.assertAlmostEqual(float(rows[-1].split(",")[0]), 5.0, places=4)
            self.assertEqual(len(rows), len({row.split(",")[0] for row in rows}))


if __name__ == "__main__":
    unittest.main()
