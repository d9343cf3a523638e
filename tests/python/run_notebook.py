# SPDX-License-Identifier: BSD-3-Clause
"""Runs the code cells of a notebook one after the other, without Jupyter. Fails if a cell does, if there is no picture, or if the
notebook holds outputs, which belong in no repository. usage: run_notebook.py NOTEBOOK"""
import ast
import json
import pathlib
import sys
import tempfile
import time

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

file = pathlib.Path(sys.argv[1]).resolve()
cells = [cell for cell in json.loads(file.read_text("utf-8"))["cells"] if cell["cell_type"] == "code"]
if any(cell["outputs"] or cell["execution_count"] for cell in cells):
    sys.exit(f"{file}: it holds outputs. Try: Kernel, Restart and Clear All Outputs.")

pictures = []
folder = tempfile.TemporaryDirectory()


def show():
    for number in plt.get_fignums():
        path = pathlib.Path(folder.name) / f"{len(pictures)}.png"
        plt.figure(number).savefig(path)
        pictures.append(path.stat().st_size)
        plt.close(number)


plt.show = show
names = {"__name__": "__main__"}
for number, cell in enumerate(cells):
    began = time.monotonic()
    tree = ast.parse("".join(cell["source"]), f"{file.name}, cell {number}")
    last = ast.Expression(tree.body.pop().value) if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, f"{file.name}, cell {number}", "exec"), names)
    if last is not None:
        value = eval(compile(last, f"{file.name}, cell {number}", "eval"), names)
        print(value)
        if hasattr(value, "_repr_html_"):  # which a notebook would show
            print(f"HTML of {len(value._repr_html_())} letters")
    print(f"-- cell {number}: {time.monotonic() - began:.1f} s", flush=True)
if not pictures:
    sys.exit(f"{file}: it draws no picture.")
