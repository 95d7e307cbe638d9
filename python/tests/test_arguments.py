"""Every argument of every function: wrong ones end in one clear sentence of the module's family."""

import os
import sys
import tempfile
import unittest

import numpy as np
import support  # noqa: F401  (the program is there)

import steplab
from steplab import Scene, UsageError

CHAIN = Scene.model("chain", n=3)
OSCILLATOR = Scene.model("oscillator")
SIMULATION = steplab.Simulation(CHAIN)
X = np.eye(3)
ODD = [
    None, True, 3, -1, 1.5, float("nan"), float("inf"), 1j, 10**400, 10**5000, "foo", "", "\ud800", "\0", b"x", b"\0", [], [1],
    ["verlet"], [None], [[1, 2], [3]], [[[1]], 2], {}, {1: 2}, {"a": object()}, {"k": [1]}, {"\ud800": 1}, (), object(),
    lambda: 0, np.array([1, 2]), np.array([[1.0]]), np.array(["a"]), CHAIN, Scene,
]


def short(**given):
    return {"steps": 2, **given}


#: how each argument is given, beside others that are right
CALLS = {
    "model id": Scene.model,
    "model parameter": lambda v: Scene.model("chain", k=v),
    "from_file name": Scene.from_file,
    "from_file parameter": lambda v: Scene.from_file("figure-eight", k=v),
    "from_text text": Scene.from_text,
    "positions": Scene.from_arrays,
    "velocities": lambda v: Scene.from_arrays(X, v),
    "masses": lambda v: Scene.from_arrays(X, None, v),
    "with_parameters": lambda v: CHAIN.with_parameters(k=v),
    "potential": CHAIN.with_pair_force,
    "cutoff": lambda v: CHAIN.with_pair_force("1/r", v),
    "force value": lambda v: CHAIN.with_pair_force("A/r", A=v),
    "start positions": lambda v: CHAIN.starting_at(v, X),
    "start velocities": lambda v: CHAIN.starting_at(X, v),
    "run scene": lambda v: steplab.run(v, steps=2),
    "run steps": lambda v: steplab.run(CHAIN, steps=v),
    **{
        f"run {name}": lambda v, name=name: steplab.run(CHAIN, **short(**{name: v}))
        for name in ("method", "dt", "every", "precision", "parameters", "threads", "positions", "velocities", "check")
    },
    "run until": lambda v: steplab.run(CHAIN, until=v),
    "read file": steplab.read,
    "read first": lambda v: steplab.read("/no/such.xyz", first=v),
    "read every": lambda v: steplab.read("/no/such.xyz", every=v),
    "simulation scene": steplab.Simulation,
    "simulation parameters": lambda v: steplab.Simulation(CHAIN, parameters=v),
    "advance": SIMULATION.advance,
    "out": SIMULATION.positions,
    "width": lambda v: SIMULATION.snapshot(v, 3),
    "height": lambda v: SIMULATION.snapshot(3, v),
    "camera": lambda v: SIMULATION.snapshot(3, 3, v),
    "limits scene": lambda v: steplab.limits(v, "verlet"),
    "limits methods": lambda v: steplab.limits(OSCILLATOR, v),
    "limits precision": lambda v: steplab.limits(OSCILLATOR, "verlet", v),
    "compare scene": lambda v: steplab.compare(v, [{}], until=1),
    "compare runs": lambda v: steplab.compare(CHAIN, v, until=1),
    "compare run": lambda v: steplab.compare(CHAIN, [v], until=1),
    "compare dt": lambda v: steplab.compare(CHAIN, [{"dt": v}], until=1),
    "compare until": lambda v: steplab.compare(CHAIN, [{}], until=v),
    "compare samples": lambda v: steplab.compare(CHAIN, [{}], until=1, samples=v),
    "report scene": lambda v: steplab.report(v, until=1, methods="rk4"),
    "report until": lambda v: steplab.report(OSCILLATOR, until=v, methods="rk4", precisions="double"),
    "report methods": lambda v: steplab.report(OSCILLATOR, until=1, methods=v, precisions=["float"]),
    "report precisions": lambda v: steplab.report(OSCILLATOR, until=1, methods="rk4", precisions=v),
    "report quick": lambda v: steplab.report(OSCILLATOR, until=1, methods="rk4", quick=v),
    "advise scene": lambda v: steplab.advise(v, error=1e-3, until=1, methods="rk4"),
    "advise error": lambda v: steplab.advise(OSCILLATOR, error=v, until=1, methods="rk4"),
    "order scene": lambda v: steplab.order(v, "rk4", until=1),
    "order method": lambda v: steplab.order(OSCILLATOR, v, until=1),
    "order until": lambda v: steplab.order(OSCILLATOR, "rk4", until=v),
}


