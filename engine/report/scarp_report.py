#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a run: `scarp_report.py DIR` makes DIR/report.html and DIR/figures; with `--page OUT.html DIR...` one
page over several runs. The functions of scarp_frames, scarp_figures and scarp_page can be imported from here."""

import argparse
import pathlib
import platform
import signal
import sys

if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # ends like any program, without a traceback
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
try:
    from scarp_figures import *  # noqa: F401,F403
    from scarp_figures import (colour_limits, draw_history, draw_particles_2d, draw_particles_3d, draw_plan,
                               in_view, label_of, outline, plt, section)
    from scarp_frames import (Damaged, frame_info, load_frame, load_walls, read_results, read_series, read_table,
                              scalar)
    from scarp_converge import converge_page
    from scarp_histories import history_figures
    from scarp_fos import fos_page
    from scarp_progress import Progress
    from scarp_page import Page, Raw, badge, band, cannot_be_shown, number  # noqa: F401
    from scarp_viewer import PICTURE_BYTES, moving_picture
except ImportError as error:
    sys.exit(f"scarp report: {error}; install Debian's python3-matplotlib and python3-h5py.")

import h5py  # noqa: E402
import matplotlib  # noqa: E402
import numpy as np  # noqa: E402

FACTS = [("case", "case", ""), ("preset", "preset", ""), ("precision", "precision", ""),
         ("instruction set", "isa", ""), ("threads", "threads", ""), ("particle spacing", "spacing", "m"),
         ("smoothing length", "smoothing_length", "m"), ("particles", "particles", ""),
         ("wall particles", "wall_particles", ""), ("steps", "steps", ""),
         ("simulated time", "simulated_s", "s"), ("run time", "wall_s", "s"),
         ("speed", "particle_steps_per_s", "particle-steps/s"), ("memory", "memory_bytes", "bytes")]


def shown_frames(page, folder, most=6):
    """The first frame, the frames at the end of a stage or of the run, and their numbers; damaged ones are left out
    and told."""
    found = [(n, page.part(path, frame_info, path)) for n, (path, _) in enumerate(read_series(folder))
             if path.exists()]
    infos = [dict(info, number=n) for n, info in found if info is not None]
    if not infos:
        return None, []
    ends = [info for info in infos if info["event"] in ("stage_end", "last", "stopped")]
    if infos[-1]["number"] not in [info["number"] for info in ends]:
        ends.append(infos[-1])
    return infos[0], ends[-most:]


def frames_of(folder, event):
    """The frames written at the end of a stage, in order; `event` as in the frames' attribute."""
    infos = [frame_info(path) for path, _ in read_series(folder) if path.exists()]
    return [info for info in infos if info["event"] == event]


def particle_figures(page, folder, figures):
    first, ends = shown_frames(page, folder)
    if first is None:
        page.text("The run wrote no frames.")
        return
    initial = page.part(first["path"], load_frame, first["path"])
    draw = plane_frame if first["dimension"] == 2 else space_frame
    lines = []
    page.progress.expect(len(ends) * (2 if first["dimension"] == 2 else 4))
    if initial is not None:
        lines = outline(initial) if first["dimension"] == 2 else outline(section(initial), axes=(0, 2))
    for end in ends:
        page.part(end["path"], draw, page, folder, figures, lines, end)


def walls_of(page, folder, number):
    return page.part(folder / "frames" / "walls.hdf", load_walls, folder, number)


def plane_frame(page, folder, figures, lines, end):
    frame, outside = in_view(load_frame(end["path"]))
    walls = walls_of(page, folder, end["number"])
    for field in ("accumulated_plastic_strain", "displacement"):
        if field in frame["fields"]:
            size = np.ptp(np.concatenate([frame["position"]] + [np.pad(l, ((0, 0), (0, 1))) for l in lines]),
                          axis=0)
            height = float(np.clip(7.6 * size[1] / max(size[0], 1e-9) + 0.9, 1.8, 9.0))
            figure, ax = plt.subplots(figsize=(9.0, height))
            draw_particles_2d(ax, frame, field, None, lines, walls)
            page.figure(figure, f"{label_of(field, '').rsplit(' [', 1)[0].capitalize()} at t = {end['time']:.4g} s"
                        f" ({words_of(end)}); dashed: outline at the start; grey: wall particles. {outside}",
                        figures / f"{field}_{end['number']:05}.png")


def space_frame(page, folder, figures, lines, end):
    frame, outside = in_view(load_frame(end["path"]))
    name, when = f"{end['number']:05}.png", f"at t = {end['time']:.4g} s ({words_of(end)})"
    figure = plt.figure(figsize=(9.0, 6.4))
    draw_particles_3d(figure.add_subplot(projection="3d"), frame, title="")
    page.figure(figure, f"Displacement {when}; particles that can be seen from outside. {outside}",
                figures / f"view_{name}")
    figure, ax = plt.subplots(figsize=(9.0, figure_height(frame, 1)))
    draw_plan(ax, frame)
    page.figure(figure, f"Elevation of the highest particle {when}. {outside}", figures / f"plan_{name}")
    cut = section(frame)
    for field in ("accumulated_plastic_strain", "displacement"):
        if field in cut["fields"]:
            figure, ax = plt.subplots(figsize=(9.0, figure_height(frame, 2)))
            draw_particles_2d(ax, cut, field, initial=lines, axes=(0, 2))
            page.figure(figure, f"Middle section across y {when}, {field.replace('_', ' ')}; dashed: outline "
                        f"at the start. {outside}", figures / f"section_{field}_{name}")


