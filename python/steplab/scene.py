"""Scenes: particles and what acts on them."""

from __future__ import annotations

import os
from typing import Any, Callable

import numpy as np
import numpy.typing as npt

from ._core import Scene as _CoreScene
from ._arrays import array_from, number_from, of_type, path_from, texts_from, values_from, word_from
from ._errors import UsageError


class Scene:
    """Particles and the forces between them, as a value: nothing changes a scene, each ``with_...`` makes another one.
    A pickled scene holds all of it, also what was read from files.

    >>> chain = Scene.model("chain", n=5)
    >>> chain.particles, chain.parameters["k"]
    (5, 1)
    >>> chain.masses
    array([1., 1., 1., 1., 1.])
    """

    def __init__(self, *_: object) -> None:
        raise UsageError("make a scene by Scene.model(), Scene.from_file(), Scene.from_text() or Scene.from_arrays()")

    _core: _CoreScene

    @classmethod
    def _of(cls, core: _CoreScene) -> Scene:
        scene = object.__new__(cls)
        scene._core = core
        return scene

    @classmethod
    def model(cls, id: str, **parameters: Any) -> Scene:
        """A model of ``steplab.models()`` with these parameters; the others have their defaults."""
        return Scene._of(_CoreScene.model(word_from(id, "id"), texts_from(parameters)))

    @classmethod
    def from_file(cls, name: str | os.PathLike[str], **parameters: Any) -> Scene:
        """A scene file (TOML), or by a name of ``steplab.scenes()`` one that comes with steplab.

        >>> Scene.from_file("figure-eight").particles
        3
        """
        return Scene._of(_CoreScene.from_file(path_from(name, "name"), texts_from(parameters)))

    @classmethod
    def from_text(cls, text: str, **parameters: Any) -> Scene:
        """The text of a scene file that reads no other file."""
        return Scene._of(_CoreScene.from_text(word_from(text, "text"), texts_from(parameters)))

    @classmethod
    def from_arrays(
        cls,
        positions: npt.ArrayLike,
        velocities: npt.ArrayLike | None = None,
        masses: npt.ArrayLike | None = None,
    ) -> Scene:
        """Particles at positions (n, 3) [m] with velocities (n, 3) [m/s], else at rest, and masses (n,) [kg], else 1
        each. Nothing acts on them before ``with_pair_force()``.

        >>> Scene.from_arrays([[0, 0, 0], [1, 0, 0]], masses=[1, 3]).masses
        array([1., 3.])
        """
        x = array_from(positions, "positions", (None, 3))
        v = None if velocities is None else array_from(velocities, "velocities", x.shape)
        m = None if masses is None else array_from(masses, "masses", x.shape[:1])
        return Scene._of(_CoreScene.of(x, v, m))

    def with_parameters(self, **parameters: Any) -> Scene:
        """The same with other values of its parameters.

        >>> Scene.model("chain").with_parameters(k=4).parameters["k"]
        4
        """
        return Scene._of(self._core.with_parameters(texts_from(parameters)))

    def with_pair_force(self, potential: str, cutoff: float | None = None, **values: Any) -> Scene:
        """The same with a force between all pairs besides: by the name of a potential, or by an expression for the
        potential energy [J] in the distance r [m], the masses m1, m2 and the names that are given as `values`. The force
        is its exact derivative. Beyond the cut-off [m] it is 0; potential and force are shifted to reach 0 there.

        >>> pair = Scene.from_arrays([[0, 0, 0], [1.1, 0, 0]])
        >>> lj = pair.with_pair_force("4*epsilon*((s/r)^12 - (s/r)^6)", epsilon=2, s=1)
        >>> energy = run(lj, steps=0).potential[0]
        >>> bool(abs(energy - 8 * (1.1**-12 - 1.1**-6)) < 1e-14)
        True
        """
        limit = None if cutoff is None else number_from(cutoff, "cutoff")
        return Scene._of(self._core.with_force(word_from(potential, "potential"), texts_from(values), limit))

    def starting_at(self, positions: npt.ArrayLike, velocities: npt.ArrayLike) -> Scene:
        """The same particles and forces from other positions [m] and velocities [m/s], (n, 3) each.

        >>> chain = Scene.model("chain", n=3)
        >>> bool((chain.starting_at(chain.positions, 2 * chain.velocities).velocities == 2 * chain.velocities).all())
        True
        """
        shape = (self.particles, 3)
        x, v = array_from(positions, "positions", shape), array_from(velocities, "velocities", shape)
        return Scene._of(self._core.starting_at(x, v))

    @property
    def name(self) -> str:
        """The id of the model, or the name of the file."""
        return self._core.name

    @property
    def particles(self) -> int:
        return self._core.particles

    @property
    def parameters(self) -> dict[str, Any]:
        return values_from(self._core.parameters)

    @property
    def positions(self) -> npt.NDArray[np.float64]:
        """At the start, (n, 3) [m]."""
        return self._core.start()["positions"]

    @property
    def velocities(self) -> npt.NDArray[np.float64]:
        """At the start, (n, 3) [m/s]."""
        return self._core.start()["velocities"]

    @property
    def masses(self) -> npt.NDArray[np.float64]:
        """(n,) [kg]."""
        return self._core.start()["masses"]

    def text(self) -> str:
        """As a scene file, which gives the same bits. Raises UsageError, with the reason, for a scene that one text cannot
        hold: one that was given another start, or needs the files that it reads.

        >>> Scene.from_text(Scene.from_arrays([[0, 0, 0], [1, 0, 0]]).text()).particles
        2
        """
        return self._core.text()

    def __reduce__(self) -> tuple[Callable[[str], Scene], tuple[str]]:
        return _restored, (self._core.saved(),)

    def __repr__(self) -> str:
        return f"<steplab.Scene {self.name}: {self.particles} particle{'s' if self.particles != 1 else ''}>"


def core_of(scene: Any) -> _CoreScene:
    """What the library has of a scene that was given to a function."""
    known: Scene = of_type(scene, "scene", Scene, 'a steplab.Scene, such as Scene.model("chain")')
    return known._core


def _restored(saved: str) -> Scene:
    """How a scene is unpickled."""
    return Scene._of(_CoreScene.restored(saved))
