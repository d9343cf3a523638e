# SPDX-License-Identifier: BSD-3-Clause
"""Run-out over aspect ratio, the middle section and the plan of one deposit."""

import column_figures as columns
import numpy as np
import scarp_report as scarp

plt = scarp.plt
RADIUS = 0.1  # of the cylinders [m]
LAWS = [("Lube et al. 2004", columns.law(1.7, 1.24, 1.6, 0.5)),
        ("Lajeunesse et al. 2004", columns.law(0.74, 1.0, 2.0, 0.5))]


def draw(page, folder, figures):
    columns.run_out(page, folder, figures, LAWS, 65.0)
    last, first = columns.last_and_first(folder)
    if last is None:
        return
    position, spacing = last["position"], last["spacing"]
    aspect = columns.aspect_ratio(first, 2)
    figure, ax = plt.subplots(figsize=(9.0, 3.0))
    radius = np.hypot(position[:, 0], position[:, 1])
    ax.scatter(radius, position[:, 2], s=4.0, color="#b8864b", linewidths=0)
    ax.plot([0, RADIUS, RADIUS], [aspect * RADIUS, aspect * RADIUS, 0], color="#d62728", linewidth=0.9,
            linestyle=(0, (5, 3)), label="before")
    ax.set_aspect("equal")
    ax.set_xlim(0, None)
    ax.set_ylim(-2 * spacing, None)
    ax.set_xlabel("radius [m]")
    ax.set_ylabel("z [m]")
    columns.fronts(ax, LAWS, aspect, RADIUS)
    page.figure(figure, "All particles of one deposit over their radius.", figures / "radial.png")
    figure, ax = plt.subplots(figsize=(5.4, 4.6))
    scarp.draw_plan(ax, last)
    page.figure(figure, "Its elevation from above.", figures / "plan.png")
