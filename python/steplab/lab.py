"""What the lab measures of methods on a scene, as data."""

from __future__ import annotations

import dataclasses
from typing import Any, Iterable, Mapping

from . import _core
from ._arrays import count_from, flag_from, items_from, mapping_from, number_from, values_from, word_from, words_from
from ._errors import UsageError
from .runs import Counts, Floats, settings_from
from .scene import Scene, core_of


@dataclasses.dataclass(frozen=True)
class Limit:
    """The largest stable dt of a method on a scene [s]; 0: unstable at any dt, inf: stable at any dt."""

    method: str
    precision: str
    omega_max: float  #: largest angular frequency of the scene at its start [rad/s]
    theory: float | None  #: by linear theory; None: not known, and the note says why
    measured: float | None  #: on runs; None: not measured, and the note says why
    note: str


@dataclasses.dataclass(frozen=True, eq=False)
class Comparison:
    """The errors of a run beside the motion of its scene, at `times`; nan where one is not known."""

    method: str
    precision: str
    dt: float
    times: Floats  #: (s,) [s]; ends where the run diverged
    error: Floats  #: (s,) largest distance of a particle from the reference [m]
    rms_error: Floats  #: (s,) root of the mean squared distance [m]
    energy_error: Floats  #: (s,) [J]
    momentum_error: Floats  #: (s,) [kg m/s]
    reference_error: Floats  #: (s,) estimated [m]
    evaluations: Counts  #: (s,) of the forces, so far
    reference: str  #: in words
    reason: str  #: empty unless the run diverged

    def __repr__(self) -> str:
        return f"<steplab.Comparison {self.method}, dt {self.dt:g}: error {self.error[-1]:.3g} at t = {self.times[-1]:g}>"


@dataclasses.dataclass(frozen=True)
class Measurement:
    """One run over a time, its errors and its cost."""

    method: str
    precision: str
    dt: float  #: [s]
    parameters: dict[str, Any]  #: of the method
    steps: int
    evaluations: int
    error: float  #: largest distance of a particle from the reference at the end [m]; nan if it diverged
    energy_error: float  #: largest on the way [J]
    wall_seconds: float | None  #: of the stepping; None if it was not timed
    status: str
    hash: str


@dataclasses.dataclass(frozen=True)
class Advice:
    """The fastest run that keeps an error, and the best run of every other method that does."""

    best: Measurement
    others: list[Measurement]  #: fastest first
    command: str  #: options of ``steplab run`` that repeat the best run
    reference: str  #: in words


def limits(scene: Scene, methods: str | Iterable[str] | None = None, precision: str = "double") -> list[Limit]:
    """The stability limits of these methods, or of all, by theory and measured.

    >>> limit, = limits(Scene.model("oscillator"), "verlet")
    >>> round(limit.theory, 4), round(limit.measured, 3)
    (2.0, 2.0)
    """
    found = _core.limits(core_of(scene), words_from(methods, "methods"), word_from(precision, "precision"))
    return [Limit(**each) for each in found]


def compare(
    scene: Scene, runs: Iterable[Mapping[str, Any]], *, until: float, samples: int = 100
) -> list[Comparison]:
    """One to four runs of a scene beside its motion as accurately as it can be known. Each is given as what ``run()``
    takes: method, dt, precision, parameters, threads. `samples` is from 1 to 1e12.

    >>> verlet, rk4 = compare(
    ...     Scene.model("oscillator"), [dict(method="verlet", dt=0.05), dict(method="rk4", dt=0.2)], until=10)
    >>> bool(rk4.error.max() < verlet.error.max()), int(rk4.evaluations[-1]), int(verlet.evaluations[-1])
    (True, 200, 200)
    """
    scene_core = core_of(scene)
    given = items_from(runs, "runs", f"a list of dicts, such as [{_A_RUN}]")
    settings = [_settings_of(each, f"runs[{i}]") for i, each in enumerate(given)]
    found = _core.compare(
        scene_core, settings, number_from(until, "until"), count_from(samples, "samples", 1, 10**12)
    )
    return [Comparison(**each) for each in found]


def report(
    scene: Scene,
    *,
    until: float,
    methods: str | Iterable[str] | None = None,
    precisions: str | Iterable[str] | None = None,
    quick: bool = True,
) -> list[Measurement]:
    """Every method and precision over a series of decreasing dt, or tolerances: what ``steplab report`` measures."""
    found = _core.report(
        core_of(scene),
        number_from(until, "until"),
        words_from(methods, "methods"),
        words_from(precisions, "precisions"),
        flag_from(quick, "quick"),
    )
    return [_measurement(each) for each in found]


def advise(
    scene: Scene,
    *,
    error: float,
    until: float,
    methods: str | Iterable[str] | None = None,
    precisions: str | Iterable[str] | None = None,
    quick: bool = True,
) -> Advice:
    """Finds the fastest method, precision and dt with at most this error of a position [m] at the time `until` [s].

    >>> advice = advise(Scene.model("oscillator"), error=1e-6, until=10, methods=["rk4", "verlet"])
    >>> advice.best.error <= 1e-6
    True
    """
    found = _core.advise(
        core_of(scene),
        number_from(error, "error"),
        number_from(until, "until"),
        words_from(methods, "methods"),
        words_from(precisions, "precisions"),
        flag_from(quick, "quick"),
    )
    found["best"] = _measurement(found["best"])
    found["others"] = [_measurement(each) for each in found["others"]]
    return Advice(**found)


def order(scene: Scene, method: str, *, until: float) -> float | None:
    """The order of a method as its errors at the time `until` show it; None where they are all below rounding.

    >>> round(order(Scene.model("chain"), "rk4", until=5), 1)
    4.0
    """
    return _core.order(core_of(scene), word_from(method, "method"), number_from(until, "until"))


_A_RUN = 'dict(method="rk4", dt=0.1)'


def _settings_of(run: Any, name: str) -> dict[str, Any]:
    """Of an entry of `runs`."""
    given = mapping_from(run, name, f"a dict, such as {_A_RUN}")
    known = ("method", "dt", "precision", "parameters", "threads")
    for key in given:
        if key not in known:
            raise UsageError(f"{name} has no '{key}'; known are {', '.join(known)}")
    return settings_from(**given, where=f"{name}: ")


def _measurement(found: dict[str, Any]) -> Measurement:
    found["parameters"] = values_from(found["parameters"])
    return Measurement(**found)
