# SPDX-License-Identifier: BSD-3-Clause
"""HTML of the picture that moves: its data, and the script that engine/viewer makes of its sources and three.js."""

import base64
import html
import json
import os
import pathlib

from scarp_picture import run_picture

PICTURE_BYTES = 40e6  # that one may take, unless its reader says otherwise
MISSING = ("The moving picture is left out: scarp was built without it. It needs npm (Debian's nodejs and npm) and, once, a "
           "network; then build again.")


def script_file():
    """The script, or None where scarp was built without it: $SCARP_VIEWER, else beside this file."""
    path = pathlib.Path(os.environ.get("SCARP_VIEWER") or pathlib.Path(__file__).resolve().with_name("scarp_viewer.js"))
    return path if path.is_file() else None


def picture_element(index, blocks, css=""):
    """The element that the script makes a picture of."""
    words = json.dumps(index, separators=(",", ":"), ensure_ascii=False).replace("<", "\\u003c")
    parts = [f'<div class="scarp-picture{css}"><script type="application/json" data-index>{words}</script>']
    parts += [f'<script type="text/plain" data-block="{html.escape(name, quote=True)}">{base64.b64encode(block).decode()}</script>'
              for name, block in blocks.items()]
    return "\n".join(parts) + "</div>"


def script_element():
    return f'<script>{script_file().read_text(encoding="utf-8")}</script>'


def picture_page(title, element, script=None):
    """A page of its own that the picture fills."""
    return ('<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
            '<meta name="viewport" content="width=device-width,initial-scale=1">'
            f"<title>{html.escape(title)}</title><style>body{{margin:0}}</style></head><body>\n{element}\n{script or script_element()}\n"
            "</body></html>\n")


def moving_picture(page, folder, budget):
    """Adds the particles of a run to a scarp_page.Page, to turn, colour and play; or why they are not there."""
    if budget <= 0:
        return
    if script_file() is None:
        page.text(MISSING)
        return
    made = run_picture(folder, budget)
    if made is None:
        page.text("The run wrote no frames.")
    else:
        page.parts += [picture_element(*made), script_element()]
