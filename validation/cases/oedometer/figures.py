# SPDX-License-Identifier: BSD-3-Clause
"""Vertical stress over height, and its error."""

import numpy as np
import scarp_report as scarp

plt = scarp.plt


def draw(page, folder, figures):
    tables = sorted(folder.glob("profile_*.csv"))
    if not tables:
        return
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 3.8), sharey=True)
    for path, marker in zip(tables, "osx+"):
        height, stress, exact = np.loadtxt(path, delimiter=",", skiprows=1, unpack=True)
        name = path.stem.removeprefix("profile_").replace("_", " ").replace("2d", "2D").replace("3d", "3D")
        left.plot(stress / 1000.0, height, marker, markersize=3, fillstyle="none", label=name)
        right.plot(100.0 * (stress - exact) / np.abs(exact).max(), height, marker, markersize=3, fillstyle="none",
                   label=name)
    order = np.argsort(height)
    left.plot(exact[order] / 1000.0, height[order], color="#999999", linewidth=1.0, label="closed form")
    left.set_xlabel("vertical stress [kPa]")
    left.set_ylabel("height [m]")
    right.set_xlabel("error over gamma H [%]")
    for ax in (left, right):
        ax.grid(alpha=0.25, linewidth=0.5)
    left.legend(fontsize=8)
    page.figure(figure, "Vertical stress of every particle at the finest spacing, and its error.",
                figures / "profile.png")
