# SPDX-License-Identifier: BSD-3-Clause
"""Exit codes, messages and files of the program.

Usage: cli_test.py PATH_OF_SCARP"""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import unittest

from scenes import COLUMN, SCENE, SLOPE

SCARP = sys.argv.pop(1)
FORMATS = pathlib.Path(__file__).resolve().parents[3] / "engine/output/FORMATS.md"

LARGE = """title = "Large"
dimension = {dimension}
gravity = {gravity}
spacing = {spacing}
[[material]]
name = "clay"
density = 2000.0
youngs_modulus = "100 MPa"
poisson_ratio = 0.3
cohesion = "10 kPa"
friction_angle = "20 deg"
[[body]]
material = "clay"
box = {{min = {zero}, max = {size}}}
[[wall]]
name = "box"
kind = "no_slip"
box = {{min = {zero}, max = {size}}}
[[stage]]
name = "short"
duration = "0.05 s"
[checkpoint]
every = "0.02 s"
"""


class CliTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        (self.folder / "block.toml").write_text(SCENE)

    def tearDown(self):
        self.temporary.cleanup()

    def scarp(self, *arguments):
        return subprocess.run([SCARP, *arguments], cwd=self.folder, capture_output=True, text=True,
                              timeout=100, check=False)

    def test_run_leaves_results_frames_and_tables(self):
        done = self.scarp("run", "block.toml", "--threads", "1", "--quiet")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        out = self.folder / "out" / "block"
        results = json.loads((out / "results.json").read_text())
        self.assertEqual((results["particles"], results["threads"]), (32, 1))
        for name in ("scene.toml", "history.csv", "walls.csv", "frames/soil.hdf.series", "frames/walls.hdf"):
            self.assertTrue((out / name).exists(), name)

    def test_spacing_preset_and_json_are_obeyed(self):
        done = self.scarp("run", "block.toml", "-o", "fine", "--spacing", "25 cm", "--preset", "paper",
                          "--json", "-", "--quiet")
        results = json.loads(done.stdout)
        self.assertEqual((results["particles"], results["spacing"], results["preset"]), (128, 0.25, "paper"))

    def test_soil_that_falls_out_is_told_before_counted_and_no_success(self):
        leak = SCENE.replace("[[-2, 0], [6, 0]]", "[[-2, 0], [2, 0]]").replace("duration = 0.04", "duration = 1.5")
        leak = leak.replace('model = "linear_elastic"', 'cohesion = 0\nfriction_angle = "30 deg"')
        (self.folder / "leak.toml").write_text(leak)
        told = "no wall lies below 16 of 32 particles (50 %), 2 m wide from (2.25, "
        self.assertIn(told, self.scarp("check", "leak.toml").stdout)
        done = self.scarp("run", "leak.toml", "-q")
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn(told, done.stderr)
        self.assertIn("The run goes on.", done.stderr)
        out = self.folder / "out" / "leak"
        results = json.loads((out / "results.json").read_text())
        lost = results["lost_soil"]
        self.assertGreater(lost["particles"], 4)
        self.assertEqual(lost["mass"], lost["particles"] * 2000 * 0.25)
        self.assertEqual((results["complete"], results["finished"], results["pass"]), (False, True, False))
        self.assertIn(f"{lost['particles']} of 32 particles", results["failure"])
        self.assertIn(results["failure"], done.stderr)
        rows = [row.split(",") for row in (out / "history.csv").read_text().splitlines()]
        self.assertEqual((rows[0][-1], rows[1][-1]), ("lost_particles", "0"))
        self.assertEqual(int(rows[-1][-1]), lost["particles"])
        again = self.scarp("resume", "out/leak")  # its end has been reached
        self.assertEqual(again.returncode, 4, again.stderr)
        self.assertIn("lost soil; there is nothing to go on with", again.stderr)

    def test_check_says_what_the_scene_is(self):
        done = self.scarp("check", "block.toml", "--json", "check.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in ("32 soil", "plane strain", "rock", "short", "memory", "time step",
                     "2000 kg/m3, which weigh 19.62 kN/m3"):
            self.assertIn(word, done.stdout)
        numbers = json.loads((self.folder / "check.json").read_text())
        self.assertEqual(numbers["particles"], 32)
        self.assertGreater(numbers["expected_steps"], 0)
        self.assertEqual((numbers["format"], numbers["version"]), ("scarp check", 1))
        pages = FORMATS.read_text().split("# What `scarp check --json` writes")[1]
        for key in numbers:
            self.assertIn(f"`{key}`", pages.split("\n# ")[0])
        self.assertFalse((self.folder / "out").exists())

    def peak_of(self, *arguments):
        """The most memory a command had in use [bytes]."""
        with subprocess.Popen([SCARP, *arguments], cwd=self.folder, stderr=subprocess.DEVNULL) as process:
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.returncode, 0)
        return 1024 * usage.ru_maxrss

    def test_check_tells_the_memory_of_a_run(self):
        """60 thousand particles with a frame, a checkpoint and a rebuild of the lists, in plane strain and 3D. Heaps
        differ by a few pages from run to run, and soil that moves has longer lists than soil at rest: 15 %."""
        for dimension, size, spacing in ((2, "[300, 200]", 1.0), (3, "[40, 40, 40]", 1.0)):
            scene = LARGE.format(dimension=dimension, size=size, spacing=spacing,
                                 gravity="[0, -9.81]" if dimension == 2 else "[0, 0, -9.81]",
                                 zero="[0, 0]" if dimension == 2 else "[0, 0, 0]")
            (self.folder / "large.toml").write_text(scene)
            self.scarp("check", "large.toml", "--threads", "1", "--json", "check.json")
            told = json.loads((self.folder / "check.json").read_text())
            peak = self.peak_of("run", "large.toml", "-o", f"run{dimension}", "--threads", "1", "-q")
            self.assertLess(abs(told["memory_bytes"] - peak), 0.15 * peak, (dimension, told["memory_bytes"], peak))
            run = self.folder / f"run{dimension}"
            frame = (run / "frames" / "soil_00000.hdf").stat().st_size
            self.assertLess(abs(told["frame_bytes"] - frame), 0.01 * frame)
            kept = sorted((run / "checkpoints").iterdir())[-1].stat().st_size
            self.assertLess(abs(told["checkpoint_bytes"] - kept), 0.01 * kept)

    def test_check_tells_of_frames_on_every_step(self):
        (self.folder / "often.toml").write_text(SCENE + "[output]\nevery = 1e-9\n")
        done = self.scarp("check", "often.toml", "--json", "check.json")
        numbers = json.loads((self.folder / "check.json").read_text())
        self.assertIn("a frame follows almost every step", done.stdout)
        self.assertGreaterEqual(numbers["expected_frames"], numbers["expected_steps"])

    def test_threads_are_bounded_by_the_cores(self):
        cores = len(os.sched_getaffinity(0))
        for threads in (cores + 1, 1000, 2147483647):
            done = self.scarp("run", "block.toml", "--threads", str(threads))
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"{threads} threads are more than the", done.stderr)
            self.assertFalse((self.folder / "out").exists())
        done = self.scarp("run", "block.toml", "--threads", "0")
        self.assertEqual(done.returncode, 2)
        self.assertIn("0 threads: there cannot be fewer than 1. Try 1, or leave it out for", done.stderr)
        done = subprocess.run([SCARP, "run", "block.toml", "-q", "--json", "-"], cwd=self.folder, capture_output=True,
                              text=True, timeout=100, check=False, env={**os.environ, "OMP_NUM_THREADS": "1000"})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("OMP_NUM_THREADS asks for 1000 threads", done.stderr)
        self.assertLessEqual(json.loads(done.stdout)["threads"], cores)

    def test_a_run_of_a_larger_machine_goes_on_with_the_cores_there_are(self):
        self.scarp("run", "block.toml", "-o", "run", "-q")
        record = self.folder / "run" / "run.json"
        self.assertIsNone(json.loads(record.read_text())["threads"])  # as many as make it faster
        for threads in (1000, -3, 2147483647):
            record.write_text(json.dumps({**json.loads(record.read_text()), "threads": threads}))
            (self.folder / "run" / "results.json").unlink()
            done = self.scarp("resume", "run", "-q")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(f"begun with {threads} threads", done.stderr)

    def test_a_run_of_seconds_is_forecast_to_the_step(self):
        (self.folder / "column.toml").write_text(COLUMN)
        done = self.scarp("check", "column.toml", "--costs", "--json", "check.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.scarp("run", "column.toml", "-o", "out", "--json", "run.json", "--quiet")
        check, run = (json.loads((self.folder / name).read_text()) for name in ("check.json", "run.json"))
        self.assertEqual(check["rehearsal_spacing"], check["spacing"])
        self.assertEqual((check["expected_steps"], check["expected_time_s"]), (run["steps"], run["simulated_s"]))
        self.assertEqual([cost["feature"] for cost in check["costs"]],
                         ["artificial viscosity", "force correction", "gradient correction", "sums in double precision"])
        for cost in check["costs"]:
            self.assertIn(cost["feature"], done.stdout)
            self.assertLess(cost["share_of_step"], 1)

    def test_a_stage_without_limit_is_forecast_by_a_rehearsal(self):
        (self.folder / "column.toml").write_text(COLUMN.replace('duration = "1 s"', 'until = "rest"'))
        done = self.scarp("check", "column.toml", "--json", "check.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("at most", done.stdout.split("materials")[0])
        self.scarp("run", "column.toml", "-o", "out", "--json", "run.json", "--quiet")
        check, run = (json.loads((self.folder / name).read_text()) for name in ("check.json", "run.json"))
        self.assertEqual((check["expected_steps"], check["expected_time_s"]), (run["steps"], run["simulated_s"]))

    RECKLESS = COLUMN.replace('duration = "1 s"', 'duration = "5 s"') + """
[numerics]
integrator = "verlet"
cfl = 1.5
"""

    def test_an_unstable_run_exits_3_and_says_what_happened(self):
        (self.folder / "reckless.toml").write_text(self.RECKLESS)
        done = self.scarp("run", "reckless.toml", "--quiet", "-o", "out")
        self.assertEqual(done.returncode, 3)
        for word in ("step ", "particle ", "Possible causes", "Try "):
            self.assertIn(word, done.stderr)
        results = json.loads((self.folder / "out" / "results.json").read_text())
        self.assertFalse(results["complete"])
        what = results["instability"]
        self.assertGreater(what["step"], 0)
        self.assertEqual(len(what["position"]), 3)

    def test_retry_goes_back_and_comes_to_the_end(self):
        (self.folder / "retry.toml").write_text(self.RECKLESS + "[run]\nretry = 3\n")
        done = self.scarp("run", "retry.toml", "--quiet", "-o", "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Retry 1 of 3: back to step", done.stderr)
        results = json.loads((self.folder / "out" / "results.json").read_text())
        self.assertTrue(results["complete"])
        self.assertEqual(results["retries"][0]["step_factor"], 0.5)
        self.assertIsNone(results["instability"])
        self.assertEqual(sum(results["step_limits"].values()), results["steps"])

    def test_probe_names_the_limit_and_the_margin(self):
        (self.folder / "column.toml").write_text(COLUMN)
        done = self.scarp("check", "column.toml", "--probe", "--json", "check.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in ("acoustic", "margin", "closed form", "run time"):
            self.assertIn(word, done.stdout)
        probe = json.loads((self.folder / "check.json").read_text())["probe"]
        self.assertEqual(probe["step_limits"]["acoustic"], 300)
        self.assertGreater(probe["margin"]["stable"], 1.0)
        self.assertLess(probe["margin"]["stable"], probe["acoustic_cfl_limit"])
        (self.folder / "reckless.toml").write_text(self.RECKLESS)
        done = self.scarp("check", "reckless.toml", "--probe")
        self.assertEqual(done.returncode, 3)
        self.assertIn("UNSTABLE at cfl = 1.5", done.stdout)

    def test_check_of_a_scene_with_millions_of_particles_measures_on_a_coarser_lattice(self):
        (self.folder / "long.toml").write_text(SCENE.replace("[[0, 0], [4, 0], [4, 2], [0, 2]]",
                                                             "[[0, 0], [4, 0], [1e6, 2], [0, 2]]"))
        done = self.scarp("check", "long.toml", "--json", "check.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("measured          at a spacing of", done.stdout)
        numbers = json.loads((self.folder / "check.json").read_text())
        # Half of length times height over the square of the spacing.
        self.assertAlmostEqual(numbers["particles"], 4.0e6, delta=4e4)
        self.assertEqual(numbers["spacing"], 0.5)
        self.assertGreater(numbers["measured_at_spacing"], 1.5)

    def test_check_and_results_say_which_particle_a_probe_follows(self):
        (self.folder / "column.toml").write_text(COLUMN.replace('duration = "1 s"', 'duration = "10 ms"'))
        done = self.scarp("check", "column.toml", "--json", "check.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("a tie of 2, decided by rule", done.stdout)
        self.scarp("run", "column.toml", "-o", "out", "--quiet")
        check, run = (json.loads((self.folder / name).read_text()) for name in ("check.json", "out/results.json"))
        self.assertEqual(check["probes"], run["probes"])
        probe = run["probes"][0]
        # The soil is symmetric: of the two the one with the lower x.
        self.assertEqual((probe["name"], probe["start"], probe["tied"]), ("top", [0.4375, 3.9375, 0.0], 2))
        (self.folder / "far.toml").write_text(COLUMN.replace("at = [0.5, 4]", "at = [0.5, 5]"))
        done = self.scarp("check", "far.toml")
        self.assertEqual(done.returncode, 1)
        self.assertIn("more than two spacings", done.stderr)

    def test_grains_beyond_the_reach_of_mixed_precision_end_a_run_as_others_do(self):
        far = SCENE.replace('[[wall]]', """velocity = [-400, 0]
[[body]]
material = "rock"
box = {min = [1210, 0], max = [1214, 2]}
[[wall]]""").replace("duration = 0.04", "duration = 1").replace("gravity = [0.0, -9.81]", "gravity = [0, 0]")
        (self.folder / "far.toml").write_text(far.replace("[[material]]", '[numerics]\nprecision = "mixed"\n[[material]]', 1))
        done = self.scarp("run", "far.toml", "--quiet", "-o", "out")
        self.assertEqual(done.returncode, 3, done.stderr)
        results = json.loads((self.folder / "out" / "results.json").read_text())
        self.assertFalse(results["complete"])
        self.assertEqual(results["instability"]["field"], "distance from other soil")

    def test_errors_of_the_scene_exit_1_and_name_it(self):
        (self.folder / "bad.toml").write_text(SCENE.replace("0.3", "0.7"))
        for scene in ("missing.toml", "bad.toml"):
            done = self.scarp("run", scene)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertIn(scene, done.stderr)

    def test_a_scene_that_cannot_be_run_leaves_nothing(self):
        for change in (("0.3", "0.7"), ("spacing = 0.5", "spacing = 1e-6"), ("[[-2, 0], [6, 0]]", "[[6, 0], [-2, 0]]"),
                       ('name = "short"', 'name = "../../short"')):
            (self.folder / "bad.toml").write_text(SCENE.replace(*change))
            before = sorted(self.folder.rglob("*"))
            done = self.scarp("run", "bad.toml")
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertRegex(done.stderr, r"bad\.toml:\d+: key '.*' = .*: .* Try ")
            self.assertEqual(sorted(self.folder.rglob("*")), before)

    def test_a_run_writes_in_its_folder_only(self):
        before = set(self.folder.iterdir())
        self.assertEqual(self.scarp("run", "block.toml", "-o", "here", "--quiet").returncode, 0)
        self.assertEqual(set(self.folder.iterdir()) - before, {self.folder / "here"})

    def test_bad_usage_exits_2(self):
        for arguments in ([], ["run"], ["fly"], ["run", "block.toml", "--isa", "mmx"],
                          ["run", "block.toml", "--spacing", "1 kg"], ["report", "nowhere"]):
            self.assertEqual(self.scarp(*arguments).returncode, 2, arguments)

    def test_values_that_are_not_above_0_or_empty_are_not_ignored(self):
        for command, option, value, words in (("run", "--spacing", "0", "not above 0"),
                                              ("check", "--spacing", "-1 m", "not above 0"),
                                              ("check", "--spacing", "nan m", "not a finite number"),
                                              ("fos", "--spacing", "0 cm", "not above 0"),
                                              ("check", "--spacing", "0,5", 'decimal point, "0.5 m"'),
                                              ("check", "--spacing", "", "empty"),
                                              ("run", "--out", "", "empty"), ("check", "--json", "", "empty")):
            done = self.scarp(command, "block.toml", option, value)
            self.assertEqual((done.returncode, done.stdout), (2, ""), (option, value))
            self.assertIn(option, done.stderr)
            self.assertIn(words, done.stderr)

    def test_help_and_version_exit_0(self):
        for arguments in (["--help"], ["run", "--help"], ["--version"]):
            self.assertEqual(self.scarp(*arguments).returncode, 0, arguments)

    def test_converge_estimates_errors_and_resumes(self):
        # A column between smooth sides under its weight: the force on its base is the weight at every
        # spacing, and its top settles by about rho g H^2/(2 M), whatever the spacing, within a few per cent.
        (self.folder / "column.toml").write_text(COLUMN)
        arguments = ["converge", "column.toml", "--threads", "1", "--json", "-"]
        done = self.scarp(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("expected run time", done.stderr)
        study = json.loads(done.stdout)
        self.assertEqual([run["spacing"] for run in study["runs"]], [0.5, 0.25, 0.125])
        self.assertEqual([run["particles"] for run in study["runs"]], [16, 64, 256])
        quantities = {q["name"]: q for q in study["quantities"]}
        for value in quantities["box.force_y"]["values"]:
            self.assertAlmostEqual(value / (-2000 * 9.81 * 4), 1.0, delta=1e-3)  # rest: see the damping
        modulus = 10e6 * 0.7 / (1.3 * 0.4)
        settlement = 2000 * 9.81 * 4**2 / (2 * modulus)
        for value in quantities["top.displacement"]["values"]:
            self.assertAlmostEqual(value / settlement, 1.0, delta=0.05)
        self.assertLess(quantities["top.displacement"]["errors"][2], 0.05)
        self.assertEqual([a["target"] for a in study["advice"]], [0.05, 0.02])
        out = self.folder / "out" / "column_converge"
        self.assertEqual(json.loads((out / "converge.json").read_text()), study)
        self.assertEqual(len((out / "converge.csv").read_text().splitlines()), 1 + len(quantities))
        self.assertIn("data:image/png", (out / "report.html").read_text())

        (out / "dx_0.25" / "results.json").unlink()  # as if killed: this one is run again, the others are not
        again = json.loads(self.scarp(*arguments).stdout)
        self.assertEqual([run["reused"] for run in again["runs"]], [True, False, True])
        self.assertEqual([q["values"] for q in again["quantities"]], [q["values"] for q in study["quantities"]])
        (self.folder / "column.toml").write_text(COLUMN + "# another text\n")
        self.assertEqual([run["reused"] for run in json.loads(self.scarp(*arguments).stdout)["runs"]], [False] * 3)

    def test_converge_takes_its_spacings_and_refuses_bad_ones(self):
        (self.folder / "column.toml").write_text(COLUMN)
        done = self.scarp("converge", "column.toml", "--spacings", "25 cm, 0.5, 1 m", "-o", "three", "--quiet")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue((self.folder / "three" / "dx_1" / "results.json").exists())
        self.assertIn("For 5 %", done.stdout)
        for spacings in ("1,0.5", "1,1,0.5", "1,0.5,0", "1,0.5,1 kg"):
            self.assertEqual(self.scarp("converge", "column.toml", "--spacings", spacings).returncode, 2, spacings)

    def test_fos_finds_a_factor_and_shows_the_failure(self):
        (self.folder / "slope.toml").write_text(SLOPE)
        done = self.scarp("fos", "slope.toml", "--threads", "1", "--from", "1.2", "--to", "1.6", "--tolerance", "0.05",
                          "--json", "-")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("SRF 1.2 stands", done.stderr)
        study = json.loads(done.stdout)
        # Bishop: 1.377; ten spacings in the height are good for no better than ten per cent.
        self.assertAlmostEqual(study["factor_of_safety"], 1.377, delta=0.138)
        self.assertLess(study["stands"], study["fails"])
        self.assertEqual((study["complete"], study["failure"]), (True, None))
        criterion = study["criterion"]
        self.assertAlmostEqual(criterion["height"], 10.0, places=6)
        self.assertAlmostEqual(criterion["limit"], 0.1, places=8)
        self.assertEqual(criterion["probe"], "crest")
        self.assertIn("10 spacings high", study["resolution"])
        self.assertEqual([t["reduction"] for t in study["trials"][:2]], [1.2, 1.6])
        for trial in study["trials"]:
            self.assertEqual(trial["fails"], trial["displacement"] > criterion["limit"] + criterion["elastic"])
        out = self.folder / "out" / "slope_fos"
        self.assertEqual(json.loads((out / "fos.json").read_text()), study)
        self.assertEqual(len((out / "fos.csv").read_text().splitlines()), 1 + len(study["trials"]))
        self.assertTrue((out / "failure" / "frames" / "soil.hdf.series").exists())
        self.assertEqual(json.loads((out / "failure" / "results.json").read_text())["complete"], True)
        self.assertTrue((out / "figures" / "failure_accumulated_plastic_strain.png").exists())
        self.assertIn("Factor of safety 1.", (out / "report.html").read_text())

    def test_fos_says_what_it_cannot_use(self):
        (self.folder / "slope.toml").write_text(SLOPE)
        for arguments, word in ((["--probe", "crset"], "'crest'"), (["--from", "1.5", "--to", "1.2"], "--to"),
                                (["--height", "1 kg"], "--height"), (["--height", "-1"], "--height"),
                                (["--window", "0 s"], "--window"), (["--ramp", "-1 s"], "--ramp"),
                                (["--tolerance", "0"], "--tolerance"), (["--from", "1e6"], "--from")):
            done = self.scarp("fos", "slope.toml", *arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""), arguments)
            self.assertIn(word, done.stderr)
        for scene, old, new, word in (("missing.toml", "", "", "missing.toml"),
                                      ("unsettled.toml", 'until = "rest"\n', "", 'until = "rest"'),
                                      ("level.toml", "[45, 5], [32, 5], [12, 15], [0, 15]", "[45, 5], [0, 5]", "--height")):
            if old:
                (self.folder / scene).write_text(SLOPE.replace(old, new))
            done = self.scarp("fos", scene, "-q")
            self.assertEqual((done.returncode, done.stdout), (1, ""), scene)
            self.assertIn(scene, done.stderr)
            self.assertIn(word, done.stderr)
        one = self.scarp("fos", "block.toml")
        self.assertEqual(one.returncode, 1)
        self.assertIn("needs two", one.stderr)

    def test_fos_strengthens_a_slope_that_fails_by_itself_and_says_so(self):
        weak = SLOPE.replace('"10 kPa"', '"6.25 kPa"').replace('"20 deg"', '"12.8 deg"').replace('"9 deg"', "0")
        (self.folder / "weak.toml").write_text(weak)
        done = self.scarp("fos", "weak.toml", "--threads", "1", "--from", "0.8", "--to", "1", "--tolerance", "0.3",
                          "--json", "-")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("once more from the start, with 2 times the scene's", done.stderr)
        study = json.loads(done.stdout)
        self.assertEqual(study["settle"]["strengthening"], 2)
        # Bishop: 1.377/1.6, and no better than ten per cent at ten spacings, 15 at this tolerance.
        self.assertAlmostEqual(study["factor_of_safety"], 1.377 / 1.6, delta=0.25 * 1.377 / 1.6)
        self.assertTrue(any("2 times that strength" in note for note in study["notes"]), study["notes"])
        self.assertTrue(any("Here psi = phi could give up to" in note for note in study["notes"]), study["notes"])
        check = json.loads(self.scarp("check", "weak.toml", "--json", "-").stdout)
        self.assertTrue(any("5 to 11 %" in note for note in check["notes"]), check["notes"])

    def test_fos_interrupted_leaves_what_is_known(self):
        (self.folder / "slope.toml").write_text(SLOPE)
        with subprocess.Popen([SCARP, "fos", "slope.toml", "--spacing", "0.25", "--threads", "1"], cwd=self.folder,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
            for line in process.stderr:
                if line.startswith("SRF 1 stands"):
                    process.send_signal(signal.SIGINT)
                    break
            process.stderr.read()
            self.assertEqual(process.wait(60), 130)
        study = json.loads((self.folder / "out" / "slope_fos" / "fos.json").read_text())
        self.assertEqual((study["complete"], study["stands"], study["fails"]), (False, 1.0, None))

    def test_element_leaves_a_table_and_a_summary(self):
        done = self.scarp("element", "block.toml", "--path", "triaxial", "--strain", "0.001", "--steps", "10",
                          "--confining", "50 kPa", "--json", "-")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        end = json.loads(done.stdout)["end"]
        # sigma = -p - E eps, held to 1e-9 of the stress
        self.assertAlmostEqual(end["stress"][1], -60e3, delta=0.1)
        self.assertAlmostEqual(end["strain"][0], 0.3e-3, delta=1e-8)
        rows = (self.folder / "out" / "block" / "element_triaxial.csv").read_text().splitlines()
        self.assertEqual(len(rows), 12)
        self.assertTrue(rows[0].startswith("step,strain_xx [-]"))
        self.assertNotIn("yield_function", rows[0])

    def test_element_gives_the_numbers_of_the_cone_and_the_dilation_that_fit(self):
        sand = SCENE.replace('model = "linear_elastic"', 'cohesion = 0\nfriction_angle = "30 deg"')
        (self.folder / "sand.toml").write_text(sand)
        # Under p = 100 kPa in triaxial compression q = 3 sqrt(3) a p/(1 - sqrt(3) a): 115.1 kPa with the cone of E11,
        # a = 0.16013, and 200 kPa, which is (K_p - 1) p, with "outer", whatever psi is.
        test = json.loads(self.scarp("element", "sand.toml", "--path", "triaxial", "--json", "-").stdout)
        self.assertAlmostEqual(test["deviator"], 115.14e3, delta=50)
        self.assertEqual(len(test["notes"]), 2)
        self.assertIn('"plane_strain", the default in 2D', test["notes"][0])
        self.assertIn('with "outer", which does, the test ends at q = 200 kPa', test["notes"][0])
        self.assertIn("psi = phi the test ends at q = 115.1 kPa", test["notes"][1])
        said = self.scarp("element", "sand.toml", "--path", "plane_strain").stdout
        self.assertEqual(said.count("note: "), 1)  # the cone fits, psi is 0

    def test_element_says_what_it_cannot_use(self):
        for arguments, word in ((["--path", "oedometer"], "--path"), ([], "--path"),
                                (["--path", "triaxial", "--material", "rok"], "rock"),
                                (["--path", "triaxial", "--confining", "1 m"], "--confining"),
                                (["--path", "triaxial", "--steps", "0"], "--steps")):
            done = self.scarp("element", "block.toml", *arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""), arguments)
            self.assertIn(word, done.stderr)
        self.assertEqual(self.scarp("element", "missing.toml", "--path", "triaxial").returncode, 1)

    def test_report_draws_a_run(self):
        self.scarp("run", "block.toml", "--quiet", "-o", "block")
        done = self.scarp("report", "block")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("data:image/png", (self.folder / "block" / "report.html").read_text())


if __name__ == "__main__":
    unittest.main()
