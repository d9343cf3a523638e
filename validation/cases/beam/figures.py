# SPDX-License-Identifier: BSD-3-Clause
"""Deflection of the free beam over time, and the energy of large deflections."""

import numpy as np
import scarp_report as scarp

plt = scarp.plt


def table(path):
    return np.loadtxt(path, delimiter=",", skiprows=1, unpack=True)


def draw(page, folder, figures):
    swings = sorted(path for path in folder.glob("deflection_modern_dx_*_m.csv") if "_deflection_" not in path.name)
    large = sorted(folder.glob("deflection_*_dx_0.1_m_deflection_0.3_m.csv"))
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.0, 3.6))
    for path in swings:
        time, deflection, exact, _ = table(path)
        left.plot(time, deflection, linewidth=1.0, label=path.stem.removeprefix("deflection_modern_dx_").replace("_", " "))
    if swings:
        left.plot(time, exact, color="#999999", linewidth=0.8, linestyle="--", label="closed form")
        left.set_xlim(0.0, 3.0)
        left.legend(fontsize=7)
    left.set_ylabel("deflection over the closed form's")
    for path in large:
        time, _, _, energy = table(path)
        name = path.stem.removeprefix("deflection_").removesuffix("_dx_0.1_m_deflection_0.3_m").replace("_", " ")
        right.plot(time, energy, linewidth=1.0, label=name)
    if large:
        right.set_ylim(0.0, 1.6)
        right.legend(fontsize=7)
    right.set_ylabel("kinetic and elastic energy over the start")
    for ax in (left, right):
        ax.set_xlabel("time over the period [-]")
        ax.grid(alpha=0.25, linewidth=0.5)
    if swings or large:
        page.figure(figure, "Deflection of the free beam without viscosity, and the energy of a beam that swings by 0.3 m.",
                    figures / "swing.png")
    else:
        plt.close(figure)
