"""Scenes as values: pickled and written as text, they give the same bits."""

import os
import pickle
import sys
import tempfile
import unittest

import numpy as np
import support  # noqa: F401  (the program is there)

import steplab
from steplab import Scene

X = np.array([[0.0, 0.1, 0], [1.3, 0, 0], [0, 0, 1.7]])
V = np.array([[0.0, 0.1, 0], [-0.2, 0, 0], [0, 0.3, 0]])
M = np.array([1.0, 2.0, 0.7])
DROP = """steplab = 1
title = "drop"
[parameters]
strength = 2
[[particles]]
group = "drop"
file = "drop.xyz"
{more}
[[pairs]]
potential = "-strength/r"
{between}
"""


def hash_of(scene):
    return steplab.run(scene, steps=40, dt=0.01, check=False).hash


def pickled(scene):
    return pickle.loads(pickle.dumps(scene))


def written(folder, *, more="", between=""):
    """A scene file that reads its particles from another one; the path."""
    with open(os.path.join(folder, "drop.xyz"), "w") as particles:
        particles.write("3\nProperties=species:S:1:pos:R:3:velo:R:3:masses:R:1\n")
        for numbers in np.column_stack([X, V, M]).tolist():
            particles.write("X " + " ".join(map(repr, numbers)) + "\n")
    file = os.path.join(folder, "drop.toml")
    with open(file, "w") as scene:
        scene.write(DROP.format(more=more, between=between))
    return file


class Pickled(unittest.TestCase):
    def test_arrays_that_change_later_change_no_pickled_scene(self):
        x, v, m = X.copy(), V.copy(), M.copy()
        scene = Scene.from_arrays(x, v, m).with_pair_force("-m1*m2/r")
        moved = scene.starting_at(v, x)
        expected = hash_of(scene), hash_of(moved)
        for mine in (x, v, m):
            mine += 1
        self.assertEqual((hash_of(pickled(scene)), hash_of(pickled(moved))), expected)

    def test_scene_file_that_is_gone_or_has_changed(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = Scene.from_file(written(folder))
            variants = [
                scene,
                Scene.from_file(os.path.join(folder, "drop.toml"), strength=3),
                scene.with_parameters(strength=4),
                scene.with_pair_force("r^2/2"),
                scene.starting_at(2 * X, V),
                scene.starting_at(2 * X, V).with_pair_force("r^2/2").with_parameters(strength=1),
            ]
            expected = [hash_of(each) for each in variants]
            kept = [pickle.dumps(each) for each in variants]
            for content in ("changed", None):
                for name in ("drop.toml", "drop.xyz"):
                    file = os.path.join(folder, name)
                    if content is None:
                        os.remove(file)
                        continue
                    with open(file, "w") as out:
                        out.write(content)
                self.assertEqual([hash_of(pickle.loads(each)) for each in kept], expected)
        self.assertEqual(len(set(expected)), len(expected))
        self.assertEqual(pickle.loads(kept[0]).name, scene.name)
        self.assertEqual(pickle.loads(kept[1]).parameters, {"strength": 3})

    def test_everything_that_comes_with_steplab(self):
        for scene in [Scene.from_file(name) for name in steplab.scenes()] + [Scene.model(id) for id in steplab.models()]:
            with self.subTest(scene.name):
                self.assertEqual(hash_of(pickled(scene)), hash_of(scene))
                self.assertEqual(pickled(scene).parameters, scene.parameters)

    def test_other_texts_restore_no_scene(self):
        for text in ("", "{}", "[]", '{"model": "chian"}', Scene.model("chain")._core.saved()[:-9]):
            with self.assertRaises(steplab.FileError):
                steplab._core.Scene.restored(text)


class Texts(unittest.TestCase):
    def check(self, scene):
        self.assertEqual(hash_of(Scene.from_text(scene.text())), hash_of(scene))

    def refused(self, reason, scene):
        with self.assertRaisesRegex(steplab.UsageError, reason):
            scene.text()

    def test_of_arrays_and_forces(self):
        for arrays in ((X,), (X, V), (X, V, M), (-0.0 * X, V)):
            scene = Scene.from_arrays(*arrays)
            self.check(scene)
            self.check(scene.with_pair_force("A*exp(-r)", A=0.1 + 0.2, cutoff=3))
            self.check(scene.with_pair_force("gravity", G=1, softening=0.1).with_pair_force("r^2/2"))

    def test_of_a_file_that_reads_particles(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = Scene.from_file(written(folder, more="position = [0.1, 0.2, 0.3]\ncharge = 2"))
            self.check(scene)
            self.check(scene.with_parameters(strength=3))

    def test_are_refused_for_the_reason_that_holds(self):
        scene = Scene.from_arrays(X)
        self.refused(r"given another start \(arrays\)", scene.starting_at(X, V))
        for reason, change in (
            ("as the group that other parts", {"between": 'between = ["drop"]'}),
            ("for the parameters", {"more": 'position = ["strength", 0, 0]'}),
            ("for the random displacements", {"more": "displacement = { random = 0.1 }"}),
            ("for the temperature", {"more": "mass = 1\ntemperature = { kT = 0.1 }"}),
            ("reads its start from 'drop.xyz'", {"between": '[start]\nfrom = "drop.xyz"'}),
        ):
            with tempfile.TemporaryDirectory() as folder:
                self.refused(reason, Scene.from_file(written(folder, **change)))
        self.refused("at most 100000 particles", Scene.from_arrays(np.random.default_rng(1).random((100_001, 3))))

    def test_force_is_added_to_another_start(self):
        scene = Scene.from_arrays(X, V, M)
        before = scene.with_pair_force("r^2/2").starting_at(2 * X, V)
        self.assertEqual(hash_of(scene.starting_at(2 * X, V).with_pair_force("r^2/2")), hash_of(before))


if __name__ == "__main__":
    sys.exit(unittest.main())
