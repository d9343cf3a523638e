# SPDX-License-Identifier: BSD-3-Clause
"""Figures and page of error against run time, from what `scarp-validate error-time` left."""

import itertools
import json
import pathlib

import scarp_report as scarp

plt = scarp.plt
COLOUR = {"modern": "#0072b2", "paper": "#d55e00"}
MARKERS = "^v<DPsXp"  # of the axes with a single change, in their order
SEVERAL = "*"


def studies(folder):
    """The studies in the folder, in the order of error_time.json."""
    folder = pathlib.Path(folder)
    overall = json.loads((folder / "error_time.json").read_text(encoding="utf-8"))
    return [(entry, json.loads((folder / entry["file"]).read_text(encoding="utf-8"))) for entry in overall["cases"]]


def _usable(study):
    return [p for p in study["points"] if p["error"] is not None and p["error"] > 0]


def _rounded(value):
    return float(f"{value:.3g}")


def figure_of(study):
    """Error against run time, both logarithmic, with the front; None without a point to draw."""
    points = _usable(study)
    if not points:
        return None
    figure, ax = plt.subplots(figsize=(9.6, 5.0))
    changed = dict.fromkeys(axis for p in study["points"] if len(p["changes"]) == 1 for axis in p["changes"])
    marker_of = dict(zip(changed, itertools.cycle(MARKERS)))
    for preset, colour in COLOUR.items():
        own = sorted((p for p in points if p["preset"] == preset and not p["changes"]), key=lambda p: -p["spacing"])
        if own:
            ax.plot([p["wall_s"] for p in own], [100 * p["error"] for p in own], "o-", color=colour, linewidth=1.6,
                    markersize=6, label=f"{preset} as it stands", zorder=3)
        for p in own:
            ax.annotate(f"{p['spacing']:g} m", (p["wall_s"], 100 * p["error"]), xytext=(6, 5),
                        textcoords="offset points", fontsize=7.5, color=colour)
        for axis, marker in marker_of.items():
            some = [p for p in points if p["preset"] == preset and list(p["changes"]) == [axis]]
            if some:
                ax.plot([p["wall_s"] for p in some], [100 * p["error"] for p in some], linestyle="", marker=marker,
                        markersize=5, markerfacecolor="none", color=colour, label=f"{preset}, other {axis}")
        several = [p for p in points if p["preset"] == preset and len(p["changes"]) > 1]
        if several:
            ax.plot([p["wall_s"] for p in several], [100 * p["error"] for p in several], linestyle="",
                    marker=SEVERAL, markersize=8, markerfacecolor="none", color=colour,
                    label=f"{preset}, several changes")
    front = [study["points"][f] for f in study["front"]]
    ax.plot([p["wall_s"] for p in front], [100 * p["error"] for p in front], color="#222222", linewidth=1.1,
            drawstyle="steps-post", label="front: nothing is better in both", zorder=2)
    crowded = 0
    for number, p in enumerate(front, 1):
        before = front[number - 2] if number > 1 else None
        close = before and p["wall_s"] < 1.1 * before["wall_s"] and p["error"] > 0.9 * before["error"]
        crowded = crowded + 1 if close else 0
        ax.annotate(str(number), (p["wall_s"], 100 * p["error"]), xytext=(-4, -5 - 9 * crowded),
                    textcoords="offset points", ha="right", va="top", fontsize=8, fontweight="bold")
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.margins(x=0.09)
    for axis in (ax.xaxis, ax.yaxis):
        axis.set_major_formatter(lambda value, _: f"{value:g}")
        axis.set_minor_formatter(lambda value, _: f"{value:g}" if f"{value:e}"[0] in "25" else "")
        axis.set_tick_params(which="minor", labelsize=7)
    low, high = ax.get_ylim()
    for target in (10, 5, 2, 1):
        if low < target < high:
            ax.axhline(target, color="#999999", linewidth=0.6, linestyle="--", zorder=1)
            ax.annotate(f"{target} %", (1.0, target), xycoords=("axes fraction", "data"), xytext=(-2, 2),
                        textcoords="offset points", ha="right", fontsize=8, color="#666666")
    ax.set_xlabel("run time [s]")
    ax.set_ylabel("error [%]")
    ax.grid(alpha=0.2, linewidth=0.5, which="both")
    ax.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), fontsize=8, frameon=False)
    return figure


def caption(study):
    lost = sum(p["status"] != "ok" for p in study["points"])
    return (f"{study['case']}: {study['error']}, against run time on {study['threads']} threads ({study['isa']}). "
            "Numbers: the front, as in the table." + (f" Not drawn: {lost} runs without a result." if lost else ""))


