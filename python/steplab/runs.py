"""Runs of scenes: whole ones, and a few steps at a time."""

from __future__ import annotations

import dataclasses
import functools
import os
from typing import Any, Mapping

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import array_to_fill, count_from, flag_from, number_from, path_from, texts_from, word_from
from ._errors import Diverged, UsageError
from .scene import Scene, core_of

Floats = npt.NDArray[np.float64]
Counts = npt.NDArray[np.uint64]


@dataclasses.dataclass(frozen=True, eq=False)
class Trajectory:
    """Rows of a run: f moments of n particles."""

    steps: Counts  #: (f,)
    times: Floats  #: (f,) [s]
    positions: Floats  #: (f, n, 3) [m]
    velocities: Floats  #: (f, n, 3) [m/s]
    run: str  #: how it was made: options of the command line; empty of a file that does not say it
    complete: bool  #: False if the file is damaged or cut off behind these rows
    fault: str  #: what is wrong there


@dataclasses.dataclass(frozen=True, eq=False)
class Run:
    """What a run recorded, in f rows of n particles, and how it ended."""

    steps: Counts  #: (f,)
    times: Floats  #: (f,) [s]
    kinetic: Floats  #: (f,) [J]
    potential: Floats  #: (f,) [J]
    energy: Floats  #: (f,) [J]
    energy_error: Floats  #: (f,) [J] since the start, the work of drag added where it is counted
    method: str
    precision: str
    dt: float  #: [s], as the precision holds it
    evaluations: int  #: of the forces
    status: str  #: "ok", "diverged" or "stopped"
    reason: str  #: why it is not "ok"; the rows then end with the last valid step
    hash: str  #: of the final state, as ``steplab run`` prints it
    notes: list[str]  #: what rounding does to the run; none as a rule
    error: float | None  #: largest distance from the exact solution at the end [m], where one is known
    wall_seconds: float
    positions: Floats | None = None  #: (f, n, 3) [m], if they were recorded
    velocities: Floats | None = None  #: (f, n, 3) [m/s], if they were recorded

    def __repr__(self) -> str:
        return f"<steplab.Run {self.method}, dt {self.dt:g}, {self.steps[-1]} steps: {self.status}, hash {self.hash}>"


def settings_from(
    method: str = "",
    dt: float | None = None,
    precision: str = "",
    parameters: Mapping[str, Any] | None = None,
    threads: int = 0,
    where: str = "",
) -> dict[str, Any]:
    """How a scene is stepped, as the library takes it. `where`: what messages have before the names."""
    return {
        "method": word_from(method, f"{where}method"),
        "dt": None if dt is None else number_from(dt, f"{where}dt"),
        "precision": word_from(precision, f"{where}precision"),
        "parameters": {} if parameters is None else texts_from(parameters, where),
        "threads": count_from(threads, f"{where}threads"),
    }


def run(
    scene: Scene,
    *,
    method: str = "",
    dt: float | None = None,
    steps: int | None = None,
    until: float | None = None,
    every: int = 0,
    precision: str = "",
    parameters: Mapping[str, Any] | None = None,
    threads: int = 0,
    positions: bool = True,
    velocities: bool = True,
    check: bool = True,
) -> Run:
    """Runs a scene, with the same bits as the program ``steplab run``, and records every `every`-th step (0: first and
    last).

    What is not given is as the scene file says it, else method rk4, dt 0.1 s, precision double and 1000 steps; `until`
    [s] is an end time instead of `steps`. `parameters` are those of the method. Other threads go on meanwhile, and
    Ctrl+C ends it.

    Raises Diverged, with the rows until then as ``error.run``, if the run diverges and `check` is true; UsageError before
    the first step if the rows do not fit memory.

    >>> result = run(Scene.model("chain", n=3), method="pefrl", dt=0.05, steps=100, every=10)
    >>> result.positions.shape, result.energy.shape
    ((11, 3, 3), (11,))
    >>> result.status, float(abs(result.energy_error).max()) < 1e-6
    ('ok', True)
    """
    check = flag_from(check, "check")
    result = Run(
        **_core.run(
            core_of(scene),
            settings_from(method, dt, precision, parameters, threads),
            None if steps is None else count_from(steps, "steps"),
            None if until is None else number_from(until, "until"),
            count_from(every, "every"),
            flag_from(positions, "positions"),
            flag_from(velocities, "velocities"),
        )
    )
    if check and result.status != "ok":
        error = Diverged(result.reason)
        error.run = result
        raise error
    return result


