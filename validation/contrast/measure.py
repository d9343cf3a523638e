#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a stiff part beside soft soil costs, and what each way to make it cheaper does to the result.

Runs a scene of this folder with the material `stiff` as it is, without contrast, with less stiffness, and with
`mass_scaling`, by `scarp run` with one thread. Errors are those against the run with the stiff part as it is: of the
way that the probe has gone, over it, and of the stress of all particles, rms over rms. Times are CPU seconds, medians
of the turns.

usage: measure.py SCARP SCENE.toml [--contrast 1e4] [--turns 1] [--reduced 100 1000] [--scaled 1e2 1e4] [--keep FOLDER]
Prints a table. The contrast is that of Young's moduli, stiff over soft."""
import argparse
import csv
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "engine/report"))
import scarp_frames  # noqa: E402


def soft_modulus(text):
    """Of the material `soft`, as it is written: number and unit."""
    found = re.search(r'name = "soft".*?youngs_modulus = "([\d.]+) (\w+)"', text, re.S)
    return float(found[1]), found[2]


def variant(text, contrast, scaling):
    """The scene with this contrast and mass scaling of the material `stiff`."""
    value, unit = soft_modulus(text)
    head, tail = text.split('name = "stiff"')
    tail = re.sub(r'youngs_modulus = .*', f'youngs_modulus = "{value * contrast:.10g} {unit}"', tail, count=1)
    extra = f"\nmass_scaling = {scaling:g}" if scaling != 1 else ""
    return f'{head}name = "stiff"{extra}{tail}'


def run(program, scene, folder):
    """CPU seconds of one run."""
    before = os.times()
    done = subprocess.run([program, "run", str(scene), "--threads", "1", "--quiet", "--overwrite", "-o", str(folder)],
                          capture_output=True, text=True, check=False)
    after = os.times()
    if done.returncode:
        sys.exit(f"{scene}: exit code {done.returncode}\n{done.stderr}")
    return after.children_user - before.children_user + after.children_system - before.children_system


def result(folder):
    """Steps, way of the probe over all stages [m], stress of all particles in the order of their ids."""
    steps = json.loads((folder / "results.json").read_text())["steps"]
    with open(folder / "probes.csv", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    columns = [next(k for k, title in enumerate(rows[0]) if title.startswith(f"top.position_{name}")) for name in ("x", "y")]
    start, end = ([float(row[k]) for k in columns] for row in (rows[1], rows[-1]))
    frame = scarp_frames.load_frame(scarp_frames.read_series(folder)[-1][0])
    order = np.argsort(frame["fields"]["id"])
    return steps, np.subtract(end, start), frame["fields"]["stress"][order]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("scene", type=pathlib.Path)
    parser.add_argument("--contrast", type=float, default=1e4)
    parser.add_argument("--turns", type=int, default=1)
    parser.add_argument("--reduced", type=float, nargs="*", default=[100.0, 1000.0])
    parser.add_argument("--scaled", type=float, nargs="*", default=[1e2, 1e3, 1e4])
    parser.add_argument("--keep", type=pathlib.Path)
    arguments = parser.parse_args()
    text = arguments.scene.read_text()
    rows = [("as it is", arguments.contrast, 1.0), ("soft everywhere", 1.0, 1.0)]
    rows += [(f"contrast {reduced:g}", reduced, 1.0) for reduced in arguments.reduced]
    rows += [(f"mass_scaling {scaling:g}", arguments.contrast, scaling) for scaling in arguments.scaled]
    with tempfile.TemporaryDirectory() as temporary:
        root = arguments.keep or pathlib.Path(temporary)
        times = {name: [] for name, _, _ in rows}
        for _ in range(arguments.turns):
            for name, contrast, scaling in rows:
                scene = root / (name.replace(" ", "_") + ".toml")
                root.mkdir(parents=True, exist_ok=True)
                scene.write_text(variant(text, contrast, scaling))
                times[name].append(run(arguments.program, scene, scene.with_suffix("")))
        results = {name: result(root / name.replace(" ", "_")) for name, _, _ in rows}
    truth = results["as it is"]
    soft = statistics.median(times["soft everywhere"])
    print(f"{arguments.scene.name}, contrast {arguments.contrast:g}")
    print("| stiff part | steps | CPU s | over soft everywhere | way of the probe [m] | its error | stress, rms error |")
    print("|---|---|---|---|---|---|---|")
    for name, _, _ in rows:
        steps, way, stress = results[name]
        seconds = statistics.median(times[name])
        off = np.linalg.norm(way - truth[1]) / np.linalg.norm(truth[1])
        rms = np.linalg.norm(stress - truth[2]) / np.linalg.norm(truth[2])
        print(f"| {name} | {steps} | {seconds:.2f} | {seconds / soft:.2f} | {np.linalg.norm(way):.5f} | {off:.2%} | "
              f"{rms:.2%} |", flush=True)


if __name__ == "__main__":
    main()