class EveryArgument(unittest.TestCase):
    def test_takes_odd_values_or_refuses_them_in_one_sentence(self):
        refused = 0
        for name, call in CALLS.items():
            for number, value in enumerate(ODD):
                with self.subTest(name, number=number):
                    try:
                        call(value)
                    except steplab.Error as error:
                        refused += 1
                        self.check_sentence(str(error))
        self.assertGreater(refused, len(CALLS) * len(ODD) // 2)

    def check_sentence(self, message):
        self.assertNotRegex(message, r"(?<![\w-])--[a-z]", "it names an option of the command line")
        self.assertNotIn("\n", message)
        self.assertTrue(0 < len(message) < 600, message)


class Messages(unittest.TestCase):
    def refused(self, message, work):
        with self.assertRaisesRegex(UsageError, message):
            work()

    def test_of_scenes(self):
        for call in (steplab.run, steplab.limits, steplab.Simulation):
            for wrong in ("chain", None, 3):
                self.refused("scene must be a steplab.Scene", lambda: call(wrong))

    def test_of_lists_and_dicts(self):
        compare = lambda runs: lambda: steplab.compare(OSCILLATOR, runs, until=1)  # noqa: E731
        self.refused(r"parameters must be a dict of values by name \(got \[1\]\)", lambda: steplab.run(CHAIN, parameters=[1]))
        self.refused(r"methods must be a text or a list of texts \(got 3\)", lambda: steplab.limits(OSCILLATOR, 3))
        self.refused(r"methods\[1\] must be a text \(got 3\)", lambda: steplab.limits(OSCILLATOR, ["rk4", 3]))
        self.refused(r"runs\[0\] must be a dict, such as .* \(got 'verlet'\)", compare(["verlet"]))
        self.refused(r"runs must be a list of dicts", compare({"method": "rk4"}))
        self.refused(r"runs\[1\]: dt must be a number \(got 'a'\)", compare([{}, {"dt": "a"}]))
        self.refused(r"positions must be an array of real numbers of the shape \(n, 3\)", lambda: Scene.from_arrays([[1, 2], [3]]))

    def test_of_texts_and_files(self):
        self.refused("text must be Unicode text .character 1 is a lone surrogate", lambda: Scene.from_text("a\ud800"))
        self.refused("name must be the path of a file", lambda: Scene.from_file(3))
        self.refused("file must be the path of a file", lambda: steplab.read(3))
        self.refused("file must be the path of a file", lambda: steplab.read("a.xyz\0b"))

    def test_of_pictures(self):
        self.refused("camera must be a text", lambda: SIMULATION.snapshot(100, 100, 3))
        self.refused("^camera must be default, front, side", lambda: SIMULATION.snapshot(camera="foo"))
        self.refused("width must be an integer from 1 to 8192", lambda: SIMULATION.snapshot(8193, 1))

    def test_name_no_options_of_the_command_line(self):
        text = "steplab = 1\n[parameters]\nk = 1\n[[particles]]\n[run]\ndt = 'k'\n"
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "none.xyz")
            with open(file, "w") as out:
                out.write("hello\n")
            for work in (
                lambda: steplab.run(CHAIN, method="dop853", dt=-0.1),
                lambda: Scene.from_text(text),
                lambda: steplab.read(file),
            ):
                with self.assertRaises(steplab.Error) as raised:
                    work()
                self.assertNotRegex(str(raised.exception), r"(?<![\w-])--[a-z]")

    def test_of_file_names_that_are_no_text(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.fsencode(folder) + b"/\xff.toml"
            with self.assertRaisesRegex(steplab.FileError, "no such file"):
                Scene.from_file(file)
            with open(file, "w") as out:
                out.write(OSCILLATOR.text())
            self.assertEqual(os.fsencode(Scene.from_file(file).name), b"\xff")


class Memory(unittest.TestCase):
    def test_of_rows_is_refused_before_the_run(self):
        for given in ({"steps": 10**12}, {"until": 1e14}, {"steps": 10**13, "positions": False, "velocities": False}):
            with self.assertRaisesRegex(UsageError, r"rows of 3 particles need .*B of memory, .*B are available"):
                steplab.run(CHAIN, every=1, **given)

    def test_of_samples_is_refused(self):
        with self.assertRaisesRegex(UsageError, "samples must be an integer from 1 to 1000000000000"):
            steplab.compare(CHAIN, [{}], until=1, samples=10**13)

    def test_of_samples_in_range_is_refused(self):
        with self.assertRaisesRegex(UsageError, "samples of 4 runs need .*B of memory, .*B are available"):
            steplab.compare(CHAIN, [{}] * 4, until=1, samples=10**12)


if __name__ == "__main__":
    sys.exit(unittest.main())
