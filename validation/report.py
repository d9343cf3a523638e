#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a validation case: `report.py DIR` makes DIR/report.html and DIR/figures from what the case left."""

import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "engine" / "report"))
import scarp_report as scarp  # noqa: E402
import numpy as np  # noqa: E402

plt = scarp.plt
CIRCLE = dict(color="#0072b2", linewidth=1.4, linestyle=(0, (6, 2)))


def frames_of(folder, event):
    """The frames written at the end of a stage, in order; `event` as in the frames' attribute."""
    infos = [scarp.frame_info(path) for path, _ in scarp.read_series(folder) if path.exists()]
    return [info for info in infos if info["event"] == event]


def arc(bishop):
    """The critical circle below the ground line, (n, 2)."""
    circle = bishop["circle"]
    angles = [np.arctan2(p[0] - circle["x"], circle["y"] - p[1]) for p in (bishop["entry"], bishop["exit"])]
    along = np.linspace(*angles, 200)
    return np.column_stack([circle["x"] + circle["radius"] * np.sin(along),
                            circle["y"] - circle["radius"] * np.cos(along)])


def slope_figures(page, folder, figures):
    bishop = json.loads((folder / "bishop.json").read_text(encoding="utf-8"))
    shown, (first, _) = frames_of(folder, "last") + frames_of(folder, "stage_end"), scarp.read_series(folder)[0]
    if shown:
        last = scarp.load_frame(max(shown, key=lambda info: info["time"])["path"])
        figure, ax = plt.subplots(figsize=(9.0, 3.9))
        scarp.draw_particles_2d(ax, last, "accumulated_plastic_strain", initial=scarp.load_frame(first))
        ax.plot(*arc(bishop).T, label=f"Bishop's circle, F = {bishop['factor_of_safety']:.3f}", **CIRCLE)
        band = scarp.read_table(folder / "slip_band.csv")
        if band:
            ax.plot(band[0]["x"], band[0]["y"], "o", color="#009e73", markersize=4, markerfacecolor="none",
                    label="slip band, in the undeformed slope")
        ax.legend(loc="upper right", fontsize=8)
        page.figure(figure, "Strength cut by 1.4, end of the slide. Shading: accumulated plastic strain; red dashes: "
                    "ground before; blue dashes: Bishop's circle; rings: where the slip band was found, moved back "
                    "to where its soil lay before the slide, as Bishop's circle is.",
                    figures / "slip_and_circle.png")
    curve = scarp.read_table(folder / "displacement_srf.csv")
    if curve:
        columns = curve[0]
        figure, ax = plt.subplots(figsize=(6.2, 3.2))
        ax.semilogy(columns["SRF"], np.maximum(columns["crest_displacement"], 1e-5), "o-", color="#333333")
        ax.axhline(0.1, color="#d62728", linewidth=0.9, linestyle="--", label="failure: 1 % of the height")
        ax.axvline(bishop["factor_of_safety"], **CIRCLE, label="FOS by Bishop")
        ax.set_xlabel("strength reduction factor [-]")
        ax.set_ylabel("crest displacement [m]")
        ax.grid(alpha=0.25, linewidth=0.5)
        ax.legend(fontsize=8)
        page.figure(figure, "Displacement of the crest 4 s after the strength was cut, from one settled slope.",
                    figures / "displacement_srf.png")


def cuboid_figures(page, folder, figures):
    shown, series = frames_of(folder, "last") + frames_of(folder, "stage_end"), scarp.read_series(folder)
    if not shown or not series:
        return
    last = scarp.load_frame(max(shown, key=lambda info: info["time"])["path"])
    first = scarp.load_frame(series[0][0])
    start = scarp.section(first)
    cut = scarp.section(last)
    figure, ax = plt.subplots(figsize=(9.0, 3.0))
    scarp.draw_particles_2d(ax, cut, "displacement", initial=start, axes=(0, 2))
    for factor, name in ((1.2, "Lube 2005"), (1.8, "Lajeunesse 2005")):
        ax.axvline(0.3 + factor * 0.144, color="#0072b2", linewidth=0.9, linestyle=":" if factor < 1.5 else "--",
                   label=f"planar front, {name}")
    ax.legend(loc="upper right", fontsize=8)
    page.figure(figure, "Middle section at the end. Red dashes: the soil before the gate went; blue: fronts of planar "
                "columns in experiments, without spreading to the sides.", figures / "middle_section.png")
    figure, ax = plt.subplots(figsize=(9.0, 4.6))
    scarp.draw_plan(ax, last)
    page.figure(figure, "Elevation from above at the end.", figures / "plan.png")


CASE_FIGURES = {"slope_2d": slope_figures, "cuboid_3d": cuboid_figures}


def cost_section(page, results):
    rows = [[run["name"], run["steps"], run["simulated_s"], run["wall_s"]] for run in results.get("runs", [])]
    rows.append(["whole case", results.get("steps"), None, results.get("wall_s")])
    page.table(["run", "steps", "simulated [s]", "run time [s]"],
               [["" if value is None else value for value in row] for row in rows])


def report(folder):
    folder = pathlib.Path(folder)
    results = scarp.read_results(folder)
    figures = folder / "figures"
    page = scarp.Page(results.get("title") or results.get("case") or folder.name,
                      f"scarp validation, case {results.get('case', folder.name)}, {results.get('form', '')} form, "
                      f"preset {results.get('preset', '?')}")
    page.text(scarp.badge(scarp.verdict_of(results)))
    scarp.verdict_section(page, results)
    draw = CASE_FIGURES.get(results.get("case"))
    if draw and scarp.read_series(folder):
        draw(page, folder, figures)
    page.section("Cost")
    cost_section(page, results)
    page.section("Run")
    scarp.facts_section(page, results)
    page.section("Particles")
    scarp.particle_figures(page, folder, figures)
    page.section("Histories")
    scarp.history_figures(page, folder, figures)
    page.section("Machine, versions, numerics")
    scarp.machine_section(page, results)
    path = folder / "report.html"
    page.save(path)
    return path


if __name__ == "__main__":
    if len(sys.argv) != 2 or not pathlib.Path(sys.argv[1]).is_dir():
        sys.exit("usage: report.py DIR (the folder of a case)")
    report(sys.argv[1])
