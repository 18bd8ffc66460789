"""Probes of parts, planes and other probes, and events: their columns, summary.json and mistakes on the command line."""

import unittest

from test_runs import RunTest

PROBES = """probes=[
  { name = 'force', quantity = 'section_force_x', body = 'disc', scale = 1e-3, unit = 'kN',
    section = { origin = [0, 0, 0], normal = [1, 0, 0] } },
  { name = 'near', quantity = 'contact_pressure', on = 'disc_bore', where = 'z < 5' },
  { name = 'double', expression = '2*near + t' } ]""".replace("\n", " ")


class Probes(RunTest):
    def test_summary_of_probes(self):
        probes = PROBES.replace("origin = [0, 0, 0]", "origin = [60, 0, 0]")
        self.run_short("--quiet", "--set", probes)
        rows, summary = self.table("history.csv"), self.summary()["probes"]
        self.assertEqual(set(rows[0]), {"time", "force", "near", "double"})
        for row in rows:
            self.assertAlmostEqual(row["double"], 2 * row["near"] + row["time"], places=9)
        for name, probe in summary.items():
            values = [row[name] for row in rows]
            self.assertEqual([probe["start"], probe["end"]], [values[0], values[-1]])
            # The ends of all steps count, too.
            self.assertLessEqual(probe["min"], min(values))
            self.assertGreaterEqual(probe["max"], max(values))
            at = {row["time"]: row[name] for row in rows}
            self.assertEqual(at.get(probe["t_min"], probe["min"]), probe["min"])
            self.assertEqual(at.get(probe["t_max"], probe["max"]), probe["max"])
        self.assertEqual({name: probe["unit"] for name, probe in summary.items()},
                         {"force": "kN", "near": "MPa", "double": ""})

    def test_an_event_stops_the_run(self):
        self.run_short("--quiet", "--set", "events=[{ name = 'slack', when = 'fit_pressure < 64.55', stop = true }]")
        summary, rows = self.summary(), self.table("history.csv")
        self.assertEqual(summary["status"], "completed")
        self.assertEqual(summary["events"]["slack"], summary["time_reached"])
        self.assertEqual([row["time"] for row in rows], [0, 1, summary["time_reached"]])
        self.assertAlmostEqual(rows[-1]["fit_pressure"], 64.55, places=6)
        done = self.call("run", "--output", str(self.output), "--resume", "--set", "time.end=10", "--set",
                         "time.output=[1, 10]", "--set",
                         "events=[{ name = 'slack', when = 'fit_pressure < 64.55', stop = true }]")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertSays(done.stdout, "event 'slack'", "t = ", "stop = false")

    def test_mistakes(self):
        self.expect_error(self.call("check", "--set", "events=[{ name = 'a', when = 'fit_presure < 1' }]"), 2,
                          "events[0].when: ", "'fit_presure'", "'fit_pressure'")
        probes = PROBES.replace("origin = [0, 0, 0]", "origin = [1e4, 0, 0]").replace("z < 5", "z > 1e5")
        self.expect_error(self.call("run", "--output", str(self.output), "--set", probes), 3, "probes[0]: section: ",
                          "(10000, 0, 0)", "probes[1]: where: 'z > 1e5'")
        self.expect_error(self.call("run", "--set", PROBES.replace("2*near", "2*double")), 2,
                          "probes[2].expression: ", "'double' -> 'double'")


if __name__ == "__main__":
    unittest.main()
