"""The lab as data: limits, comparisons, reports and advice."""

import subprocess
import sys
import unittest

import numpy as np
import support

import steplab
from steplab import Scene


class Lab(unittest.TestCase):
    def test_limits_of_all_methods(self):
        limits = {limit.method: limit for limit in steplab.limits(Scene.model("chain"))}
        self.assertGreaterEqual(set(limits), {"rk4", "verlet", "midpoint"})
        self.assertAlmostEqual(limits["verlet"].measured / limits["verlet"].theory, 1, delta=1e-3)
        self.assertEqual(limits["midpoint"].theory, 0)
        self.assertEqual(limits["implicit-midpoint"].theory, np.inf)
        self.assertIn("own steps", limits["taylor"].note)
        self.assertEqual(steplab.limits(Scene.model("chain"), "rk4"), [limits["rk4"]])

    def test_comparison_is_that_of_the_program(self):
        options = "compare --model chain --until 5 --samples 10 --run method=verlet,dt=0.1 --run method=rk4,dt=0.2"
        program = [support.PROGRAM, *options.split()]
        lines = subprocess.run(program, check=True, capture_output=True, text=True).stdout.split("\n")[1:-1]
        runs = [dict(method="verlet", dt=0.1), dict(method="rk4", dt=0.2)]
        for number, run in enumerate(steplab.compare(Scene.model("chain"), runs, until=5, samples=10)):
            cells = [line.split(",") for line in lines if line.split(",")[1] == str(number)]
            self.assertEqual(run.error.tolist(), [float(row[2]) for row in cells])
            self.assertEqual(run.reason, "")

    def test_comparison_of_a_run_that_diverges_ends(self):
        good, bad = steplab.compare(Scene.model("chain"), [dict(dt=0.1), dict(dt=3)], until=300)
        self.assertLess(len(bad.times), len(good.times))
        self.assertNotEqual(bad.reason, "")

    def test_report_has_series_of_the_methods(self):
        runs = steplab.report(Scene.model("oscillator"), until=10, methods=["verlet", "rk4"], precisions="double")
        self.assertEqual({run.method for run in runs}, {"verlet", "rk4"})
        self.assertEqual({run.precision for run in runs}, {"double"})
        self.assertGreater(len(runs), 8)
        best = min(runs, key=lambda run: run.error)
        self.assertEqual(best.method, "rk4")

    def test_advice_keeps_the_error_when_its_command_is_run(self):
        chain = Scene.model("chain")
        advice = steplab.advise(chain, error=1e-5, until=10)
        self.assertLessEqual(advice.best.error, 1e-5)
        self.assertEqual(support.summary(advice.command)["hash"], advice.best.hash)
        self.assertGreater(len(advice.others), 2)
        with self.assertRaisesRegex(steplab.UsageError, "cannot be verified"):
            steplab.advise(chain, error=1e-30, until=10, methods="verlet")

    def test_order_of_methods(self):
        pair = Scene.from_arrays([[0, 0, 0], [1.2, 0, 0]], [[0, 0.4, 0], [0, -0.4, 0]]).with_pair_force("-1/r")
        for method, order in (("euler", 1), ("velocity-verlet", 2), ("rk4", 4)):
            # the next power of dt is a few per cent of the error where rounding ends the series of rk4
            self.assertAlmostEqual(steplab.order(pair, method, until=2), order, delta=0.2)
        with self.assertRaisesRegex(steplab.UsageError, "own steps"):
            steplab.order(pair, "dop853", until=2)

    def test_wrong_questions(self):
        chain = Scene.model("chain")
        for work in (
            lambda: steplab.compare(chain, [], until=1),
            lambda: steplab.compare(chain, [{}] * 5, until=1),
            lambda: steplab.compare(chain, [{}], until=-1),
            lambda: steplab.compare(chain, [{}], until=float("nan")),
            lambda: steplab.compare(chain, [{}], until=1, samples=0),
            lambda: steplab.advise(chain, error=0, until=1),
            lambda: steplab.report(chain, until=1, methods="rk5"),
            lambda: steplab.report(chain, until=1, precisions="half"),
            lambda: steplab.limits(chain, precision="half"),
        ):
            with self.assertRaises(steplab.UsageError):
                work()


if __name__ == "__main__":
    sys.exit(unittest.main())
