# SPDX-License-Identifier: BSD-3-Clause
"""Slip band against Bishop's circle, and displacement against strength."""

import json

import numpy as np
import scarp_report as scarp
from bishop_figures import CIRCLE, arc

plt = scarp.plt


def draw(page, folder, figures):
    bishop = json.loads((folder / "bishop.json").read_text(encoding="utf-8"))
    series = scarp.read_series(folder)
    shown = scarp.frames_of(folder, "last") + scarp.frames_of(folder, "stage_end")
    if shown and series:
        first, _ = series[0]
        last = scarp.load_frame(max(shown, key=lambda info: info["time"])["path"])
        figure, ax = plt.subplots(figsize=(9.0, 3.9))
        scarp.draw_particles_2d(ax, last, "accumulated_plastic_strain", initial=scarp.load_frame(first))
        ax.plot(*arc(bishop).T, label=f"Bishop's circle, F = {bishop['factor_of_safety']:.3f}", **CIRCLE)
        band = scarp.read_table(folder / "slip_band.csv")
        if band:
            ax.plot(band[0]["x"], band[0]["y"], "o", color="#009e73", markersize=4, markerfacecolor="none",
                    label="slip band, in the undeformed slope")
        ax.legend(loc="upper right", fontsize=8)
        page.figure(figure, "As the paper's Fig. 1: strength cut by 1.4, end of the slide. Shading: accumulated plastic "
                    "strain; red dashes: ground before; blue dashes: Bishop's circle; rings: where the slip band was found, moved back "
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
        page.figure(figure, "Largest displacement of the crest after the strength was cut, from one settled slope; runs that cross the limit end there.",
                    figures / "displacement_srf.png")
