"""What check, run and report say of heat."""

import html
import json
import pathlib
import re
import shutil
import unittest

from process_case import ProcessTest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Heat(ProcessTest):
    def copied(self, *files):
        for file in files:
            shutil.copy(ROOT / file, self.directory)

    def test_a_joint_that_loses_its_pressure_at_the_speed_of_heat(self):
        self.copied("configs/shrink_fit_heat.toml", "configs/shrink_fit_heat.geo")
        check = self.call("check", "shrink_fit_heat.toml", "--start")
        self.assertSays(check.stdout, "film on 'rim'", "coefficient up to 5", "element Biot number 1.4", "see --start")
        run = self.call("run", "shrink_fit_heat.toml", "--output", "out")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertSays(run.stderr, "contact 'fit' loses the last", "at the speed of heat")
        self.assertSays(run.stdout, "balance: ", "contact 'fit' lost its pressure at the speed of heat")
        heat = json.loads((self.directory / "out/summary.json").read_text())["heat"]
        (loss,) = heat["sudden_losses"]
        self.assertEqual(loss["contact"], "fit")
        self.assertAlmostEqual(loss["time"], 22950, delta=20)
        self.assertLess(loss["time"] - loss["since"], 3)
        self.assertLess(abs(heat["rest"]), 1e-6 * max(map(abs, heat["flows"].values())))
        report = self.call("report", "out", "--output", "page.html")
        self.assertEqual(report.returncode, 0, report.stderr)
        page = html.unescape((self.directory / "page.html").read_text())
        for text in ("at the speed of heat", "comes back through pressure and conductance", "Heat that flows at the end",
                     "missing in the sum", "element Biot number", "What heats and cools", "film, coefficient 5",
                     "3*(p/50)^0.95", "How long a change of temperature takes"):
            self.assertIn(text, page)

    def test_check_has_the_steady_state_of_the_end(self):
        self.copied("docs/tutorial_heat/hot_fit.toml", "docs/tutorial_heat/hot_fit.geo")
        text = self.call("check", "hot_fit.toml").stdout
        self.assertSays(text, "steady state with what acts at t = 100000", "446.", "532.", "balance: ")
        # 140 K over the resistances of the rings, their surfaces and the fit
        flow = float(re.search(r"film on 'rim' of body 'ring' +([-0-9.]+)", text)[1])
        self.assertAlmostEqual(flow / 701124, 1, delta=1e-4)

    def test_where_nothing_flows_no_rounding_is_reported(self):
        self.copied("docs/tutorial_heat/hot_fit.toml", "docs/tutorial_heat/hot_fit.geo")
        run = self.call("heat", "hot_fit.toml", "--set", 'heat.start="steady"', "--set", "time.end=0", "--output", "out")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertNotIn("balance: ", run.stdout)
        heat = json.loads((self.directory / "out/summary.json").read_text())["heat"]
        self.assertEqual(set(heat["flows"].values()), {0})
        self.assertEqual(heat["rest"], 0)

    def test_other_data_than_those_kept_are_named(self):
        self.copied("docs/tutorial_heat/hot_fit.toml", "docs/tutorial_heat/hot_fit.geo")
        keep = ["heat", "hot_fit.toml", "--set", 'heat.keep="kept"', "--set", "time.end=1", "--set", "time.output=[]", "--output"]
        self.call(*keep, "one")
        again = self.call(*keep, "two", "--set", "heat.films[1].coefficient=3")
        self.assertSays(again.stdout + again.stderr, "coefficient of the film on 'rim' of body 'ring'", "was 2", "is now 3")


if __name__ == "__main__":
    unittest.main()
