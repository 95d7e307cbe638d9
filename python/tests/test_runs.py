"""Runs: the bits of the program, rows as arrays, interruption, divergence."""

import concurrent.futures
import os
import signal
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy as np
from support import PROGRAM, summary

import steplab
from steplab import Scene


def written_by_the_program(folder):
    """A trajectory of 11 rows of a chain."""
    file = os.path.join(folder, "chain.trajectory")
    run = [PROGRAM, "run", "--model", "chain", "--steps", "30", "--every", "3", "--out", file]
    subprocess.run(run, check=True, capture_output=True)
    return file


class Runs(unittest.TestCase):
    def test_has_the_hash_of_the_program(self):
        given = "--model chain --set n=20 --method pefrl --dt 0.05 --until 30"
        chain = Scene.model("chain", n=20)
        run = steplab.run(chain, method="pefrl", dt=0.05, until=30, every=7)
        self.assertEqual(run.hash, summary(given)["hash"])
        self.assertNotEqual(run.hash, summary(given + " --set k=1.01")["hash"])

    def test_has_it_in_float_and_with_parameters_of_the_method(self):
        run = steplab.run(
            Scene.model("mesh", dim=9, kick="corner"),
            method="rk4", precision="float", parameters={"compensated": 1}, dt=0.02, steps=50,
        )
        same = "--model mesh --set dim=9 --set kick=corner --method rk4 --precision float --set compensated=1 --dt 0.02 --steps 50"
        self.assertEqual(run.hash, summary(same)["hash"])

    def test_has_it_for_scene_files_of_the_shipped_ones(self):
        for name in ("figure-eight", "lennard-jones-drop"):
            self.assertEqual(steplab.run(Scene.from_file(name), steps=20).hash, summary(f"--scene {name} --steps 20")["hash"])

    def test_rows_are_arrays_of_the_run(self):
        run = steplab.run(Scene.model("chain", n=4), steps=25, every=10)
        self.assertEqual(run.steps.tolist(), [0, 10, 20, 25])
        self.assertEqual(run.positions.shape, (4, 4, 3))
        self.assertEqual(run.velocities.dtype, np.float64)
        np.testing.assert_allclose(run.energy, run.kinetic + run.potential, rtol=1e-15)
        np.testing.assert_allclose(run.times, 0.1 * run.steps, rtol=1e-15)

    def test_rows_hold_the_memory_that_the_library_filled(self):
        run = steplab.run(Scene.model("chain", n=4), steps=10, every=1)
        self.assertEqual(type(run.positions.base).__name__, "PyCapsule", "nothing was copied")
        self.assertTrue(run.positions.flags.writeable and run.positions.flags.c_contiguous)
        positions = run.positions
        expected = positions.copy()
        del run
        np.testing.assert_array_equal(positions, expected)

    def test_leaves_out_what_is_not_wanted(self):
        run = steplab.run(Scene.model("chain"), steps=3, positions=False, velocities=False)
        self.assertIsNone(run.positions)
        self.assertIsNone(run.velocities)
        self.assertEqual(len(run.energy), 2)

    def test_diverged_run_has_its_valid_rows(self):
        with self.assertRaises(steplab.Diverged) as raised:
            steplab.run(Scene.model("chain"), dt=3, every=1)
        self.assertEqual(raised.exception.exit_code, 4)
        self.assertTrue(np.isfinite(raised.exception.run.positions).all())
        self.assertEqual(steplab.run(Scene.model("chain"), dt=3, check=False).status, "diverged")

    def test_trajectory_is_read_back(self):
        with tempfile.TemporaryDirectory() as folder:
            file = written_by_the_program(folder)
            trajectory = steplab.read(file)
            here = steplab.run(Scene.model("chain"), steps=30, every=3)
            np.testing.assert_array_equal(trajectory.positions, here.positions)
            np.testing.assert_array_equal(trajectory.velocities, here.velocities)
            self.assertIn("--model chain", trajectory.run)
            self.assertEqual(steplab.read(file, first=2, every=4).steps.tolist(), [6, 18, 30])
            self.assertEqual(steplab.read(file, first=100).positions.shape, (0, 10, 3))
            with open(file, "r+b") as cut:
                cut.truncate(os.path.getsize(file) - 40)
            self.assertFalse(steplab.read(file).complete)
            self.assertIn("truncated", steplab.read(file).fault)

    def test_files_of_every_format_are_read(self):
        with tempfile.TemporaryDirectory() as folder:
            whole = written_by_the_program(folder)
            expected = steplab.read(whole)
            for ending in ["csv", "xyz", "xyz.gz", "csv.zst", "lammpstrj", "lammpstrj.gz"]:
                file = os.path.join(folder, "chain." + ending)
                subprocess.run([PROGRAM, "convert", whole, "--out", file], check=True, capture_output=True)
                read = steplab.read(file)
                np.testing.assert_array_equal(read.steps, expected.steps, ending)
                np.testing.assert_array_equal(read.positions, expected.positions, ending)
                np.testing.assert_array_equal(read.velocities, expected.velocities, ending)
                self.assertTrue(read.complete, ending)
                self.assertEqual(steplab.read(file, first=2, every=4).steps.tolist(), [6, 18, 30])

    def test_rows_before_a_damaged_one_are_read(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "two.xyz")
            frame = '1\nProperties=species:S:1:pos:R:3 Time={}\nX 1 2 {}\n'
            with open(file, "w") as out:
                out.write(frame.format(0, 3) + frame.format(1, 4) + frame.format(2, "four"))
            read = steplab.read(file)
            self.assertEqual(read.positions[:, 0, 2].tolist(), [3, 4])
            self.assertFalse(read.complete)
            self.assertIn("four", read.fault)
            with self.assertRaises(steplab.FileError):
                steplab.read(os.path.join(folder, "none.xyz"))


