# SPDX-License-Identifier: BSD-3-Clause
"""Line coverage of kernels/ and engine/ from gcov's counts.

usage: lines.py SOURCE_FOLDER BUILD_FOLDER [--missing: names the lines that were not run]

A line counts as run if any object ran it: headers are in many. Ends with 1 below 90 %."""
import collections
import json
import pathlib
import subprocess
import sys

WANTED = 0.90


def counts(source, build):
    """{file: {line: how often}} of the project's own files."""
    found = collections.defaultdict(collections.Counter)
    for data in sorted(build.rglob("*.gcda")):
        out = subprocess.run(["gcov", "--json-format", "--stdout", data], cwd=build, capture_output=True, text=True,
                             check=True).stdout
        for report in map(json.loads, filter(None, out.splitlines())):
            folder = pathlib.Path(report["current_working_directory"])
            for file in report["files"]:
                path = (folder / file["file"]).resolve()
                if not path.is_relative_to(source):
                    continue
                for line in file["lines"]:
                    found[str(path.relative_to(source))][line["line_number"]] += line["count"]
    return found


def main():
    source, build = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    files = {name: lines for name, lines in counts(source, build).items()
             if name.split("/")[0] in ("kernels", "engine") and not name.endswith("_reference.cpp")}
    folders = collections.defaultdict(lambda: [0, 0])
    for name, lines in sorted(files.items()):
        missing = sorted(number for number, count in lines.items() if count == 0)
        for folder in (str(pathlib.Path(name).parent), "in all"):
            folders[folder][0] += len(lines) - len(missing)
            folders[folder][1] += len(lines)
        if missing and "--missing" in sys.argv:
            print(f"{name}: {', '.join(map(str, missing))}")
    for folder, (run, lines) in folders.items():
        if folder != "in all":
            print(f"{folder:24} {run:6} of {lines:6} lines {100 * run / lines:6.1f} %")
    run, lines = folders["in all"]
    print(f"{'in all':24} {run:6} of {lines:6} lines {100 * run / max(lines, 1):6.1f} %")
    return 0 if lines and run >= WANTED * lines else 1


if __name__ == "__main__":
    sys.exit(main())
