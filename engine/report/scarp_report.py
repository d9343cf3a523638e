#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws a run: `scarp_report.py DIR` makes DIR/report.html and DIR/figures; with `--page OUT.html DIR...` one
page over several runs. The functions of the modules beside it can be imported from here."""

import argparse
import html
import pathlib
import signal
import sys

if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.SIG_DFL)  # ends like any program, without a traceback
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
try:
    from scarp_figures import *  # noqa: F401,F403
    from scarp_frames import *  # noqa: F401,F403
    from scarp_frames import Damaged, read_results
    from scarp_converge import converge_page
    from scarp_histories import history_figures
    from scarp_fos import fos_page
    from scarp_page import Page, Raw, badge, band, cannot_be_shown  # noqa: F401
    from scarp_particles import figure_height, particle_figures  # noqa: F401
    from scarp_progress import Progress
    from scarp_sections import (facts_section, machine_section, own_figures, profile_section, run_badge,
                                step_limits_section, verdict_of, verdict_section)  # noqa: F401
    from scarp_viewer import PICTURE_BYTES, moving_picture
except ImportError as error:
    sys.exit(f"scarp report: {error}; install Debian's python3-matplotlib and python3-h5py.")


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
                     Raw(f'<a href="#{html.escape(folder.name)}">{html.escape(str(name))}</a>'), results.get("title", ""),
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
