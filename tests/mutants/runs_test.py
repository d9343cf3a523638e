# SPDX-License-Identifier: BSD-3-Clause
"""Mutants that `scarp check` accepts, through `scarp run` for a few hundred steps: the exit code is one of those
documented, a complaint is one line that names the scene or the step, and no table or JSON file has a number that is
none.

Usage: runs_test.py MUTANTS SCARP FOLDER_OF_SCENES COUNT"""

import concurrent.futures
import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

STEPS = 200
DONE, REFUSED, UNSTABLE, LOST_SOIL = 0, 1, 3, 4


def shortened(text):
    """The scene with each stage about as long as some steps of the trial."""
    step = float(re.match(r"# time_step (\S+)\n", text)[1])
    count = max(1, len(re.findall(r"^\[\[stage\]\]", text, re.M)))
    duration = f"duration = {max(STEPS * step / count, 1e-300)!r}"
    head, *stages = re.split(r"^(?=\[\[stage\]\])", text, flags=re.M)
    for k, stage in enumerate(stages):
        own, *rest = re.split(r"^(?=\[(?!\[?stage))", stage, maxsplit=1, flags=re.M)
        own = re.sub(r"^\s*duration\s*=.*$", "", own, flags=re.M).rstrip("\n")
        stages[k] = own + "\n" + duration + "\n" + "".join(rest)
    return head + "".join(stages)


def number_faults(value, path=""):
    """Paths of numbers in JSON that are none."""
    if isinstance(value, dict):
        return [f for key, part in value.items() for f in number_faults(part, f"{path}/{key}")]
    if isinstance(value, list):
        return [f for key, part in enumerate(value) for f in number_faults(part, f"{path}/{key}")]
    return [path] if isinstance(value, float) and not math.isfinite(value) else []


def table_faults(path):
    with path.open(newline="", encoding="utf-8") as stream:
        header, *rows = list(csv.reader(stream))
    faults = [f"{path.name}: a row of {len(row)} cells" for row in rows if len(row) != len(header)]
    for row in rows:
        faults += [f"{path.name}: {title} = {cell}" for title, cell in zip(header, row)
                   if re.fullmatch(r"-?(nan|inf)(inity)?", cell, re.I)]
    return faults


def faults_of(scene, scarp, out):
    """What is wrong with a run of the scene; and its exit code."""
    try:
        done = subprocess.run([scarp, "run", scene, "-o", out, "--threads", "1", "--quiet", "--json", "-"],
                              capture_output=True, timeout=300)
    except subprocess.TimeoutExpired:
        return ["does not end"], None
    faults, errors = [], done.stderr.decode("utf-8", "strict")
    complaints = [line for line in errors.splitlines() if not line.startswith("warning: ")]
    if done.returncode not in (DONE, REFUSED, UNSTABLE, LOST_SOIL):
        faults.append(f"exit code {done.returncode}")
    if done.returncode == REFUSED and not (len(complaints) == 1 and re.match(
            re.escape(f"scarp: {scene}:") + r"\d+: key '.*' = .*: .+", complaints[0])):
        faults.append(f"a complaint that names no key: {errors}")
    if done.returncode == UNSTABLE and not re.search(r"step \d+.*(Try|try)", errors, re.S):
        faults.append(f"instability that names no step: {errors}")
    if re.search(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]", errors):
        faults.append("control characters")
    results = out / "results.json"
    if done.returncode in (DONE, UNSTABLE, LOST_SOIL) and not results.exists():
        faults.append("no results.json")
    for path in out.rglob("*.json"):
        faults += number_faults(json.loads(path.read_text("utf-8")), path.name)
    for path in out.rglob("*.csv"):
        faults += table_faults(path)
    if done.returncode == DONE and not json.loads(done.stdout):
        faults.append("prints no results")
    return faults, done.returncode


def main(mutants, scarp, seeds, count):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([mutants, "write", seeds, folder, "1000000", count], check=True)
        scenes = sorted(folder.glob("mutant_*.toml"))
        for scene in scenes:
            scene.write_text(shortened(scene.read_text("utf-8")), "utf-8")
        codes, failed = {}, 0
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            runs = pool.map(lambda scene: faults_of(scene, scarp, folder / scene.stem), scenes)
            for scene, (faults, code) in zip(scenes, runs):
                codes[code] = codes.get(code, 0) + 1
                failed += bool(faults)
                if faults:
                    print(f"{scene.name}: {'; '.join(faults)}\n{scene.read_text('utf-8')}\n")
        print(f"{len(scenes)} runs, exit codes {codes}, {failed} with faults")
        return 1 if failed or len(scenes) != int(count) else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