class Interruption(unittest.TestCase):
    """A signal that comes while the library computes what would take hours: without an answer ctest ends the test."""

    def check(self, work):
        threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            work()

    def test_ends_a_run(self):
        self.check(lambda: steplab.run(Scene.model("mesh", dim=100), steps=10**8))

    def test_ends_a_report_and_its_threads(self):
        self.check(lambda: steplab.report(Scene.model("mesh", dim=15), until=200, quick=False))
        self.assertEqual(steplab.run(Scene.model("chain"), steps=5).status, "ok", "the next one is not interrupted")

    def test_loses_a_simulation(self):
        simulation = steplab.Simulation(Scene.model("mesh", dim=100))
        self.check(lambda: simulation.advance(10**8))
        with self.assertRaisesRegex(steplab.UsageError, "lost"):
            simulation.positions()

    def test_other_threads_run_meanwhile(self):
        counted = 0
        runner = threading.Thread(target=lambda: steplab.run(Scene.model("mesh", dim=60), steps=3000, threads=1))
        runner.start()
        while runner.is_alive():
            counted += 1
        runner.join()
        self.assertGreater(counted, 1000)

    def test_runs_of_several_threads_have_their_own_bits(self):
        from concurrent.futures import ThreadPoolExecutor

        scenes = [Scene.model("chain", v0=1 + i / 10) for i in range(8)]
        alone = [steplab.run(scene).hash for scene in scenes]
        with ThreadPoolExecutor(4) as pool:
            self.assertEqual([run.hash for run in pool.map(steplab.run, scenes)], alone)
        self.assertEqual(len(set(alone)), len(alone))


class Simulations(unittest.TestCase):
    def test_goes_where_the_run_goes(self):
        chain = Scene.model("chain", n=5)
        simulation = steplab.Simulation(chain, method="verlet", dt=0.1)
        simulation.advance(30)
        simulation.advance(70)
        run = steplab.run(chain, method="verlet", dt=0.1, steps=100)
        self.assertEqual(simulation.hash, run.hash)
        np.testing.assert_array_equal(simulation.positions(), run.positions[-1])
        np.testing.assert_array_equal(simulation.velocities(), run.velocities[-1])
        out = np.empty((5, 3))
        self.assertIs(simulation.positions(out), out)
        np.testing.assert_array_equal(out, run.positions[-1])

    def test_forces_are_those_of_newton(self):
        simulation = steplab.Simulation(Scene.model("free", n=3))
        np.testing.assert_allclose(simulation.forces()[:, 0], 0)
        self.assertLess(simulation.forces()[1, 1], 0)

    def test_stands_at_the_last_valid_step_where_it_diverges(self):
        simulation = steplab.Simulation(Scene.model("chain"), dt=3)
        with self.assertRaises(steplab.Diverged):
            simulation.advance(1000)
        self.assertTrue(np.isfinite(simulation.positions()).all())
        self.assertLess(simulation.step, 1000)


class Pictures(unittest.TestCase):
    def test_is_the_picture_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "rope.png")
            options = "snapshot --model rope --steps 20 --size 320x200 --out".split()
            subprocess.run([PROGRAM, *options, file], check=True, capture_output=True)
            simulation = steplab.Simulation(Scene.model("rope"))
            simulation.advance(20)
            picture = simulation.snapshot(320, 200)
            from matplotlib.image import imread

            expected = np.rint(255 * imread(file)).astype(np.uint8)
            np.testing.assert_array_equal(np.asarray(picture)[..., :3], expected[..., :3])
            other = os.path.join(folder, "again.png")
            with open(other, "wb") as png:
                png.write(picture._repr_png_())
            np.testing.assert_array_equal(np.rint(255 * imread(other)).astype(np.uint8), picture.pixels)

    def test_is_the_same_where_several_threads_draw(self):
        def picture_of(n):
            return steplab.Simulation(Scene.model("chain", n=n)).snapshot(160, 90).pixels

        sizes = [3, 4, 5, 6] * 5
        with concurrent.futures.ThreadPoolExecutor(4) as threads:
            for n, pixels in zip(sizes, threads.map(picture_of, sizes)):
                np.testing.assert_array_equal(pixels, picture_of(n))

    def test_refuses_sizes_and_views(self):
        simulation = steplab.Simulation(Scene.model("chain"))
        for size in ((0, 10), (10, 9000), (1.5, 10)):
            with self.assertRaises(steplab.UsageError):
                simulation.snapshot(*size)
        with self.assertRaises(steplab.UsageError):
            simulation.snapshot(64, 64, camera="nowhere")


if __name__ == "__main__":
    sys.exit(unittest.main())
