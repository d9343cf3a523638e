# SPDX-License-Identifier: BSD-3-Clause
"""What the page of a run says in words and tables: verdicts, facts, limits of the step, where the time went, the machine."""

import platform

import h5py
import matplotlib

from scarp_page import badge, number

FACTS = [("case", "case", ""), ("preset", "preset", ""), ("precision", "precision", ""),
         ("instruction set", "isa", ""), ("threads", "threads", ""), ("particle spacing", "spacing", "m"),
         ("smoothing length", "smoothing_length", "m"), ("particles", "particles", ""),
         ("wall particles", "wall_particles", ""), ("steps", "steps", ""),
         ("simulated time", "simulated_s", "s"), ("run time", "wall_s", "s"),
         ("speed", "particle_steps_per_s", "particle-steps/s"), ("memory", "memory_bytes", "bytes")]


def verdict_of(results):
    """True, False or None (nothing judged) for a run."""
    if results.get("complete") is False or results.get("failure"):
        return False
    verdicts = [m.get("pass") for m in results.get("measures", []) if m.get("pass") is not None]
    return results["pass"] if results.get("pass") is not None else all(verdicts) if verdicts else None


def run_badge(results):
    if not results:
        return badge(False, "✗ no results")
    if results.get("complete") is not False:
        return badge(verdict_of(results))
    return badge(False, "✗ lost soil" if results.get("finished") else "✗ incomplete")


def verdict_section(page, results):
    lost = results.get("lost_soil") or {}
    if results.get("finished") and lost.get("particles"):
        page.text(f"The run reached its end, but {results['failure']}", problem=True)
    elif results.get("failure"):
        page.text(f"The run did not reach its end: {results['failure']}", problem=True)
    if lost.get("particles") and not results.get("finished"):
        page.text(f"Before, soil was lost: {lost['particles']} particles, {number(lost.get('mass'))} kg.", problem=True)
    if not results and not page.left_out:
        page.text("There is no results.json: the run was killed or is still going on.", problem=True)
    if results.get("measures"):
        page.verdicts(results["measures"])


def own_figures(page, folder, results):
    """Figures the run's driver left: those named in results.json, else every picture in the folder."""
    named = results.get("figures") or [{"file": path.name, "caption": path.stem.replace("_", " ")}
                                       for path in sorted(folder.iterdir())
                                       if path.suffix in (".svg", ".png")]
    for entry in named:
        entry = entry if isinstance(entry, dict) else {"file": entry}
        path = (folder / entry["file"]).resolve()
        if path.exists() and folder.resolve() in path.parents:
            page.picture(path, entry.get("caption", path.stem.replace("_", " ")))


def facts_section(page, results):
    rows = [[words, results[key], unit] for words, key, unit in FACTS if results.get(key) is not None]
    if results.get("stages"):
        for stage in results["stages"]:
            how = "at rest" if stage.get("reached_rest") else "its time was up"
            rows.append([f"stage “{stage['name']}” ended", stage.get("end_time_s"), f"s ({how})"])
    if rows:
        page.table(["", "value", "unit"], [[words, number(value), unit] for words, value, unit in rows])


def step_limits_section(page, results):
    """What the time step was set by, and how often the run went back."""
    counts = {limit: n for limit, n in (results.get("step_limits") or {}).items() if n}
    steps = sum(counts.values())
    if counts:
        page.text("Time step set by: " + ", ".join(
            f"{limit.replace('_', ' ')} {100 * n / steps:.3g} %"
            for limit, n in sorted(counts.items(), key=lambda item: -item[1]))
            + f" of the steps; signals are fastest in “{results.get('signal_material')}”.")
    for retry in results.get("retries") or []:
        page.text(f"Unstable at step {retry['step']}: went back to step {retry['back_to']} and on with "
                  f"{retry['step_factor']:g} of the time step. {retry['reason']}")


def profile_section(page, results):
    """Where the run time went, largest first; what no phase took is the rest."""
    phases = results.get("profile")
    total = results.get("wall_s")
    if not phases or not total:
        return
    rows = [[phase["phase"].replace("_", " "), phase["wall_s"]] for phase in phases]
    rows.append(["the rest", max(total - sum(seconds for _, seconds in rows), 0.0)])
    rows.sort(key=lambda row: -row[1])
    page.table(["phase", "s", "share"],
               [[words, number(seconds), f"{100 * seconds / total:.1f} %"] for words, seconds in rows])


def machine_section(page, results):
    rows = [[key.replace("_", " "), str(value)] for group in ("machine", "versions", "numerics")
            for key, value in results.get(group, {}).items()]
    rows += [["report", f"Python {platform.python_version()}, matplotlib {matplotlib.__version__}, "
              f"h5py {h5py.__version__}"]]
    page.table(["", ""], rows)
