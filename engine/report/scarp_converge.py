# SPDX-License-Identifier: BSD-3-Clause
"""The page of `scarp converge`: advice, estimated error against run time, every quantity."""

import pathlib

from scarp_figures import plt
from scarp_frames import read_json
from scarp_page import Page


def _percent(errors):
    return [None if error is None else 100.0 * error for error in errors]


def _drawn(quantities):
    """Displacements with an error that a logarithmic axis can show."""
    return [q for q in quantities if not q["component"] and q["unit"] == "m"
            and any(error for error in q["errors"])]


def error_figure(study):
    """Estimated error against run time, both logarithmic; None if there is no error to draw."""
    drawn = _drawn(study["quantities"])
    if not drawn:
        return None
    figure, ax = plt.subplots(figsize=(9.0, 4.2))
    times = [run["wall_s"] for run in study["runs"]]
    for q in drawn:
        points = [(t, e) for t, e in zip(times, _percent(q["errors"])) if e]
        words = f"{q['name']} ({q['trend']})" if q["order"] is None else f"{q['name']}, order {q['order']:.2g}"
        ax.plot(*zip(*points), marker="o", linestyle="-" if q["order"] is not None else ":", label=words)
    ax.set_xscale("log")
    ax.set_yscale("log")
    for target in (5, 2):
        ax.axhline(target, color="#999999", linewidth=0.6, linestyle="--")
        ax.annotate(f"{target} %", (1.0, target), xycoords=("axes fraction", "data"), xytext=(-2, 2),
                    textcoords="offset points", ha="right", fontsize=8, color="#666666")
    for run in study["runs"]:
        ax.annotate(f"{run['spacing']:g} m", (run["wall_s"], 0.0), xycoords=("data", "axes fraction"),
                    xytext=(0, 3), textcoords="offset points", ha="center", fontsize=8, color="#666666")
    ax.margins(x=0.1)
    ax.set_xlabel("run time [s]")
    ax.set_ylabel("estimated error [%]")
    ax.grid(alpha=0.25, linewidth=0.5, which="both")
    ax.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), fontsize=8)
    return figure


def converge_page(folder, out=None):
    """Writes the page over the three runs of a folder; returns its path."""
    folder = pathlib.Path(folder)
    study = read_json(folder / "converge.json")
    spacings = [f"{run['spacing']:g} m" for run in study["runs"]]
    page = Page(study["title"] or folder.name, f"scarp converge at {', '.join(spacings)}, preset {study['preset']}")
    for advice in study["advice"]:
        page.text(advice["sentence"])
    for note in study["notes"]:
        page.text(note, problem=True)
    page.section("Error against run time")
    figure = error_figure(study)
    if figure is None:
        page.text("There is no estimated error above 0 to draw.")
    else:
        page.figure(figure, "Estimated error of the displacements against run time, from the coarse to the fine "
                    "spacing; dotted: no order, three times the spread of the values.",
                    folder / "figures" / "error_time.png")
    page.section("Quantities at the end of the last stage")
    page.table(["quantity", "unit"] + spacings + ["order", "at spacing 0"] + [f"error [%] {s}" for s in spacings]
               + ["remark"],
               [[q["name"], q["unit"], *q["values"], q["observed_order"], q["extrapolated"],
                 *_percent(q["errors"]), q["remark"]] for q in study["quantities"]])
    page.section("Runs")
    page.table(["spacing [m]", "particles", "steps", "run time [s]", "mass of the soil", "run before"],
               [[run["spacing"], int(run["particles"]), int(run["steps"]), run["wall_s"], run["mass"],
                 "yes" if run["reused"] else "no"] for run in study["runs"]])
    page.text(f"Computed with {study['isa']} on {study['threads']} threads. Each run has a folder of its own with "
              "all its outputs; scarp report draws it.")
    path = pathlib.Path(out or folder / "report.html")
    page.save(path)
    return path
