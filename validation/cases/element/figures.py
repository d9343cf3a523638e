# SPDX-License-Identifier: BSD-3-Clause
"""Stress paths with the yield line, errors over the strain increment, and the three forms of plasticity."""

import numpy as np
import scarp_report as scarp

plt = scarp.plt
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"]


def groups(columns, key):
    """Rows of a table by the text in one column, in order of appearance: {text: {column: numbers}}."""
    names = np.array(columns[key])
    return {name: {title: np.array(values)[names == name] for title, values in columns.items()}
            for name in dict.fromkeys(columns[key])}


def draw(page, folder, figures):
    stress_paths(page, folder, figures)
    convergence(page, folder, figures)
    plasticity(page, folder, figures)


def stress_paths(page, folder, figures):
    table, line = scarp.read_table(folder / "stress_paths.csv"), scarp.read_table(folder / "yield_line.csv")
    if not table or not line:
        return
    a, k = line[0]["alpha_phi"][0], line[0]["k_c"][0]
    figure, ax = plt.subplots(figsize=(7.6, 4.4))
    top = max(table[0]["p"]) / 1e3
    apex = -k / (3 * a) / 1e3
    pressure = np.array([apex, 1.05 * top])
    ax.plot(pressure, (k / 1e3 + 3 * a * pressure), "k--", linewidth=1.0, label="yield line")
    ax.plot(apex, 0.0, "k^", markersize=6, label="apex")
    for colour, (name, rows) in zip(COLOURS, groups(table[0], "path").items()):
        ax.plot(rows["p"] / 1e3, rows["sqrt_J2"] / 1e3, color=colour, linewidth=1.6, label=name)
        ax.plot(rows["p"][-1] / 1e3, rows["sqrt_J2"][-1] / 1e3, "o", color=colour, markersize=5)
    ax.set_xlabel("mean pressure p = -I1/3 [kPa]")
    ax.set_ylabel("sqrt(J2) [kPa]")
    ax.grid(alpha=0.25, linewidth=0.5)
    ax.legend(fontsize=8)
    page.figure(figure, "Stress paths of soil_12 (c = 10 kPa, phi = 30, psi = 12 degrees, plane_strain cone) from 100 kPa "
                "isotropic; dots: ends.", figures / "stress_paths.png")


def convergence(page, folder, figures):
    table = scarp.read_table(folder / "convergence.csv")
    if not table:
        return
    figure, ax = plt.subplots(figsize=(7.6, 3.8))
    for colour, (name, rows) in zip(COLOURS, groups(table[0], "quantity").items()):
        ax.loglog(rows["steps"], rows["error"], "o-", color=colour, label=f"{name} (order {rows['order'][0]:.2f})")
    ax.set_xlabel("strain steps")
    ax.set_ylabel("relative error [-]")
    ax.grid(alpha=0.25, linewidth=0.5, which="both")
    ax.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), fontsize=8)
    page.figure(figure, "Errors over the number of strain steps, for what depends on it.", figures / "step_count.png")


def plasticity(page, folder, figures):
    table = scarp.read_table(folder / "plasticity.csv")
    if not table:
        return
    rows = groups(table[0], "soil").get("soil_12")
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.2))
    for (name, one), style in zip(groups(rows, "plasticity").items(), ("-", "--", ":")):
        axial = 100 * one["axial_strain"]
        axes[0].plot(axial, one["yield_function"] / (one["sqrt_J2"] - one["yield_function"]), style, label=name)
        error = one["volumetric_strain"] - one["expected_volumetric_strain"]
        axes[1].plot(axial, 1e4 * error, style, label=name)
    axes[0].set_ylim(-0.1, 0.1)
    axes[0].set_ylabel("yield function over strength [-]")
    axes[1].set_ylabel("volumetric strain - exact [1e-4]")
    for ax in axes:
        ax.set_xlabel("axial strain [%]")
        ax.grid(alpha=0.25, linewidth=0.5)
    axes[0].legend(fontsize=8)
    figure.tight_layout()
    page.figure(figure, "Triaxial compression of soil_12 with the three forms of plasticity. Left: 0 is on the yield "
                "surface. What the rate forms miss, they miss in the step that first meets the surface.",
                figures / "plasticity.png")
