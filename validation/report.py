#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws what scarp-validate left in a folder: `report.py DIR` makes DIR/report.html and its figures. DIR is the folder
of a case, of several (cases.json names them), or of error against run time, or of the stability map."""

import importlib.util
import pathlib
import signal
import sys

if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # ends like any program, without a traceback
_here = pathlib.Path(__file__).resolve().parent
for _place in (_here.parent / "engine" / "report", _here.parent / "report",  # in the sources, or installed
               _here / "error_time", _here / "stability"):
    if _place.exists():
        sys.path.insert(0, str(_place))
import scarp_report as scarp  # noqa: E402
import claims_table  # noqa: E402
import error_time_page  # noqa: E402
import numpy as np  # noqa: E402
import overview  # noqa: E402
import stability_page  # noqa: E402

plt = scarp.plt


def case_figures(name):
    """`draw(page, folder, figures)` of validation/cases/<name>/figures.py, or None."""
    path = pathlib.Path(__file__).resolve().parent / "cases" / name / "figures.py"
    if not path.exists():
        return None
    spec = importlib.util.spec_from_file_location(f"figures_{name}", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.draw


def convergence_figure(page, results, figures):
    """Error against spacing, one line for each series, with slopes of first and second order."""
    series = [one for one in results.get("convergence", []) if len(one["spacing"]) > 1]
    if not series:
        return
    figure, ax = plt.subplots(figsize=(6.6, 3.6))
    for one in series:
        order = one.get("order")
        ax.loglog(one["spacing"], np.abs(np.array(one["error"], dtype=float)), "o-",
                  label=one["quantity"] + (f" (order {order:.2f})" if order is not None else ""))
    coarse = max(max(one["spacing"]) for one in series)
    fine = min(min(one["spacing"]) for one in series)
    top = max(np.nanmax(np.abs(np.array(one["error"], dtype=float))) for one in series)
    for slope, style in ((1, ":"), (2, "--")):
        ax.loglog([fine, coarse], [top * (fine / coarse) ** slope, top], style, color="#999999", linewidth=0.8,
                  label=f"order {slope}")
    ax.set_xlabel("particle spacing dx [m]")
    ax.set_ylabel("|error| [-]")
    ax.grid(alpha=0.25, linewidth=0.5, which="both")
    ax.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), fontsize=8)
    page.figure(figure, "Error against spacing.", figures / "convergence.png")


def cost_section(page, results):
    """Time to solution of each run, its stages together."""
    runs = {}
    for part in results.get("runs", []):
        total = runs.setdefault(part["name"], dict.fromkeys(part, 0.0))
        for key in part.keys() - {"name", "memory_bytes"}:
            total[key] += part[key]
        total["memory_bytes"] = max(total.get("memory_bytes", 0.0), part.get("memory_bytes", 0.0))
    rows = []
    for name, run in runs.items():
        particle_steps = run.get("particle_steps", 0.0)  # missing in results of earlier versions
        rows.append([name, round(particle_steps / max(run["steps"], 1)), int(run["steps"]), run["simulated_s"],
                     run["wall_s"], run.get("cpu_s") or None,  # trials of a search have no own
                     1e-6 * particle_steps / max(run["wall_s"], 1e-9), run["memory_bytes"] / 2**20 or None])
    rows.append(["whole case", None, results.get("steps"), None, results.get("wall_s"), None, None, None])
    page.table(["run", "particles", "steps", "simulated [s]", "time to solution [s]", "processor time [s]",
                "M particle-steps/s", "memory [MiB]"],
               [["" if value is None else value for value in row] for row in rows])


def report(folder):
    folder = pathlib.Path(folder)
    results = scarp.read_results(folder)
    source = folder / "results.json"
    figures = folder / "figures"
    page = scarp.Page(results.get("title") or results.get("case") or folder.name,
                      f"scarp validation, case {results.get('case', folder.name)}, {results.get('form', '')} form"
                      + (f", preset {results['preset']}" if "preset" in results else ""))  # of several: no one preset
    page.text(scarp.badge(scarp.verdict_of(results)))
    page.part(source, scarp.verdict_section, page, results)
    if results.get("claims"):
        page.section("What the paper says of it")
        page.part(source, claims_table.draw, page, results["claims"])
    draw = case_figures(results.get("case", folder.name))
    if draw:
        page.part(folder, draw, page, folder, figures)
    page.part(source, convergence_figure, page, results, figures)
    page.section("Cost")
    page.part(source, cost_section, page, results)
    page.section("Run")
    page.part(source, scarp.facts_section, page, results)
    page.section("Particles")
    page.part(folder / "frames", scarp.particle_figures, page, folder, figures)
    page.section("Histories")
    scarp.history_figures(page, folder, figures)
    page.section("Machine, versions, numerics")
    page.part(source, scarp.machine_section, page, results)
    if page.images:  # the first one stands for the case on the page over all
        figures.mkdir(exist_ok=True)
        (figures / "main.png").write_bytes(page.images[0])
    path = folder / "report.html"
    page.save(path)
    return path


def main(folder):
    if (folder / "error_time.json").exists():
        error_time_page.error_time_page(folder)
    elif (folder / "stability.json").exists():
        stability_page.stability_page(folder)
    elif (folder / "results.json").exists():
        report(folder)
    else:
        overview.overview(folder)


if __name__ == "__main__":
    scarp.Progress.quiet = "--quiet" in sys.argv
    words = [word for word in sys.argv[1:] if word != "--quiet"]
    if len(words) != 1 or not pathlib.Path(words[0]).is_dir():
        sys.exit("usage: report.py [--quiet] DIR (the folder of a case, of several, or of error_time)")
    scarp.in_words(lambda: main(pathlib.Path(words[0])), words[0])
