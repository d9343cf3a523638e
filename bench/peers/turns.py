# SPDX-License-Identifier: BSD-3-Clause
"""Processor time of programs that take turns, and runs of scarp."""
import json
import os
import re
import statistics
import subprocess
import tempfile


def cpu_seconds_and_output(command, folder=None):
    """User and system time [s] of a command, and what it printed."""
    with tempfile.TemporaryFile("w+") as out:
        child = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT,
                                 env={**os.environ, "OMP_NUM_THREADS": "1"})
        _, status, usage = os.wait4(child.pid, 0)
        code = child.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        said = out.read()
    if code != 0:
        raise RuntimeError(f"{' '.join(command)}: exit code {code}\n{said[-2000:]}")
    return usage.ru_utime + usage.ru_stime, said


def scene_text(name, numerics, **values):
    """A scene of this folder with numerics "PRESET/PRECISION" and the `values` in place of its own."""
    preset, precision = numerics.split("/")
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), name)) as file:
        text = file.read()
    for key, value in values.items():
        text, found = re.subn(f"(?m)^{key} = .*$", f"{key} = {value}", text)
        if found != 1:
            raise RuntimeError(f"{name}: a line '{key} = ...' has to stand there once, and does {found} times")
    if "[numerics]" not in text:
        text += "\n[numerics]"
    text = text.replace("[numerics]", f'[numerics]\nprecision = "{precision}"')
    return f'preset = "{preset}"\n{text}\n'


def run_scarp(program, scene, inspect=None):
    """Runs the text of a scene on one thread. Returns processor time [s], results.json and, of the output folder, what
    `inspect` returns."""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "scene.toml"), "w") as file:
            file.write(scene)
        seconds, _ = cpu_seconds_and_output([program, "run", "scene.toml", "--threads", "1", "-o", "out"], folder)
        out = os.path.join(folder, "out")
        with open(os.path.join(out, "results.json")) as file:
            results = json.load(file)
        return seconds, results, inspect(out) if inspect else None


def in_turns(count, turns, measure):
    """Calls measure(which) `turns` times for each of `count` things, whose order is turned round each time, so that a slow
    drift of the machine favours nobody. Returns for each the list of what it returned."""
    measured = [[] for _ in range(count)]
    for turn in range(turns):
        for which in range(count) if turn % 2 == 0 else reversed(range(count)):
            measured[which].append(measure(which))
    return measured


def median_and_quartiles(values):
    values = sorted(values)
    if len(values) < 2:
        return values[0], values[0], values[0]
    low, middle, high = statistics.quantiles(values, n=4, method="inclusive")
    return middle, low, high


def shown(values, form):
    middle, low, high = median_and_quartiles(values)
    return f"{middle:{form}} ({low:{form}} to {high:{form}})"
