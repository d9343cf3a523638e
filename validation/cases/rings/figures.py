# SPDX-License-Identifier: BSD-3-Clause
"""The rings after the bounce, with artificial stress and without."""

import scarp_report as scarp

plt = scarp.plt


def draw(page, folder, figures):
    shown = [("broken.csv", "no artificial stress"), ("whole.csv", "artificial stress 0.5")]
    tables = [(scarp.read_table(folder / name), title) for name, title in shown]
    if not all(table for table, _ in tables):
        return
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.6))
    for ax, (table, title) in zip(axes, tables):
        columns = table[0]
        left = columns["x"] < 0.0
        x, y, stress = (columns[name][left] for name in ("x", "y", "mean stress"))
        points = ax.scatter(1e3 * x, 1e3 * y, c=1e-6 * stress, s=1.5,
                            cmap="coolwarm", vmin=-0.5, vmax=0.5, linewidths=0)
        ax.set_aspect("equal")
        ax.set_title(title, fontsize=9)
        ax.set_xlabel("x [mm]")
    axes[0].set_ylabel("y [mm]")
    figure.colorbar(points, ax=list(axes), label="mean stress [MPa]", shrink=0.7)
    page.figure(figure, "The left ring at the finest spacing that was run: when fracture was certain and the run was "
                "ended, and after the bounce. Tension is red; the numbers are normalised.", figures / "rings.png")
