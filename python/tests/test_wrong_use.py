"""Wrong use: each has a message of its own, of one family of exceptions, and nothing crashes."""

import pickle
import sys
import unittest

import numpy as np
import support  # noqa: F401  (the program is there)

import steplab
from steplab import Scene, UsageError

GOOD = np.array([[0.0, 0, 0], [1, 0, 0]])


class Arrays(unittest.TestCase):
    def refused(self, message, *given, **named):
        with self.assertRaisesRegex(UsageError, message):
            Scene.from_arrays(*given, **named)

    def test_shapes(self):
        self.refused(r"positions must have the shape \(n, 3\) \(got \(2, 2\)\)", GOOD[:, :2])
        self.refused(r"positions must have the shape", GOOD.ravel())
        self.refused(r"positions must have the shape", 3.0)
        self.refused(r"velocities must have the shape \(2, 3\)", GOOD, GOOD[:1])
        self.refused(r"masses must have the shape \(2,\)", GOOD, masses=[1, 2, 3])
        self.refused("at least one particle", np.empty((0, 3)))

    def test_types(self):
        self.refused("positions must be real numbers.*complex128", GOOD.astype(complex))
        self.refused("positions must be real numbers", [["a", "b", "c"]])
        self.refused("positions must be real numbers.*object", np.array([[None, 0, 0]]))
        self.refused("positions must be real numbers.*bool", GOOD.astype(bool))

    def test_other_numbers_and_strides_are_taken_by_value(self):
        wide = np.arange(24, dtype=np.int16).reshape(4, 6)[::2, ::2]
        scene = Scene.from_arrays(wide, np.asfortranarray(wide, dtype=np.float32))
        np.testing.assert_array_equal(scene.positions, wide)
        np.testing.assert_array_equal(scene.velocities, wide)

    def test_arrays_that_are_read_only_are_read(self):
        fixed = GOOD.copy()
        fixed.flags.writeable = False
        np.testing.assert_array_equal(Scene.from_arrays(fixed).positions, GOOD)

    def test_arrays_that_change_later_change_no_scene(self):
        mine = GOOD.copy()
        scene = Scene.from_arrays(mine)
        mine[0] = 7
        np.testing.assert_array_equal(scene.positions, GOOD)
        np.testing.assert_array_equal(pickle.loads(pickle.dumps(scene)).positions, GOOD)

    def test_numbers_that_are_none(self):
        for wrong in (np.nan, np.inf, -np.inf):
            bad = GOOD.copy()
            bad[1, 2] = wrong
            self.refused("positions of particle 1 are not finite", bad)
            self.refused("velocities of particle 1 are not finite", GOOD, bad)
            self.refused("masses must be finite", GOOD, masses=[1, wrong])
        self.refused("masses must be finite and > 0", GOOD, masses=[1, 0])

    def test_arrays_to_fill(self):
        simulation = steplab.Simulation(Scene.model("chain", n=4))
        read_only = np.empty((4, 3))
        read_only.flags.writeable = False
        for message, out in (
            ("read-only", read_only),
            ("dtype float64", np.empty((4, 3), np.float32)),
            (r"shape \(4, 3\)", np.empty((3, 4))),
            ("contiguous", np.empty((4, 6))[:, ::2]),
            ("NumPy array", [[0.0] * 3] * 4),
        ):
            for fill in (simulation.positions, simulation.velocities, simulation.forces):
                with self.assertRaisesRegex(UsageError, message):
                    fill(out)


class Values(unittest.TestCase):
    def test_numbers(self):
        chain = Scene.model("chain")
        for wrong in ("a", None, [1], 1j, object()):
            with self.assertRaisesRegex(UsageError, "until must be a number|k must be"):
                Scene.model("chain", k=wrong) if wrong in ("a", None) else steplab.run(chain, until=wrong)
        for wrong in (-1, 1.5, "3", 2**60, float("nan"), float("inf")):
            with self.assertRaisesRegex(UsageError, "steps must be an integer"):
                steplab.run(chain, steps=wrong)
        for wrong in (0, float("nan"), float("inf")):
            with self.assertRaisesRegex(UsageError, "dt"):
                steplab.run(chain, dt=wrong)

    def test_names(self):
        with self.assertRaisesRegex(UsageError, "chain"):
            Scene.model("chian")
        with self.assertRaisesRegex(UsageError, "rk4"):
            steplab.run(Scene.model("chain"), method="rk5")
        with self.assertRaisesRegex(UsageError, "parameter of the scene"):
            steplab.run(Scene.model("chain"), parameters={"k": 2})
        with self.assertRaisesRegex(UsageError, "method must be a text"):
            steplab.run(Scene.model("chain"), method=4)
        with self.assertRaisesRegex(UsageError, r"runs\[0\] has no 'stepz'"):
            steplab.compare(Scene.model("chain"), [{"stepz": 3}], until=1)

    def test_forces(self):
        pair = Scene.from_arrays(GOOD)
        for wrong in ("A/r", "1/(", "", "r\n[run]", 'r"', "\0"):
            with self.assertRaises(UsageError):
                pair.with_pair_force(wrong)
        with self.assertRaisesRegex(UsageError, "text"):
            pair.with_pair_force(lambda r: 1 / r)

    def test_too_much_memory_is_refused(self):
        with self.assertRaisesRegex(UsageError, "memory"):
            steplab.run(Scene.model("chain", n=10**15))

    def test_files(self):
        for work in (lambda: Scene.from_file("/no/such.toml"), lambda: steplab.read("/no/such.trajectory")):
            with self.assertRaisesRegex(steplab.FileError, "/no/such"):
                work()
        with self.assertRaisesRegex(steplab.FileError, "scene:"):
            Scene.from_text("[[particles]")
        with self.assertRaises(steplab.FileError):
            steplab.read(__file__)


class Family(unittest.TestCase):
    def test_has_the_exit_codes_of_the_program(self):
        codes = {steplab.UsageError: 2, steplab.FileError: 3, steplab.Diverged: 4, steplab.GraphicsError: 5}
        for error, code in codes.items():
            self.assertTrue(issubclass(error, steplab.Error))
            self.assertEqual(error.exit_code, code)
        self.assertTrue(issubclass(UsageError, ValueError) and issubclass(steplab.FileError, OSError))

    def test_scenes_and_runs_are_pickled(self):
        scene = (
            Scene.from_arrays(GOOD, masses=[1, 2])
            .with_pair_force("A*exp(-r)", A=2, cutoff=3)
            .starting_at(2 * GOOD, GOOD)
        )
        same = pickle.loads(pickle.dumps(scene))
        run = steplab.run(scene, steps=20)
        self.assertEqual(steplab.run(same, steps=20).hash, run.hash)
        again = pickle.loads(pickle.dumps(run))
        self.assertEqual(again.hash, run.hash)
        np.testing.assert_array_equal(again.positions, run.positions)

    def test_simulations_are_not(self):
        with self.assertRaisesRegex(UsageError, "pickle its scene"):
            pickle.dumps(steplab.Simulation(Scene.model("chain")))
        with self.assertRaisesRegex(UsageError, "make a scene by"):
            Scene()


if __name__ == "__main__":
    sys.exit(unittest.main())
