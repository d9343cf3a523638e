#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What softer soil saves in a scene, and what it changes.

Runs a scene by `scarp run` with one thread, as it is and with all Young's moduli multiplied by each of --share: once with the
scene's viscosity_alpha, and once with the viscosity kept (E26 is alpha times the speed of sound, so that alpha grows by one
over the root of the share). The way of a particle is the distance between its places in the first and the last frame; of all
ways the mean and the 99 % quantile are shown, with their change over the scene as it is. Times are CPU seconds, medians of
the turns.

usage: soften.py SCARP SCENE.toml [--share 0.25 0.0625] [--turns 1] [--keep FOLDER]"""
import argparse
import json
import pathlib
import re
import statistics
import sys
import tempfile

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "engine/report"))
import measure  # noqa: E402
import scarp_frames  # noqa: E402


def softened(text, share, alpha):
    """The scene with Young's moduli times the share, and this viscosity_alpha; None leaves it as it is."""
    soft = re.sub(r'^youngs_modulus = "([\d.e+-]+) (\w+)"',
                  lambda found: f'youngs_modulus = "{share * float(found[1]):.10g} {found[2]}"', text, flags=re.M)
    if soft == text and share != 1:
        sys.exit('soften.py: the scene has no line like youngs_modulus = "2 MPa"')
    if alpha is None:
        return soft
    soft = re.sub(r"^viscosity_alpha = .*\n?", "", soft, flags=re.M)
    line = f"viscosity_alpha = {alpha:.10g}\n"
    if re.search(r"^\[numerics\]", soft, flags=re.M):
        return re.sub(r"^\[numerics\].*\n", lambda found: found[0] + line, soft, count=1, flags=re.M)
    return f"{soft}\n[numerics]\n{line}"


def ways(folder):
    """Of all particles, from the first frame to the last [m]."""
    ends = [scarp_frames.load_frame(scarp_frames.read_series(folder)[k][0]) for k in (0, -1)]
    first, last = (frame["position"][np.argsort(frame["fields"]["id"])] for frame in ends)
    return np.linalg.norm(last - first, axis=1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("scene", type=pathlib.Path)
    parser.add_argument("--share", type=float, nargs="+", default=[0.25, 0.0625])
    parser.add_argument("--turns", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path)
    arguments = parser.parse_args()
    text = arguments.scene.read_text()
    with tempfile.TemporaryDirectory() as temporary:
        root = arguments.keep or pathlib.Path(temporary)
        root.mkdir(parents=True, exist_ok=True)

        def run(name, scene_text):
            scene = root / f"{name}.toml"
            scene.write_text(scene_text)
            seconds = measure.run(arguments.program, scene, root / name)
            return seconds, json.loads((root / name / "results.json").read_text()), ways(root / name)

        as_it_is = run("as_it_is", text)
        alpha = as_it_is[1]["numerics"]["viscosity_alpha"]
        runs = [("as it is", alpha, text, [as_it_is])]
        for share in arguments.share:
            for kept in (alpha, alpha / share**0.5):
                runs.append((f"E times {share:g}", kept, softened(text, share, kept), []))
        for turn in range(arguments.turns):
            for k, (_, _, scene_text, done) in enumerate(runs):
                if turn or k:
                    done.append(run(f"run_{k}", scene_text))
    base_seconds = statistics.median(seconds for seconds, _, _ in runs[0][3])
    base = np.array([as_it_is[2].mean(), np.quantile(as_it_is[2], 0.99)])
    print(f"{arguments.scene.name}, {len(as_it_is[2])} particles")
    print("| stiffness | viscosity_alpha | steps | CPU s | over as it is | mean way [m] | 99 % quantile [m] | their changes |")
    print("|---|---|---|---|---|---|---|---|")
    for name, kept, _, done in runs:
        seconds = statistics.median(one for one, _, _ in done)
        _, results, way = done[-1]
        ends = np.array([way.mean(), np.quantile(way, 0.99)])
        change = ends / base - 1
        note = "" if results["complete"] else f" ({results['failure']})"
        print(f"| {name} | {kept:.3g} | {results['steps']}{note} | {seconds:.1f} | {seconds / base_seconds:.2f} | {ends[0]:.5f} | "
              f"{ends[1]:.4f} | {change[0]:+.1%}, {change[1]:+.1%} |", flush=True)


if __name__ == "__main__":
    main()
