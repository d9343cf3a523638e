# SPDX-License-Identifier: BSD-3-Clause
"""Deposit with the experiment's surface and failure line; both presets' surfaces."""

import pathlib

import column_figures as columns
import numpy as np
import scarp_report as scarp

plt = scarp.plt
HERE = pathlib.Path(__file__).resolve().parent
MARKS = dict(linestyle="none", markersize=4.5, markeredgewidth=1.1, markerfacecolor="white", zorder=4)


def experiment(ax):
    for name, marker, colour, label in (("surface", "o", "#0072b2", "surface, Bui et al. 2008"),
                                        ("failure_line", "s", "#d55e00", "failure line, Bui et al. 2008")):
        table = scarp.read_table(HERE / f"bui_2008_{name}.csv")[0]
        ax.plot(table["x"], table["height"], marker, color=colour, label=label, **MARKS)


def draw(page, folder, figures):
    last, first = columns.last_and_first(folder)
    if last is not None:
        inside = last["position"][:, 1] > -2 * last["spacing"]
        moved = np.where(last["fields"]["displacement"][:, 0] > 1e-3, 0.55, 0.12)
        shown = dict(last, position=last["position"][inside], fields={"moved": moved[inside]}, units={"moved": ""})
        figure, ax = plt.subplots(figsize=(9.0, 2.6))
        scarp.draw_particles_2d(ax, shown, "moved", initial=first, limits=(0.0, 1.0), colour_map="Greys", bar=False)
        experiment(ax)
        ax.legend(loc="upper right", fontsize=8)
        page.figure(figure, "Deposit; dark: moved by more than 1 mm in x; red dashes: the stack before. Marks: the "
                    "experiment.", figures / "deposit.png")
    figure, ax = plt.subplots(figsize=(9.0, 2.6))
    for path in sorted(folder.glob("surface_*.csv")):
        preset = path.stem.split("_")[1]
        table, line = scarp.read_table(path)[0], scarp.read_table(folder / f"failure_line_{preset}.csv")[0]
        style = "-" if preset == "modern" else ":"
        ax.plot(table["x"], table["height"], style, color="#333333", label=f"surface, {preset}")
        ax.plot(line["x"], line["height"], style, color="#009e73", label=f"failure line, {preset}")
    experiment(ax)
    ax.set_aspect("equal")
    ax.set_xlabel("x [m]")
    ax.set_ylabel("y [m]")
    ax.legend(loc="upper right", fontsize=8, ncols=2)
    page.figure(figure, "Surfaces by columns of 1 cm and the upper edge of unmoved soil, at the finest spacing run.",
                figures / "surfaces.png")
