# SPDX-License-Identifier: BSD-3-Clause
"""fos, converge and element against the program, number by number. usage: studies_test.py PROGRAM"""
import json
import os
import signal
import threading
import time
import unittest

import common
import numpy as np
import scarp
from common import column, slope


class StudiesTest(common.TestCase):
    def test_a_factor_of_safety_is_that_of_the_program(self):
        options = dict(tolerance=0.3, window="1 s")
        self.program(slope(), "fos", "-q", "--threads", 1, "--tolerance", 0.3, "--window", "1 s", "-o", self.folder / "fos")
        theirs = json.loads((self.folder / "fos" / "fos.json").read_text())
        heard = []
        mine = scarp.fos(slope(), threads=1, progress=heard.append, **options)
        self.assertTrue(mine.complete)
        self.assertEqual(mine.factor, theirs["factor_of_safety"])
        self.assertEqual([trial["displacement"] for trial in theirs["trials"]], list(mine.trials["displacement"]))
        self.assertEqual(len(heard), len(theirs["trials"]))
        self.assertEqual(heard[-1]["reduction"], mine.trials["reduction"][-1])

    def test_ctrl_c_ends_a_search(self):
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        began = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            scarp.fos(slope("0.1 m"), threads=1)  # an hour
        # Looks take place every 0.1 s, a step of these 13,000 particles takes less; fifty times that for a busy machine.
        self.assertLess(time.monotonic() - began, 10.0)

    def test_what_cannot_be_searched(self):
        with self.assertRaisesRegex(scarp.SceneError, "two"):
            scarp.fos(column())
        for wrong in (dict(tolerance=0), dict(start=0.001), dict(start=2, to=1)):
            with self.assertRaises(ValueError):
                scarp.fos(slope(), **wrong)

    def test_errors_are_those_of_the_program(self):
        self.program(column(), "converge", "-q", "--threads", 1, "--spacings", "0.25 m,0.2 m,0.1 m", "-o", self.folder / "c")
        theirs = json.loads((self.folder / "c" / "converge.json").read_text())
        mine = scarp.converge(column(), [0.1, "20 cm", 0.25], threads=1)
        self.assert_same(mine.runs["spacing"], [0.25, 0.2, 0.1])
        self.assertEqual(list(mine.quantities["name"]), [row["name"] for row in theirs["quantities"]])
        for number, row in enumerate(theirs["quantities"]):
            for place, value in zip(("coarse", "middle", "fine"), row["values"]):
                self.assertEqual(mine.quantities[f"value_{place}"][number], value, row["name"])
        with self.assertRaises(ValueError):
            scarp.converge(column(), [0.1, 0.1, 0.2])

    def test_an_element_test_is_that_of_the_program(self):
        table = self.folder / "element.csv"
        printed = self.program(column(), "element", "--path", "triaxial", "--strain", 0.02, "--steps", 50,
                               "--confining", "50 kPa", "-o", table, "--json", "-")
        theirs = np.genfromtxt(table, delimiter=",", names=True, deletechars="")
        mine = scarp.element(column(), "triaxial", strain=0.02, steps=50, confining="50 kPa")
        for column_name, title in (("stress_yy", "stress_yy_[Pa]"), ("strain_xx", "strain_xx_[-]")):
            shown = [float(f"{value:.10g}") for value in mine.table[column_name]]  # tables have ten digits
            self.assert_same(shown, theirs[title])
        self.assertEqual(mine.table["sqrt_J2"][-1], json.loads(printed)["end"]["sqrt_J2"])
        self.assertGreater(mine.first_yield, 0)
        with self.assertRaisesRegex(ValueError, "Did you mean 'triaxial'"):
            scarp.element(column(), "triaxal")
        with self.assertRaises(scarp.SceneError):
            scarp.element(column(), "triaxial", material="sand")


if __name__ == "__main__":
    unittest.main()
