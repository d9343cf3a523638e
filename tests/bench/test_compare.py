# SPDX-License-Identifier: BSD-3-Clause
"""bench/compare on files made here."""
import importlib.machinery
import importlib.util
import json
import os
import stat
import sys
import tempfile
import unittest

path = sys.argv.pop(1)
loader = importlib.machinery.SourceFileLoader("compare", path)
compare = importlib.util.module_from_spec(importlib.util.spec_from_loader("compare", loader))
loader.exec_module(compare)


def benchmark_file(folder, name, runs):
    file = os.path.join(folder, name)
    rows = [{"name": n, "run_name": n, "run_type": "iteration", "real_time": t, "time_unit": u} for n, t, u in runs]
    rows.append({"name": "a_mean", "run_name": "a", "run_type": "aggregate", "real_time": 99.0, "time_unit": "ms"})
    with open(file, "w") as out:
        json.dump({"benchmarks": rows}, out)
    return file


class Compare(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def test_median_of_the_ratios_of_each_turn(self):
        # The machine slows down threefold between turns; each ratio is 0.5, 0.5, 0.8.
        before = compare.times_by_name(benchmark_file(
            self.folder.name, "a.json", [("a", 1.0, "ms"), ("a", 3.0, "ms"), ("a", 9.0, "ms")]))
        after = compare.times_by_name(benchmark_file(
            self.folder.name, "b.json", [("a", 500.0, "us"), ("a", 1.5, "ms"), ("a", 7.2, "ms"), ("b", 1.0, "ms")]))
        (name, median, low, high, count), = compare.table(before, after)
        self.assertEqual((name, count), ("a", 3))
        self.assertAlmostEqual(median, 0.5)
        self.assertAlmostEqual(low, 0.5)
        self.assertAlmostEqual(high, 0.65)

    def test_limit_decides_the_exit_code(self):
        a = benchmark_file(self.folder.name, "a.json", [("a", 1.0, "ms")])
        b = benchmark_file(self.folder.name, "b.json", [("a", 1.2, "ms")])
        self.assertEqual(compare.main([a, b, "--limit", "1.1"]), 1)
        self.assertEqual(compare.main([a, b, "--limit", "1.3"]), 0)

    def test_within_one_file(self):
        a = benchmark_file(self.folder.name, "a.json", [("base/real_time", 2.0, "ms"), ("other/real_time", 3.0, "ms")])
        self.assertEqual(compare.main(["--within", a, "base", "--limit", "1.4"]), 1)
        self.assertEqual(compare.main(["--within", a, "base", "--limit", "1.6"]), 0)
        with self.assertRaises(SystemExit):
            compare.main(["--within", a, "nothing"])

    def test_two_builds_take_turns(self):
        for build, time in (("one", 2.0), ("two", 1.0)):
            os.mkdir(os.path.join(self.folder.name, build))
            program = os.path.join(self.folder.name, build, "bench_x")
            text = json.dumps({"benchmarks": [{"name": "x", "real_time": time, "time_unit": "ms"}]})
            with open(program, "w") as out:
                out.write("#!/bin/sh\nfor a in \"$@\"; do case $a in --benchmark_out=*) "
                          f"echo '{text}' > ${{a#--benchmark_out=}};; esac; done\n")
            os.chmod(program, os.stat(program).st_mode | stat.S_IXUSR)
        builds = [os.path.join(self.folder.name, b) for b in ("one", "two")]
        times = compare.run_in_turns(builds, "bench_x", [], 3)
        (_, median, _, _, count), = compare.table(*times)
        self.assertEqual((median, count), (0.5, 3))


if __name__ == "__main__":
    unittest.main()
