# SPDX-License-Identifier: BSD-3-Clause
"""Slip surface of each slope with Bishop's circle, and the displacement in each trial."""

import json

import numpy as np
import scarp_report as scarp
from bishop_figures import CIRCLE, arc

plt = scarp.plt


def slip_figure(page, folder, figures, bishop, title):
    infos = [scarp.frame_info(path) for path, _ in scarp.read_series(folder) if path.exists()]
    if not infos:
        return
    first, last = scarp.load_frame(infos[0]["path"]), scarp.load_frame(infos[-1]["path"])
    figure, ax = plt.subplots(figsize=(9.0, scarp.figure_height(first, 1) + 0.4))
    scarp.draw_particles_2d(ax, last, "accumulated_plastic_strain", initial=first)
    ax.plot(*arc(bishop).T, label=f"Bishop's circle, F = {bishop['factor_of_safety']:.3f}", **CIRCLE)
    ax.legend(loc="upper right", fontsize=8)
    page.figure(figure, f"{title}: accumulated plastic strain at the least factor that failed; red dashes: ground "
                "before; blue dashes: Bishop's circle.", figures / f"slip_{folder.name}.png")


def draw(page, folder, figures):
    curves = []
    for place in sorted(path.parent for path in folder.glob("*/bishop.json")):
        bishop = json.loads((place / "bishop.json").read_text(encoding="utf-8"))
        title = scarp.read_results(place).get("title") or place.name
        slip_figure(page, place, figures, bishop, title)
        table = scarp.read_table(place / "displacement_srf.csv")
        if table:
            curves.append((title, bishop["factor_of_safety"], table[0]))
    if not curves:
        return
    figure, ax = plt.subplots(figsize=(7.2, 3.4))
    for (title, factor, columns), colour in zip(curves, scarp.CYCLE):
        ratio, fails = columns["SRF"] / factor, columns["fails"] > 0
        moved = np.maximum(columns["crest_displacement"], 1e-6)
        ax.semilogy(ratio[~fails], moved[~fails], "o", color=colour, label=title)
        ax.semilogy(ratio[fails], moved[fails], "^", color=colour, markerfacecolor="none")
    ax.axvline(1.0, **CIRCLE)
    ax.axvspan(0.96, 1.04, color="#0072b2", alpha=0.08, linewidth=0)
    ax.set_xlabel("strength reduction factor over Bishop's factor [-]")
    ax.set_ylabel("largest displacement [m]")
    ax.grid(alpha=0.25, linewidth=0.5)
    ax.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), fontsize=8)
    page.figure(figure, "Crest displacement in each trial; open triangles failed and were ended at the limit; band: 4 % "
                "about Bishop's factor.", figures / "displacement_srf.png")
