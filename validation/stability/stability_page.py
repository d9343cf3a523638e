# SPDX-License-Identifier: BSD-3-Clause
"""Map and page of what `scarp-validate stability` left."""

import json
import pathlib

import scarp_report as scarp

plt = scarp.plt
COLOUR = {"holds": "#2f9e6e", "restless": "#a3c644",
          "marginal": "#e6a700", "stopped": "#5f7fbf", "refused": "#b0b0b0", "failed": "#c8321e"}
WORDS = {"holds": "runs, and is stable at the CFL number in use",
         "restless": "runs, but what should stand still moves at the end",
         "marginal": "runs, but a shaken copy is unstable at the CFL number in use",
         "stopped": "stopped by the watch, with its report",
         "refused": "an error before the first step",
         "failed": "grains lost or numbers not finite without a report"}
GROUPS = ("stiffness", "strength", "loading", "shape", "scale", "noise", "3D")


def _setting(cell):
    return cell["preset"] + (", mixed" if cell["precision"] == "mixed" else "")


def _rounded(value):
    return "" if value is None else float(f"{value:.3g}")


def _mark(cell):
    """Margin over the CFL number in use where one was looked for, or the noise."""
    if cell["group"] == "noise" and cell["verdict"] == "holds":
        return f"noise {_rounded(cell['noise'])}, {_rounded(cell['shear_noise'])}"
    if cell["stable_cfl"] is None:
        return ""
    more = ">" if cell["unstable_cfl"] is None else ""
    return f"{more}{cell['stable_cfl'] / cell['cfl']:.2g}"


def map_figure(cells):
    """One row an axis and value, one column a preset."""
    settings = [s for s in ("modern", "paper", "modern, mixed") if any(_setting(c) == s for c in cells)]
    rows = list(dict.fromkeys((c["group"], c["axis"], c["value"]) for c in cells))
    rows.sort(key=lambda row: GROUPS.index(row[0]))
    at = {((c["group"], c["axis"], c["value"]), _setting(c)): c for c in cells}
    figure, ax = plt.subplots(figsize=(7.6, 1.0 + 0.235 * len(rows)))
    for y, row in enumerate(rows):
        for x, setting in enumerate(settings):
            cell = at.get((row, setting))
            if cell is None:
                continue
            ax.add_patch(plt.Rectangle((x + 0.02, y + 0.06), 0.96, 0.88, color=COLOUR[cell["verdict"]], linewidth=0))
            ax.text(x + 0.5, y + 0.5, _mark(cell) or cell["verdict"], ha="center", va="center", fontsize=7,
                    color="white" if cell["verdict"] in ("holds", "stopped", "failed") else "black")
        if y == 0 or rows[y - 1][0] != row[0]:
            ax.axhline(y, color="#333333", linewidth=0.9)
            ax.text(len(settings) + 0.06, y + 0.5, row[0], fontsize=8, fontweight="bold", va="center")
    ax.set_yticks([y + 0.5 for y in range(len(rows))], [f"{axis}: {value}" for _, axis, value in rows], fontsize=7.5)
    ax.set_xticks([x + 0.5 for x in range(len(settings))], settings)
    ax.xaxis.tick_top()
    ax.set_xlim(0, len(settings))
    ax.set_ylim(len(rows), 0)
    ax.tick_params(length=0)
    for spine in ax.spines.values():
        spine.set_visible(False)
    used = [v for v in COLOUR if any(c["verdict"] == v for c in cells)]
    ax.legend(handles=[plt.Rectangle((0, 0), 1, 1, color=COLOUR[v], label=v) for v in used], loc="upper left",
              bbox_to_anchor=(0.0, -0.005), ncols=len(used), fontsize=8, frameon=False)
    return figure


def stability_page(folder):
    """Writes DIR/report.html and DIR/map.png; returns the page's path."""
    folder = pathlib.Path(folder)
    study = json.loads((folder / "stability.json").read_text(encoding="utf-8"))
    cells = study["cells"]
    page = scarp.Page("Where scarp is stable", "One factor at a time, pushed to its extremes.")
    page.text(scarp.badge(study["pass"], "every cell has its verdict, none is lost without a report"
                          if study["pass"] else "cells failed without a report"))
    for sentence in study["sentences"]:
        page.text(sentence)
    page.section("The map")
    page.text("Numbers: the largest stable CFL number over the one in use, where it was looked for; > where nothing "
              "tried was unstable. " + " ".join(f"{v}: {words}." for v, words in WORDS.items()))
    page.figure(map_figure(cells), "Verdict of each cell, and its margin.", folder / "map.png")
    page.section("Every cell")
    page.table(["axis", "value", "preset", "verdict", "CFL in use", "stable to", "unstable from", "set by",
                "energy gain", "density, least", "density, most", "beyond yield", "lost", "noise", "of the shear",
                "speed at the end [m/s]",
                "particles", "steps", "run time [s]"],
               [[c["axis"], c["value"], _setting(c), c["verdict"], c["cfl"], _rounded(c["stable_cfl"]),
                 _rounded(c["unstable_cfl"]), c["limit"], _rounded(c["energy_gain"]), _rounded(c["density_low"]),
                 _rounded(c["density_high"]), _rounded(c["yield_overshoot"]), c["lost"], _rounded(c["noise"]),
                 _rounded(c["shear_noise"]), _rounded(c["residual_velocity"]), c["particles"], c["steps"], _rounded(c["wall_s"])] for c in cells])
    page.section("Machine, versions")
    page.table(["processor", "instruction set", "threads", "scarp", "compiler"],
               [[study["machine"]["processor"], study["isa"], study["threads"], study["versions"]["scarp"],
                 study["versions"]["compiler"]]])
    path = folder / "report.html"
    page.save(path)
    return path
