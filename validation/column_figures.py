# SPDX-License-Identifier: BSD-3-Clause
"""Figures of the column cases: run-out over aspect ratio between two laws, and a deposit."""

import numpy as np
import scarp_report as scarp

plt = scarp.plt
MARKERS = {"modern": "o", "paper": "s"}


def law(transition, below, above, exponent):
    return lambda a: np.where(a < transition, below * a, above * a**exponent)


def run_out(page, folder, figures, laws, control):
    """`laws`: [(name, function of the aspect ratio)], two; `control`: friction angle that must miss [deg]."""
    table = scarp.read_table(folder / "run_out.csv")
    if not table:
        return
    columns = {name: np.array(values) for name, values in table[0].items()}
    a, measured, spacing = columns["aspect_ratio"], columns["run_out"], columns["dx"]
    along = np.geomspace(0.8 * a.min(), 1.25 * a.max(), 300)
    figure, ax = plt.subplots(figsize=(6.6, 4.2))
    ax.fill_between(along, laws[0][1](along), laws[1][1](along), color="#56b4e9", alpha=0.25, linewidth=0,
                    label="between the laws")
    for (name, function), style in zip(laws, ("-", "--")):
        ax.plot(along, function(along), style, color="#0072b2", linewidth=1.0, label=name)
    strong = columns["friction_angle"] > 0.99 * control
    for number, preset in enumerate(dict.fromkeys(columns["preset"])):
        mine = columns["preset"] == preset
        for chosen, colour, what in ((mine & ~strong, ("#d55e00", "#333333")[number % 2], ""),
                                     (mine & strong, "#999999", f", phi = {control:g}°")):
            if not chosen.any():
                continue
            # The finer, the larger the mark.
            rank = np.array([np.sum((spacing > dx) & chosen & (a == ratio)) for dx, ratio in zip(spacing, a)])
            ax.scatter(a[chosen], measured[chosen], s=14 + 22 * rank[chosen], marker=MARKERS.get(preset, "^"),
                       facecolors="none", edgecolors=colour, linewidths=1.1, zorder=3, label=preset + what)
            ax.scatter(a[chosen], columns["grain_run_out"][chosen], s=30 + 45 * rank[chosen], marker="_", color=colour,
                       linewidths=1.1, zorder=3)
    ax.set_xscale("log")
    ax.set_yscale("log")
    for axis, ticks in ((ax.xaxis, [0.5, 1, 2, 4]), (ax.yaxis, [0.5, 1, 2, 4, 8])):
        axis.set_major_locator(plt.FixedLocator(ticks))
        axis.set_major_formatter(plt.FuncFormatter(lambda value, _: f"{value:g}"))
        axis.set_minor_locator(plt.NullLocator())
    ax.set_xlabel("aspect ratio a = H0/L0 [-]")
    ax.set_ylabel("run-out (L - L0)/L0 [-]")
    ax.grid(alpha=0.25, linewidth=0.5)
    ax.legend(loc="upper left", fontsize=8)
    page.figure(figure, "Run-out over aspect ratio against the laws of experiments, to 99.5 % of the volume; lines: to where "
                "the deposit is one grain high. A larger mark is a finer spacing.",
                figures / "run_out.png")


def last_and_first(folder):
    shown, series = scarp.frames_of(folder, "last") + scarp.frames_of(folder, "stage_end"), scarp.read_series(folder)
    if not shown or not series:
        return None, None
    return scarp.load_frame(max(shown, key=lambda info: info["time"])["path"]), scarp.load_frame(series[0][0])


def fronts(ax, laws, aspect, width):
    """Where the laws put the front of the column shown, and room for them and a legend."""
    for (name, function), style in zip(laws, ("-", "--")):
        front = width * (1.0 + float(function(np.array(aspect))))
        ax.axvline(front, color="#0072b2", linewidth=0.9, linestyle=style, label=f"front, {name}")
        ax.set_xlim(None, max(ax.get_xlim()[1], front + 0.05 * width))
    ax.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=3, fontsize=8)


def aspect_ratio(first, up):
    """H0/L0 of the column in its first frame."""
    high, far = (first["position"][:, axis].max() + 0.5 * first["spacing"] for axis in (up, 0))
    return high / far
