# SPDX-License-Identifier: BSD-3-Clause
"""A self-contained HTML page of sections with text, tables, verdicts and figures."""

import base64
import html
import io
import pathlib
import sys

from scarp_frames import Damaged
from scarp_progress import Progress

STYLE = """
body{font:15px/1.45 "DejaVu Sans","Segoe UI",Helvetica,Arial,sans-serif;color:#1a1a1a;background:#fff;
max-width:1060px;margin:2em auto;padding:0 1.2em}
h1{font-size:1.6em;margin:0 0 .2em}h2{font-size:1.2em;margin:2em 0 .6em;border-bottom:1px solid #ccc;padding-bottom:.2em}
h3{font-size:1em;margin:1.4em 0 .4em}p{margin:.4em 0}p.lead{color:#555}
table{border-collapse:collapse;font-size:.88em;margin:.6em 0}
th{text-align:left;font-weight:600;border-bottom:1.5px solid #333;padding:.3em .9em .3em 0;vertical-align:bottom}
td{border-bottom:1px solid #e3e3e3;padding:.28em .9em .28em 0;vertical-align:top}
td.number{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}th.number{text-align:right}
figure{margin:1em 0}figure img{max-width:100%;height:auto;display:block}
figcaption{font-size:.86em;color:#444;margin-top:.3em}
.badge{display:inline-block;padding:.05em .6em;border-radius:.8em;font-size:.85em;font-weight:600;white-space:nowrap;
border:1px solid;print-color-adjust:exact;-webkit-print-color-adjust:exact}
.pass{color:#0b5d2a;background:#e2f4e8;border-color:#7fc29a}.fail{color:#8c1010;background:#fde6e4;border-color:#e08a84}
.reported{color:#444;background:#f0f0f0;border-color:#bbb}
.thumbnails{display:grid;grid-template-columns:repeat(auto-fill,minmax(300px,1fr));gap:1em}
.thumbnails figure{margin:0}.thumbnails img{height:200px;width:100%;object-fit:contain;object-position:left top}
.problem{border-left:4px solid #c62828;padding:.4em 1em;background:#fdf3f2}
.scroll{overflow-x:auto}
@media print{body{margin:0;max-width:none;font-size:11px}figure,tr{break-inside:avoid}h2,h3{break-after:avoid}}
"""

WORDS = {True: ("pass", "✓ pass"), False: ("fail", "✗ fail"), None: ("reported", "reported")}


def number(value):
    """Four significant digits; whole numbers in full."""
    if value is None:
        return ""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return str(value)
    if float(value).is_integer() and abs(value) < 1e15 and (isinstance(value, int) or abs(value) < 1e4):
        return f"{int(value):,}".replace(",", "\u202f")
    return f"{value:,.4g}".replace(",", "\u202f")


def band(value):
    """A band as results.json may hold it: [low, high], {"min", "max"}, a half width, or words."""
    if isinstance(value, dict):
        value = [value.get("min", value.get("low")), value.get("max", value.get("high"))]
    if isinstance(value, (list, tuple)) and len(value) == 2:
        low, high = value
        if low is None or high is None:
            return f"≥ {number(low)}" if high is None else f"≤ {number(high)}"
        return f"{number(low)} … {number(high)}"
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return f"± {number(value)}"
    return "" if value is None else str(value)


class Raw(str):
    """HTML that is meant as such; every other text is escaped."""


def cannot_be_shown(source, error):
    words = " ".join(str(error).split())[:200]
    return f"'{source}': cannot be shown ({type(error).__name__}: {words}); it is damaged or of another version."


def badge(verdict, words=None):
    css, default = WORDS[verdict]
    return Raw(f'<span class="badge {css}">{html.escape(words or default)}</span>')


def _cell(value, tag="td"):
    if isinstance(value, Raw):
        return f"<{tag}>{value}</{tag}>"
    numeric = isinstance(value, (int, float)) and not isinstance(value, bool)
    return f"<{tag}{' class=number' if numeric else ''}>{html.escape(number(value))}</{tag}>"


def _without_margins(png):
    """The PNG without the wide empty margins that 3D axes leave."""
    from PIL import Image, ImageChops
    image = Image.open(png).convert("RGB")
    left, top, right, bottom = ImageChops.invert(image).getbbox() or (0, 0, *image.size)
    margin, cropped = 12, io.BytesIO()
    image.crop((max(left - margin, 0), max(top - margin, 0), min(right + margin, image.width),
                min(bottom + margin, image.height))).save(cropped, format="png")
    return cropped


def _small(png, size=(700, 460)):
    """The PNG scaled down to fit, sharp at twice the size it is shown in."""
    from PIL import Image
    image = Image.open(io.BytesIO(png)).convert("RGB")
    image.thumbnail(size, Image.LANCZOS)
    scaled = io.BytesIO()
    image.save(scaled, format="png", optimize=True)
    return scaled.getvalue()


