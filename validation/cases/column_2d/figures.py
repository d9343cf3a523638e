# SPDX-License-Identifier: BSD-3-Clause
"""Run-out over aspect ratio, surfaces of all columns, and the deposit of one."""

import column_figures as columns
import scarp_report as scarp

plt = scarp.plt
WIDTH = 0.1  # half width of the columns [m]
LAWS = [("Lube et al. 2005", columns.law(2.3, 1.2, 1.9, 2 / 3)),
        ("Lajeunesse et al. 2005", columns.law(3.0, 1.8, 2.3, 2 / 3))]


def draw(page, folder, figures):
    columns.run_out(page, folder, figures, LAWS, 65.0)
    surfaces = sorted(folder.glob("surface_*_a*_phi30.csv"), key=lambda path: path.name.replace("paper", "z"))
    if surfaces:
        figure, ax = plt.subplots(figsize=(9.0, 2.3))
        colours = {}
        for path in surfaces:
            _, preset, aspect, _ = path.stem.split("_")
            colour = colours.setdefault(aspect, scarp.plt.rcParams["axes.prop_cycle"].by_key()["color"][len(colours)])
            table = scarp.read_table(path)[0]
            style = "-" if preset == "modern" else ":"
            ax.plot(table["x"] / WIDTH, table["height"] / WIDTH, style, color=colour, linewidth=1.1,
                    label=f"a = {aspect[1:]}, {preset}")
        ax.set_aspect("equal")
        ax.set_xlabel("x/L0 [-]")
        ax.set_ylabel("height/L0 [-]")
        ax.legend(loc="upper right", fontsize=8, ncols=2)
        page.figure(figure, "Surface of the deposits by columns of two spacings, at the finest spacing run.",
                    figures / "surfaces.png")
    last, first = columns.last_and_first(folder)
    if last is None:
        return
    figure, ax = plt.subplots(figsize=(9.0, 2.9))
    scarp.draw_particles_2d(ax, last, "displacement", initial=first, title="")
    columns.fronts(ax, LAWS, columns.aspect_ratio(first, 1), WIDTH)
    page.figure(figure, "Deposit of one column, shaded by displacement. Red dashes: before the gate went; blue: fronts "
                "by the laws.", figures / "deposit.png")
