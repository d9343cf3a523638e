# SPDX-License-Identifier: BSD-3-Clause
"""The page over all cases: verdicts, what fails, main figures, orders, error against run time, machine."""

import datetime
import html
import json
import pathlib

import claims_table
import error_time_page
import scarp_report as scarp

SETS = {"paper": "samples of the paper", "verification": "closed forms and experiments"}


def _judged(results):
    return [m for m in results.get("measures", []) if m.get("pass") is not None]


def _link(folder):
    return f"{folder.name}/report.html" if (folder / "report.html").exists() else f"{folder.name}/"


def _when(folder):
    return datetime.datetime.fromtimestamp((folder / "results.json").stat().st_mtime).strftime("%Y-%m-%d %H:%M")


def introduction(page, runs, with_error_time):
    passed = sum(scarp.verdict_of(results) is True for _, _, results in runs)
    measures = [m for _, _, results in runs for m in _judged(results)]
    failed = sum(m["pass"] is False for m in measures)
    page.text(scarp.badge(passed == len(runs), f"{passed} of {len(runs)} cases pass"))
    page.text(f"scarp computes slopes and granular masses that fail, by smoothed-particle hydrodynamics. It is judged on "
              f"{len(runs)} cases here: the paper's own samples, and problems whose answer is known from a closed form, "
              f"an independent method or a published experiment. Together they hold {len(measures)} numbers "
              f"against what is known; {len(measures) - failed} in their band, {failed} outside.")
    page.text("Each number has a band that was fixed with its reason before it was measured; the reason stands in the "
              "README of the case. A number outside its band fails its case. The short form of a case is coarse and "
              "checks that nothing has changed; the main form is the published one; the full form adds finer spacings.")
    if with_error_time:
        page.text("What a wanted error costs in run time stands near the end.")


def verdict_table(page, runs):
    rows = []
    for folder, entry, results in runs:
        judged = _judged(results)
        rows.append([scarp.run_badge(results),
                     scarp.Raw(f'<a href="{html.escape(_link(folder))}">{html.escape(folder.name)}</a>'),
                     entry.get("sentence") or results.get("title", ""), SETS.get(entry.get("set"), ""),
                     results.get("form", ""), sum(m["pass"] is True for m in judged),
                     sum(m["pass"] is False for m in judged), float(f"{results.get('wall_s') or 0:.3g}"), _when(folder)])
    page.table(["verdict", "case", "what it is", "held against", "form", "in band", "outside", "run time [s]", "run on"],
               [["" if cell is None else cell for cell in row] for row in rows])


def failing(page, runs):
    rows = []
    for folder, _, results in runs:
        if results.get("failure"):
            rows.append([folder.name, "the case did not reach its end", "", "", "", "", results["failure"]])
        rows += [[folder.name, m["name"], m["value"] if m["value"] is not None else "not a number", m.get("unit", ""),
                  "" if m.get("reference") is None else m["reference"], scarp.band(m.get("band")), m.get("source", "")]
                 for m in _judged(results) if m["pass"] is False]
    if not rows:
        page.text("None: every judged number lies in its band.")
        return
    page.table(["case", "measure", "value", "unit", "reference", "accepted", "source of the band"], rows)


def orders(page, runs):
    rows = []
    for folder, _, results in runs:
        for one in results.get("convergence", []):
            if len(one["spacing"]) < 2:
                continue
            errors = ", ".join("-" if e is None else f"{e:.3g}" for e in one["error"])
            rows.append([folder.name, one["quantity"], ", ".join(f"{h:g}" for h in one["spacing"]), errors,
                         "" if one.get("order") is None else f"{one['order']:.2f}"])
    if not rows:
        page.text("No case was run at two spacings or more; the main and full forms are.")
        return
    page.text("Slope of log error over log spacing. An error of the lattice moment, which the preset paper keeps, does not "
              "fall, and its order is near 0. The order of an error that is already tiny says nothing.")
    page.table(["case", "error of", "dx [m], coarse to fine", "error", "order"], rows)


def machines(page, runs):
    rows = {}
    for folder, _, results in runs:
        machine, versions = results.get("machine", {}), results.get("versions", {})
        if machine:
            key = (machine.get("processor", ""), results.get("isa", ""), results.get("threads", ""),
                   results.get("precision", ""), versions.get("scarp", ""), versions.get("compiler", ""))
            rows.setdefault(key, []).append(folder.name)
    page.table(["processor", "instruction set", "threads", "precision", "scarp", "compiler", "cases"],
               [[str(cell) for cell in key] + [", ".join(names)] for key, names in rows.items()])


def overview(folder):
    """Writes DIR/report.html over the cases named in DIR/cases.json that have run; returns its path."""
    folder = pathlib.Path(folder)
    entries = json.loads((folder / "cases.json").read_text(encoding="utf-8"))["cases"]
    runs = [(folder / entry["name"], entry, scarp.read_results(folder / entry["name"])) for entry in entries
            if (folder / entry["name"] / "results.json").exists()]
    error_time = folder / "error_time"
    with_error_time = (error_time / "error_time.json").exists()
    page = scarp.Page("scarp: is it right, and what does being right cost",
                      "All validation cases; each name leads to the page of its case.")
    introduction(page, runs, with_error_time)
    page.section("Verdicts")
    verdict_table(page, runs)
    page.section("What lies outside its band")
    failing(page, runs)
    claims = [dict(claim, case=one.name) for one, _, results in runs for claim in results.get("claims", [])]
    if claims:
        page.section("What the paper says, measured")
        claims_table.draw(page, claims)
    pictures = [(one / "figures" / "main.png", _link(one), f"{one.name}: {entry['sentence']}")
                for one, entry, _ in runs if (one / "figures" / "main.png").exists()]
    if pictures:
        page.section("What the cases look like")
        page.thumbnails(pictures)
    page.section("How errors fall with the spacing")
    orders(page, runs)
    if with_error_time:
        page.section("Error against run time")
        page.text(scarp.Raw('Medians of repeated runs that took turns; all settings, fronts and tables are on '
                            '<a href="error_time/report.html">a page of their own</a>.'))
        for _, study in error_time_page.studies(error_time):
            error_time_page.study_parts(page, study, level=3)
    page.section("Machine, versions")
    machines(page, runs)
    path = folder / "report.html"
    page.save(path)
    return path
