#!/usr/bin/env python3
"""Time of a step and memory of steplab and LAMMPS on the same exported scenes, in turns.

    scaling.py STEPLAB [--rounds N] [--scenes mesh-10000,network-100000,...] [--workers 1,2]

STEPLAB is the program to measure. Each round measures every program once, so that whatever slows the machine for a
while hits all of them; the least of all rounds is printed, as CSV: wall is the time of a step, cpu the time that all
threads or ranks together were at work for one. Ranks of MPI that wait are at work.
"""
import argparse
import json
import math
import os
import random
import re
import subprocess
import tempfile
import threading

# Particles times steps of a run: about a second.
WORK = 2e7


def random_points(count):
    source = random.Random(2008)
    side = count ** (1 / 3)
    return [[side * source.random() for _ in range(3)] for _ in range(count)]


def nearest_six(points):
    """Springs from each point to its six nearest, each once."""
    cells = {}
    for index, point in enumerate(points):
        cells.setdefault(tuple(int(x) for x in point), []).append(index)
    springs = set()
    for index, point in enumerate(points):
        x, y, z = (int(c) for c in point)
        near = [j for a in (-1, 0, 1) for b in (-1, 0, 1) for c in (-1, 0, 1)
                for j in cells.get((x + a, y + b, z + c), []) if j != index]
        near.sort(key=lambda j: math.dist(points[j], point))
        springs.update((min(index, j), max(index, j)) for j in near[:6])
    return sorted(springs)


def network(folder, count):
    points, velocities = random_points(count), random.Random(2009)
    with open(f"{folder}/start.xyz", "w") as out:
        out.write(f"{count}\nProperties=species:S:1:pos:R:3:velo:R:3\n")
        for point in points:
            moving = [velocities.gauss(0, 0.1) for _ in range(3)]
            out.write("X " + " ".join(f"{x:.9f}" for x in point + moving) + "\n")
    with open(f"{folder}/scene.toml", "w") as out:
        out.write('steplab = 1\n[[particles]]\nfile = "start.xyz"\n[[springs]]\nk = 1\npairs = [\n')
        out.writelines(f"[{i}, {j}],\n" for i, j in nearest_six(points))
        out.write("]\n")
    return ["--scene", f"{folder}/scene.toml", "--dt", "0.05"]


def liquid(folder, count):
    cells = round((count / 4) ** (1 / 3))
    side = cells * 1.679595
    with open(f"{folder}/scene.toml", "w") as out:
        out.write(f'steplab = 1\n[[particles]]\nlattice = {{ kind = "fcc", cells = [{cells}, {cells}, {cells}], '
                  f'constant = 1.679595 }}\ntemperature = {{ kT = 1.44, seed = 2008 }}\n[box]\nsize = '
                  f'[{side!r}, {side!r}, {side!r}]\n[[pairs]]\npotential = "lennard-jones"\nepsilon = 1\nsigma = 1\n'
                  "cutoff = 2.5\n")
    return ["--scene", f"{folder}/scene.toml", "--dt", "0.004"]


def mesh(_, count):
    return ["--model", "mesh", "--set", f"dim={round(count ** 0.5)}", "--dt", "0.1"]


def ended(process):
    """The CPU time of a program that ends, with the programs it started, and its peak memory in MB."""
    _, status, used = os.wait4(process.pid, 0)
    if status != 0:
        raise RuntimeError(f"{process.args} failed")
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1e3


def run_steplab(program, scene, workers, steps):
    command = [program, "run", *scene, "--method", "velocity-verlet", "--precision", "double", "--threads", str(workers),
               "--steps", str(steps), "--summary", "-"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as process:
        summary = json.loads(process.stdout.read())
        cpu, memory = ended(process)
    return summary["wall_seconds"], cpu, memory


def peak_of_ranks(folder, done, peaks):
    """The peak memory of each rank of LAMMPS in this folder, watched until it ends."""
    while not done.wait(0.02):
        for name in filter(str.isdigit, os.listdir("/proc")):
            try:
                if os.readlink(f"/proc/{name}/cwd") != folder or os.path.basename(os.readlink(f"/proc/{name}/exe")) != "lmp":
                    continue
                with open(f"/proc/{name}/status") as status:
                    peaks[name] = int(re.search(r"VmHWM:\s+(\d+)", status.read()).group(1)) / 1e3
            except (OSError, AttributeError):
                continue


def run_lammps(folder, workers, steps):
    done, peaks = threading.Event(), {}
    watch = threading.Thread(target=peak_of_ranks, args=(os.path.realpath(folder), done, peaks))
    watch.start()
    try:
        with subprocess.Popen(["sh", f"{folder}/run.sh", str(workers), "-var", "steps", str(steps)],
                              stdout=subprocess.PIPE, text=True) as process:
            text = process.stdout.read()
            cpu, _ = ended(process)
    finally:
        done.set()
        watch.join()
    return float(re.search(r"Loop time of (\S+)", text).group(1)), cpu, sum(peaks.values())


def measured(run, steps):
    """Wall and CPU time of a step, and memory."""
    _, before, _ = run(1)
    wall, cpu, memory = run(steps + 1)
    return wall / (steps + 1), max(cpu - before, 0) / steps, memory


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("program")
    options.add_argument("--rounds", type=int, default=3)
    options.add_argument("--scenes", default="mesh-10000,mesh-100000,mesh-1000000,network-100000,liquid-32000")
    options.add_argument("--workers", default="1,2")
    given = options.parse_args()
    print("scene,program,workers,wall_ns_per_particle,cpu_ns_per_particle,memory_MB,load")
    for name in given.scenes.split(","):
        kind, count = name.rsplit("-", 1)
        with tempfile.TemporaryDirectory() as folder:
            scene = {"mesh": mesh, "network": network, "liquid": liquid}[kind](folder, int(count))
            subprocess.run([given.program, "export", *scene, "--steps", "1000000000", "--to", "lammps", "--out",
                            f"{folder}/lammps"], check=True, stdout=subprocess.DEVNULL)
            steps = max(3, round(WORK / int(count)))
            least = {}
            for _ in range(given.rounds):
                for workers in map(int, given.workers.split(",")):
                    for who, run in (("steplab", lambda n: run_steplab(given.program, scene, workers, n)),
                                     ("LAMMPS", lambda n: run_lammps(f"{folder}/lammps", workers, n))):
                        now = measured(run, steps)
                        least[who, workers] = [min(pair) for pair in zip(now, least.get((who, workers), now))]
            for (who, workers), (wall, cpu, memory) in sorted(least.items()):
                per = 1e9 / int(count)
                print(f"{name},{who},{workers},{wall * per:.2f},{cpu * per:.2f},{memory:.0f},{os.getloadavg()[0]:.1f}",
                      flush=True)


if __name__ == "__main__":
    main()
