# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the repository as a site that works without a network: the target `site` makes it."""

import pathlib
import re

from pygments.lexers.special import TextLexer

ROOT = pathlib.Path(__file__).resolve().parents[2]

project = "scarp"
author = "the scarp authors"
release = re.search(r"project\(scarp VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text()).group(1)
html_title = f"scarp {release}"

extensions = ["myst_parser"]
source_suffix = {".md": "markdown"}
root_doc = "README"
include_patterns = ["*.md"] + [f"{folder}/{depth}*.md" for folder in ("engine", "kernels", "validation", "bench")
                               for depth in ("", "**/")]
exclude_patterns = ["build", "out"]  # not even looked into
myst_heading_anchors = 3

html_theme = "furo"
html_copy_source = False
html_show_sourcelink = False
templates_path = ["."]
html_additional_pages = {"index": "to_start.html"}

CONTENTS = {
    "First steps": ["README", "engine/TUTORIAL", "engine/CHOOSING"],
    "Reference": ["engine/MANUAL", "engine/scene/SCENE", "engine/output/FORMATS", "engine/GLOSSARY"],
    "Theory": ["engine/THEORY", "kernels/EQUATIONS"],
    "Verification": ["validation/README"],
    "Programs": ["engine/python/README", "engine/LIBRARY", "engine/distributed/README"],
    "Developers": ["engine/DEVELOPERS", "bench/README", "bench/peers/README", "CHANGELOG"],
}


def toctree(caption, pages):
    """Hidden on the page, shown beside all of them."""
    options = f":hidden:\n:caption: {caption}\n:maxdepth: 1\n"
    entries = ["Start <self>" if page == root_doc else f"/{page}" for page in pages]
    return "\n```{toctree}\n" + options + "\n" + "\n".join(entries) + "\n```\n"


def add_contents(app, page, source):
    """The pages' order, which a page that is read without the site does not need."""
    if page == root_doc:
        source[0] += "".join(toctree(caption, pages) for caption, pages in CONTENTS.items())
    if page == "validation/README":
        cases = sorted(path.parent.name for path in (ROOT / "validation/cases").glob("*/README.md"))
        source[0] += toctree("Cases", [f"validation/cases/{case}/README" for case in cases])


def folder_as_text(app, environment, node, text):
    """Folders, which pages link to for readers of the repository, are no pages: their name stays."""
    place = (ROOT / node.get("refdoc", "")).parent / node.get("reftarget", "")
    return text if place.is_dir() else None


class Plain(TextLexer):
    """Flow charts are shown as they are written: what draws them would come from the network."""
    aliases = ["mermaid"]


def setup(app):
    app.connect("source-read", add_contents)
    app.connect("missing-reference", folder_as_text)
    app.add_lexer("mermaid", Plain)
    return {"parallel_read_safe": True}