def read(file: str | os.PathLike[str], *, first: int = 0, every: int = 1) -> Trajectory:
    """The rows of a file: of the frames first, first + every, ...

    The file is one that ``steplab run --out`` wrote, or another program as extended XYZ or LAMMPS dump, also compressed.
    Steps are numbered in order where it has none; velocities that it does not have are 0.
    """
    return Trajectory(**_core.read(path_from(file, "file"), count_from(first, "first"), count_from(every, "every", 1)))


class Simulation:
    """A run under way.

    >>> simulation = Simulation(Scene.model("chain", n=3), method="rk4", dt=0.1)
    >>> simulation.advance(5)
    >>> simulation.step, simulation.time, simulation.positions().shape
    (5, 0.5, (3, 3))
    """

    def __init__(
        self,
        scene: Scene,
        *,
        method: str = "",
        dt: float | None = None,
        precision: str = "",
        parameters: Mapping[str, Any] | None = None,
        threads: int = 0,
    ) -> None:
        self._core = _core.Simulation(core_of(scene), settings_from(method, dt, precision, parameters, threads))
        self._lost = False

    def advance(self, steps: int) -> None:
        """Takes this many steps. Raises Diverged where it cannot; the run then stands at its last valid step. An
        interrupted one is lost."""
        self._check()
        try:
            self._core.advance(count_from(steps, "steps"))
        except KeyboardInterrupt:
            self._lost = True
            raise
        if self._core.divergence:
            raise Diverged(self._core.divergence)

    @property
    def step(self) -> int:
        return self._checked().step

    @property
    def time(self) -> float:
        """[s]"""
        return self._checked().time

    @property
    def particles(self) -> int:
        return self._checked().particles

    @property
    def evaluations(self) -> int:
        """Of the forces, so far."""
        return self._checked().evaluations

    @property
    def energy(self) -> float:
        """[J]"""
        return self._checked().energy

    @property
    def energy_error(self) -> float:
        """[J], since the start"""
        return self._checked().energy_error

    @property
    def hash(self) -> str:
        """Of the present state, as ``steplab run`` prints it."""
        return self._checked().hash

    def positions(self, out: Floats | None = None) -> Floats:
        """(n, 3) [m], in `out` if that is given: float64, contiguous, writeable."""
        return self._filled("positions", out)

    def velocities(self, out: Floats | None = None) -> Floats:
        """(n, 3) [m/s], in `out` if that is given."""
        return self._filled("velocities", out)

    def forces(self, out: Floats | None = None) -> Floats:
        """On all particles, drag included, (n, 3) [N], in `out` if that is given."""
        return self._filled("forces", out)

    def snapshot(self, width: int = 640, height: int = 360, camera: str = "") -> Picture:
        """A picture of the present state, drawn without a display: `width` times `height` pixels, 1 to 8192 each.

        `camera` is one of the words "default", "front", "side" and "top", or "yaw,pitch,distance,x,y,z": angles in
        degrees, the distance from the point x, y, z at the centre [m]. Raises GraphicsError where nothing can be drawn.
        """
        side = functools.partial(count_from, least=1, most=8192)
        pixels = self._checked().snapshot(side(width, "width"), side(height, "height"), word_from(camera, "camera"))
        return Picture(pixels)

    def _filled(self, what: str, out: Floats | None) -> Floats:
        core = self._checked()
        array = array_to_fill(out, (core.particles, 3))
        getattr(core, what)(array)
        return array

    def _checked(self) -> _core.Simulation:
        self._check()
        return self._core

    def _check(self) -> None:
        if self._lost:
            raise UsageError("this simulation was interrupted in a step and is lost: begin another one")

    def __reduce__(self) -> Any:
        raise UsageError("a Simulation cannot be pickled: pickle its scene, and positions() and velocities()")


class Picture:
    """Pixels as an array (height, width, 4) of uint8, red green blue alpha, which a notebook shows."""

    def __init__(self, pixels: npt.NDArray[np.uint8]) -> None:
        self.pixels = pixels

    def __array__(self, dtype: Any = None) -> npt.NDArray[Any]:
        return self.pixels if dtype is None else self.pixels.astype(dtype)

    def png(self) -> bytes:
        """As a PNG file."""
        from ._png import encoded

        return encoded(self.pixels)

    def _repr_png_(self) -> bytes:
        return self.png()
