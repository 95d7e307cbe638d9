"""steplab: a laboratory for numerical integrators of point masses.

>>> import steplab
>>> chain = steplab.Scene.model("chain", n=10)
>>> result = steplab.run(chain, method="pefrl", dt=0.1, until=20, every=1)
>>> result.positions.shape
(201, 10, 3)

Units are the scene's own and consistent: m, kg, s, N, J, if you like. y is up. Errors are exceptions of the family
``steplab.Error``.
"""

from ._core import methods, models, scenes, version as __version__
from ._errors import Diverged, Error, FileError, GraphicsError, UsageError
from .lab import Advice, Comparison, Limit, Measurement, advise, compare, limits, order, report
from .runs import Picture, Run, Simulation, Trajectory, read, run
from .scene import Scene

__all__ = [
    "Advice",
    "Comparison",
    "Diverged",
    "Error",
    "FileError",
    "GraphicsError",
    "Limit",
    "Measurement",
    "Picture",
    "Run",
    "Scene",
    "Simulation",
    "Trajectory",
    "UsageError",
    "advise",
    "compare",
    "limits",
    "methods",
    "models",
    "order",
    "read",
    "report",
    "run",
    "scenes",
]