def figure_height(frame, axis):
    size = np.ptp(frame["position"], axis=0)
    return float(np.clip(7.6 * size[axis] / max(size[0], 1e-9) + 0.9, 1.8, 9.0))


def words_of(end):
    return {"stage_end": f"end of stage “{end['stage']}”", "stopped": "where the run stopped"}.get(
        end["event"], "last frame")


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


def _escaped(text):
    import html
    return html.escape(str(text))


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


def run_parts(page, folder, results, level=2, budget=0.0):
    """Everything about one run except the machine. `budget`: bytes that the moving picture may take."""
    figures, source = folder / "figures", folder / "results.json"
    page.part(source, verdict_section, page, results)
    page.part(source, own_figures, page, folder, results)
    if budget > 0:
        page.section("Picture", level=level)
        page.part(folder / "frames", moving_picture, page, folder, budget)
    page.section("Run", level=level)
    for draw in (facts_section, step_limits_section, profile_section):
        page.part(source, draw, page, results)
    page.section("Particles", level=level)
    page.part(folder / "frames" / "soil.hdf.series", particle_figures, page, folder, figures)
    page.section("Histories", level=level)
    history_figures(page, folder, figures)


LEFT_BY_A_RUN = ("results.json", "run.json", "history.csv", "frames")


def require_run(folder):
    if not any((folder / name).exists() for name in LEFT_BY_A_RUN):
        raise NoRun(f"'{folder}': there is no run in it, none of {', '.join(LEFT_BY_A_RUN)}. Give the output folder of "
                    "scarp run, scarp converge or scarp fos.")


class NoRun(Exception):
    """A folder that nothing was left in."""


def title_of(folder, results):
    return str(results.get("title") or results.get("case") or folder.name)


def report(folder, out=None, budget=PICTURE_BYTES):
    """Writes the page of one run, or of what `scarp converge` or `scarp fos` left; returns its path. `budget`: bytes that
    the moving picture may take."""
    folder = pathlib.Path(folder)
    if (folder / "converge.json").exists():
        return converge_page(folder, out)
    if (folder / "fos.json").exists():
        return fos_page(folder, out, lambda page, run: moving_picture(page, run, budget))
    require_run(folder)
    try:
        results, damage = read_results(folder), None
    except Damaged as error:
        results, damage = {}, str(error)
    page = Page(title_of(folder, results), f"scarp run “{results.get('case', folder.name)}”")
    if damage:
        page.leave_out(damage)
    else:
        page.part(folder / "results.json", lambda: page.text(run_badge(results)))
    run_parts(page, folder, results, budget=budget)
    page.section("Machine, versions, numerics")
    page.part(folder / "results.json", machine_section, page, results)
    path = pathlib.Path(out or folder / "report.html")
    page.save(path)
    return path


def overall_page(out, folders):
    """One page over several runs: a table of all, then each."""
    runs = [(pathlib.Path(folder), read_results(folder)) for folder in folders]
    page = Page("scarp: results of %d runs" % len(runs))
    rows = []
    for folder, results in runs:
        name = results.get("case", folder.name)
        judged = [m["pass"] for m in results.get("measures", []) if m.get("pass") is not None]
        rows.append([run_badge(results),
                     Raw(f'<a href="#{_escaped(folder.name)}">{_escaped(name)}</a>'), results.get("title", ""),
                     f"{sum(judged)} of {len(judged)}" if judged else "", results.get("preset", ""),
                     results.get("particles"), results.get("steps"), results.get("wall_s"),
                     results.get("particle_steps_per_s")])
    page.table(["", "case", "title", "measures passed", "preset", "particles", "steps", "run time [s]",
                "particle-steps/s"], rows)
    for folder, results in runs:
        page.section(results.get("title") or folder.name, anchor=folder.name)
        run_parts(page, folder, results, level=3)
    page.section("Machine, versions")
    machine_section(page, {**(runs[0][1] if runs else {}), "numerics": {}})
    page.save(out)
    return pathlib.Path(out)


def main(arguments=None):
    parser = argparse.ArgumentParser(description="Figures and a page of one run, or a page of several.")
    parser.add_argument("folders", nargs="+", metavar="DIR", help="output folder of a run")
    parser.add_argument("--page", metavar="OUT.html", help="one page over all folders")
    parser.add_argument("--picture", metavar="MB", type=float, default=PICTURE_BYTES / 1e6,
                        help="megabytes that the moving picture of one run may take, 0 for none")
    parser.add_argument("--quiet", action="store_true", help="show no progress")
    options = parser.parse_args(arguments)
    Progress.quiet = options.quiet
    for folder in options.folders:
        if not pathlib.Path(folder).is_dir():
            sys.exit(f"scarp report: '{folder}' is no folder; give the output folder of a run.")
    if options.page:
        print(overall_page(options.page, options.folders))
    else:
        for folder in options.folders:
            print(report(folder, budget=1e6 * options.picture))


def in_words(work, source):
    """Calls work; whatever fails in it ends the program with a sentence and exit code 1."""
    try:
        work()
        sys.stdout.flush()
    except (Damaged, NoRun) as error:
        sys.exit(f"scarp report: {error}")
    except OSError as error:
        sys.exit(f"scarp report: '{error.filename or source}': {error.strerror or error}.")
    except Exception as error:  # from one file alone, such as fos.json
        sys.exit(f"scarp report: {cannot_be_shown(source, error)}")


if __name__ == "__main__":
    in_words(main, " ".join(sys.argv[1:]))