def targets_table(page, study):
    """The cheapest setting of each preset for each error."""
    rows = []
    presets = [preset for preset in COLOUR if any(p["preset"] == preset for p in study["points"])]
    for one in study["targets"]:
        row = [f"{100 * one['target']:g} %"]
        for preset in presets:
            p = None if one[preset] is None else study["points"][one[preset]]
            row += [p["setting"] if p else "not reached", p["spacing"] if p else None,
                    _rounded(p["wall_s"]) if p else None]
        rows.append(row)
    page.table(["error at most"] + [title for preset in presets for title in (preset, "dx [m]", "run time [s]")],
               [["" if cell is None else cell for cell in row] for row in rows])


def front_table(page, study):
    rows = []
    for number, f in enumerate(study["front"], 1):
        p = study["points"][f]
        rows.append([number, p["setting"], p["spacing"], _rounded(100 * p["error"]), _rounded(p["wall_s"]),
                     "" if p["wall_spread"] is None else f"{100 * p['wall_spread']:.0f} %", _rounded(p["cpu_s"]),
                     _rounded(p["particle_steps"] / 1e6), _rounded(p["memory_bytes"] / 2**20)])
    page.table(["", "setting", "dx [m]", "error [%]", "run time [s]", "spread", "CPU time [s]",
                "particle-steps [M]", "memory [MiB]"], rows)


def changes_table(page, study):
    """What each single change does to error and run time of its preset, at the finest spacing with changes."""
    single = [p for p in study["points"] if len(p["changes"]) == 1]
    if not single:
        return
    counts = {}
    for p in single:
        counts[p["spacing"]] = counts.get(p["spacing"], 0) + 1
    spacing = min(h for h, n in counts.items() if n == max(counts.values()))
    rows = []
    for p in study["points"]:
        own = [q for q in study["points"] if q["preset"] == p["preset"] and q["spacing"] == spacing
               and not q["changes"]]
        if p["spacing"] != spacing or len(p["changes"]) > 1 or p["reference"] or not own:
            continue
        change = ", ".join(p["changes"].values()) or "as it stands"
        if p["error"] is None:
            rows.append([p["preset"], change, p["status"], "", "", ""])
            continue
        base = own[0]
        rows.append([p["preset"], change, _rounded(100 * p["error"]), _rounded(p["wall_s"]),
                     _rounded(p["error"] / base["error"]) if base["error"] else "",
                     _rounded(p["wall_s"] / base["wall_s"])])
    rows.sort(key=lambda row: (row[0], row[1] != "as it stands"))
    page.section(f"One change at a time, dx = {spacing:g} m", level=3)
    page.table(["preset", "changed to", "error [%]", "run time [s]", "error over the preset's",
                "run time over the preset's"], rows)


def study_parts(page, study, file=None, level=2):
    """Sentences and figure, which is kept as `file`."""
    page.section(f"{study['case']}: {study['error']}", anchor=f"error_time_{study['case']}", level=level)
    for sentence in study["sentences"]:
        page.text(sentence)
    figure = figure_of(study)
    if figure is not None:
        page.figure(figure, caption(study), file)


def error_time_page(folder):
    """Writes DIR/report.html and DIR/<case>.png; returns the page's path."""
    folder = pathlib.Path(folder)
    all_studies = studies(folder)
    page = scarp.Page("Error against run time",
                      "What a wanted error costs: spacing, preset, smoothing function, integrator and time step, "
                      "force, viscosity, stress diffusion, precision, sleep.")
    page.text("Each mark is one setting at one spacing; its run time is the median of repeated runs that took turns "
              "with the other settings, of the time steps alone; the spread is that of the middle half of these runs. The "
              "front joins the settings that no other beats "
              "in both error and run time. Run times compare only with those of the same machine.")
    for _, study in all_studies:
        study_parts(page, study, folder / f"{study['case']}.png")
        page.section("The front", level=3)
        front_table(page, study)
        page.section("Cheapest setting for an error, by preset", level=3)
        targets_table(page, study)
        changes_table(page, study)
    page.section("Machine, versions")
    rows = {(study["machine"]["processor"], study["isa"], study["threads"], study["versions"]["scarp"],
             study["versions"]["compiler"]): None for _, study in all_studies}
    page.table(["processor", "instruction set", "threads", "scarp", "compiler"], [list(row) for row in rows])
    path = folder / "report.html"
    page.save(path)
    return path
