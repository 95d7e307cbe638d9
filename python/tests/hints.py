"""Type hints of the module: they agree with themselves, with what the compiled part offers, and reach who uses it."""

import pathlib
import re
import subprocess
import sys
import tempfile

import steplab

PACKAGE = pathlib.Path(steplab.__file__).parent
# What pybind11 gives to every class; who makes a Scene calls its functions.
OF_PYBIND11 = ["steplab._core.Scene", "steplab._core.Scene.__init__", "steplab._core.Simulation"]

# A program of a user. Lines that end in "# wrong" are, and no others.
PROGRAM = """
import numpy as np
import numpy.typing as npt
import steplab

scene: steplab.Scene = steplab.Scene.model("chain", n=10)
run = steplab.run(scene, steps=10, every=1)
positions: npt.NDArray[np.float64] | None = run.positions
limits: list[steplab.Limit] = steplab.limits(scene)
steplab.run(scene, stepz=10)  # wrong
steplab.advise(7)  # wrong
scene.particles + "x"  # wrong
"""


def checked(module: str, *arguments: str) -> tuple[str, bool]:
    """What mypy or its stubtest says, and whether it finds nothing."""
    done = subprocess.run([sys.executable, "-m", module, *arguments], capture_output=True, text=True)
    return done.stdout + done.stderr, done.returncode == 0


def problems(folder: pathlib.Path):
    strictly = ("--strict", "--cache-dir", str(folder / "cache"))
    said, good = checked("mypy", *strictly, str(PACKAGE))
    if not good:
        yield said

    known = folder / "known.txt"
    known.write_text("\n".join(OF_PYBIND11) + "\n")
    said, good = checked("mypy.stubtest", "steplab._core", "--allowlist", str(known))
    if not good:
        yield said

    program = folder / "program.py"
    program.write_text(PROGRAM)
    said, _ = checked("mypy", *strictly, str(program))
    refused = {int(line) for line in re.findall(r"program\.py:(\d+): error", said)}
    wrong = {number for number, line in enumerate(PROGRAM.split("\n"), 1) if line.endswith("# wrong")}
    if refused != wrong:
        yield said


with tempfile.TemporaryDirectory() as temporary:
    found = list(problems(pathlib.Path(temporary)))
print("\n".join(found) or "hints agree")
sys.exit(bool(found))
