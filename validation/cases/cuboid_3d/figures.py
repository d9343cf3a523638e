# SPDX-License-Identifier: BSD-3-Clause
"""Middle section and plan of the deposit."""

import scarp_report as scarp

plt = scarp.plt


def draw(page, folder, figures):
    shown, series = scarp.frames_of(folder, "last") + scarp.frames_of(folder, "stage_end"), scarp.read_series(folder)
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
