# SPDX-License-Identifier: BSD-3-Clause
"""How many figures of a page are drawn, on standard error: a line that is drawn over on a terminal that can do so, else
plain lines every few seconds. The programs say where a run stands in the same way (engine/cli/progress_line.hpp)."""

import os
import shutil
import sys
import time

LEAST_COLUMNS = 60


class Progress:
    quiet = False  # of all pages

    def __init__(self):
        self.begin = self.last = time.monotonic()
        self.done = self.expected = 0
        self.drawn = False

    def expect(self, figures):
        """So many more figures than were expected before."""
        self.expected += figures

    def step(self):
        """One more figure is done."""
        self.done += 1
        now, bar = time.monotonic(), on_terminal()
        if self.quiet or now - self.last < (0.2 if bar else 5.0):
            return
        self.last = now
        words = f"figure {self.done} of {max(self.done, self.expected)}"
        left = (now - self.begin) / self.done * (self.expected - self.done)
        if left > 0:
            words += f"  {left:.0f} s left"
        print(f"\r\033[K{words}" if bar else words, end="" if bar else "\n", file=sys.stderr, flush=True)
        self.drawn = bar

    def end(self):
        if self.drawn:
            print(file=sys.stderr)
        self.drawn = False


def on_terminal():
    return (sys.stderr is not None and sys.stderr.isatty() and os.environ.get("TERM", "") not in ("", "dumb")
            and shutil.get_terminal_size().columns >= LEAST_COLUMNS)
