"""Reads the extended XYZ that steplab writes as others do: read_back.py STEPLAB

Every model in both precisions, scenes of one particle and of different masses, through ASE: positions, velocities, momenta, masses, box and
kinetic energy are those of the run. Then by the rules of libAtoms and chemfiles, which are stricter.
"""
import csv
import json
import re
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy
from ase.io import read

steplab = sys.argv[1]
temporary = TemporaryDirectory(prefix="steplab-ase-")
folder = Path(temporary.name)


def run(*words):
    return subprocess.run([steplab, *words], check=True, capture_output=True, text=True).stdout


def written(scene, ending):
    """The frames by ASE, the rows of the CSV and of the series, and the text."""
    rows, series, xyz = folder / "rows.csv", folder / "series.csv", folder / ("rows." + ending)
    steps = ["--dt", "0.01", "--steps", "40", "--every", "20"]
    run("run", *scene, *steps, "--out", str(rows), "--series", str(series))
    run("run", *scene, *steps, "--out", str(xyz))
    tables = [list(csv.DictReader(file.open())) for file in (rows, series)]
    text = run("run", *scene, *steps, "--format", "xyz", "--out", "-")
    return read(str(xyz), index=":", format="extxyz"), *tables, text


def same(what, left, right, tolerance=0.0):
    left, right = numpy.asarray(left, float), numpy.asarray(right, float)
    assert left.shape == right.shape, (what, left.shape, right.shape)
    scale = max(numpy.abs(right).max(), 1e-300)
    assert numpy.abs(left - right).max() <= tolerance * scale, (what, left, right)


def vectors(rows, *names):
    return [[float(row[name]) for name in names] for row in rows]


def check(scene, ending, mass, period, kinetic=1e-13):
    frames, rows, series, text = written(scene, ending)
    assert len(frames) == len(series) == 3, len(frames)
    for atoms, line in zip(frames, series):
        assert atoms.info["Step"] == int(line["step"]) and atoms.info["Time"] == float(line["time"])
        own = [row for row in rows if row["step"] == line["step"]]
        assert set(atoms.get_chemical_symbols()) == {"X"} and len(atoms) == len(own)
        assert set(atoms.arrays["role"]) <= {"moving", "fixed", "kicked", "bullet"}
        same("positions", atoms.get_positions(), vectors(own, "x", "y", "z"))
        same("velo", atoms.arrays["velo"], vectors(own, "vx", "vy", "vz"))
        # ASE divides momenta by masses; in float the columns velo have 9 digits, momenta 17
        same("velocities", atoms.get_velocities(), atoms.arrays["velo"], 1e-7 if "float" in scene else 3e-16)
        same("masses", atoms.get_masses(), numpy.broadcast_to(mass, len(own)))
        # sums of the same squares in another order
        same("kinetic", atoms.get_kinetic_energy(), float(line["kinetic"]), kinetic)
        assert list(atoms.pbc) == [period > 0] * 3
        same("cell", atoms.get_cell()[:], numpy.eye(3) * period)
    check_rules(text)


def check_rules(text):
    """libAtoms and chemfiles: species and pos first, one word for each column, keys of letters, values that need it quoted."""
    lines = text.splitlines()
    while lines:
        count, comment = int(lines[0]), lines[1]
        pairs = dict(re.findall(r'([A-Za-z][A-Za-z0-9_]*)=("[^"]*"|[^\s"]+)(?:\s|$)', comment))
        assert " ".join(f"{key}={value}" for key, value in pairs.items()) == comment, comment
        assert pairs["Properties"].startswith("species:S:1:pos:R:3"), comment
        columns = pairs["Properties"].split(":")
        assert set(columns[1::3]) <= set("SRIL")
        words = sum(map(int, columns[2::3]))
        for line in lines[2 : 2 + count]:
            assert len(line.split()) == words and re.fullmatch(r"[A-Z][a-z]?", line.split()[0]), line
        assert ("Lattice" in pairs) == (pairs["pbc"] == '"T T T"')
        lines = lines[2 + count :]


models = [model["id"] for model in json.loads(run("list", "models", "--json"))["models"]]
scenes = [["--model", model, "--set", "m=1.7"] for model in models]
scenes += [["--model", "free", "--set", "n=1"], ["--model", "morse", "--set", "edge=1"]]
for scene in scenes:
    parameters = json.loads(run("run", *scene, "--steps", "0", "--summary", "-"))["parameters"]
    period = parameters["edge"] * parameters["spacing"] if "crystal" in scene else 0
    for precision in ("float", "double"):
        mass = float(numpy.float32(parameters["m"])) if precision == "float" else parameters["m"]
        ending = "extxyz.gz" if precision == "float" else "xyz"
        check([*scene, "--precision", precision], ending, mass, period)
        print("ok", *scene, precision)

MIXED = """steplab = 1
[[particles]]
group = "wall"
fixed = {fixed}
mass = 9
[[particles]]
group = "row"
position = [1, 0, 0]
line = {{ count = 3, step = [1, 0, 0] }}
velocity = [0.1, 0.2, 0]
mass = 0.3
[[fix]]
particles = "row[1]"
mass = {middle}
[[springs]]
pairs = [["wall", "row[0]"]]
k = 1
[[springs]]
between = "row"
k = 2
"""
for fixed, middle in (("false", 2), ("true", 2), ("true", 0.3)):
    scene = folder / "mixed.toml"
    scene.write_text(MIXED.format(fixed=fixed, middle=middle))
    for precision in ("float", "double"):
        # in float the run's masses are rounded, those of the file are the scene's
        kinetic = 1e-6 if precision == "float" else 1e-13
        check(["--scene", str(scene), "--precision", precision], "xyz", [9, 0.3, middle, 0.3], 0, kinetic)
        print("ok mixed masses", fixed, middle, precision)