class Page:
    """Collects the parts; `save` writes one file that needs no other."""

    def __init__(self, title, lead=""):
        self.title, self.parts = title, [f"<h1>{html.escape(title)}</h1>"]
        self.images = []  # bytes of the PNG figures, in order
        self.left_out = []  # sentences about what could not be shown
        self.progress = Progress()
        if lead:
            self.parts.append(f'<p class="lead">{html.escape(lead)}</p>')

    def part(self, source, draw, *arguments):
        """Calls draw(*arguments); what fails in it is left out, with a sentence on the page that names the file."""
        try:
            return draw(*arguments)
        except Exception as error:  # a damaged file brings out every kind
            import matplotlib.pyplot as plt
            plt.close("all")
            self.leave_out(str(error) if isinstance(error, Damaged) else cannot_be_shown(source, error))
            return None

    def leave_out(self, words):
        self.left_out.append(words)
        self.text(f"Left out: {words}", problem=True)

    def section(self, title, anchor=None, level=2):
        name = f' id="{html.escape(anchor, quote=True)}"' if anchor else ""
        self.parts.append(f"<h{level}{name}>{html.escape(title)}</h{level}>")

    def text(self, text, problem=False):
        css = ' class="problem"' if problem else ""
        body = text if isinstance(text, Raw) else html.escape(text).replace("\n", "<br>")
        self.parts.append(f"<p{css}>{body}</p>")

    def table(self, header, rows):
        rows = [list(row) for row in rows]
        numeric = [any(isinstance(row[c], (int, float)) and not isinstance(row[c], bool) for row in rows)
                   for c in range(len(header))]
        head = "".join(f"<th{' class=number' if n else ''}>{html.escape(h)}</th>"
                       for h, n in zip(header, numeric))
        body = "".join("<tr>" + "".join(_cell(v) for v in row) + "</tr>\n" for row in rows)
        thead = f"<thead><tr>{head}</tr></thead>" if any(header) else ""
        self.parts.append(f'<div class="scroll"><table>{thead}<tbody>{body}</tbody></table></div>')

    def verdicts(self, measures):
        """The table of measures: failed ones first, then passed, then those only reported."""
        order = {False: 0, True: 1, None: 2}
        measures = sorted(measures, key=lambda m: order[m.get("pass")])
        judged = any(m.get("pass") is not None or m.get("reference") is not None for m in measures)
        if judged:
            self.table(["verdict", "measure", "value", "unit", "reference", "accepted", "source"],
                       [[badge(m.get("pass")), m.get("name", ""), m.get("value"), m.get("unit", ""),
                         m.get("reference"), band(m.get("band")), m.get("source", "")] for m in measures])
        else:
            self.table(["measure", "value", "unit"],
                       [[m.get("name", ""), m.get("value"), m.get("unit", "")] for m in measures])

    def picture(self, path, caption=""):
        """An SVG, PNG or JPEG file, inlined."""
        path = pathlib.Path(path)
        kind = {".svg": "svg+xml", ".png": "png", ".jpg": "jpeg", ".jpeg": "jpeg"}[path.suffix.lower()]
        self._image(path.read_bytes(), kind, caption)

    def figure(self, figure, caption="", file=None):
        """A matplotlib figure, inlined as PNG, closed, and kept as `file` if that is given."""
        import matplotlib.pyplot as plt
        data = io.BytesIO()
        figure.savefig(data, format="png")
        if any(ax.name == "3d" for ax in figure.axes):
            data = _without_margins(data)
        plt.close(figure)
        if file is not None:
            pathlib.Path(file).parent.mkdir(parents=True, exist_ok=True)
            pathlib.Path(file).write_bytes(data.getvalue())
        self._image(data.getvalue(), "png", caption)
        self.progress.step()

    def thumbnails(self, items):
        """Small pictures side by side, each (PNG file, link, caption)."""
        cells = []
        for path, link, caption in items:
            code = base64.b64encode(_small(pathlib.Path(path).read_bytes())).decode()
            caption = html.escape(caption)
            cells.append(f'<figure><a href="{html.escape(link, quote=True)}"><img alt="{caption}" '
                         f'src="data:image/png;base64,{code}"></a><figcaption>{caption}</figcaption></figure>')
        self.parts.append(f'<div class="thumbnails">{"".join(cells)}</div>')

    def _image(self, data, kind, caption):
        if kind == "png":
            self.images.append(data)
        code = base64.b64encode(data).decode()
        caption = html.escape(caption)
        self.parts.append(f'<figure><img alt="{caption}" src="data:image/{kind};base64,{code}">'
                          f"<figcaption>{caption}</figcaption></figure>")

    def save(self, path):
        """Writes the page; what it leaves out is said on standard error too."""
        self.progress.end()
        path = pathlib.Path(path)
        path.parent.mkdir(parents=True, exist_ok=True)
        part = path.with_name(path.name + ".part")
        part.unlink(missing_ok=True)  # a link would lead elsewhere
        part.write_text('<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
                        '<meta name="viewport" content="width=device-width,initial-scale=1">'
                        f"<title>{html.escape(self.title)}</title><style>{STYLE}</style></head><body>\n"
                        + "\n".join(self.parts) + "\n</body></html>\n", encoding="utf-8")
        part.replace(path)
        for words in self.left_out:
            print(f"scarp report: left out: {words}", file=sys.stderr)
