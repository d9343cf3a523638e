# SPDX-License-Identifier: BSD-3-Clause
"""What the commands do in folders that hold something already: nothing of worth goes without a word, nothing of an
earlier run passes for a new one.

Usage: folders_test.py PATH_OF_SCARP [TEST...]"""

import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from scenes import SLOPE

SCARP = sys.argv.pop(1)

BLOCK = """title = "Block"
dimension = 2
spacing = 0.5
[[material]]
name = "rock"
model = "linear_elastic"
density = 2000.0
youngs_modulus = "10 MPa"
poisson_ratio = 0.3
[[body]]
material = "rock"
polygon = [[0, 0], [4, 0], [4, 2], [0, 2]]
[[wall]]
name = "base"
kind = "no_slip"
line = [[-2, 0], [6, 0]]
[[probe]]
name = "top"
at = [2, 2]
[output]
energy = true
every = "10 ms"
[checkpoint]
every = "5 ms"
[[stage]]
name = "short"
duration = 0.04
"""

# Results of every kind by their names, one for each command and an unknown one.
STUDY = ["converge.json", "converge.csv", "report.html", "figures/error_time.png", "dx_0.5/results.json",
         "dx_0.5/history.csv", "dx_0.5/frames/soil_00000.hdf"]
SEARCH = ["fos.json", "fos.csv", "report.html", "figures/failure_velocity.png", "failure/results.json",
          "failure/frames/soil.hdf.series"]
CASE = ["results.json", "history.csv", "frames/soil_00000.hdf", "report.html", "figures/main.png"]

# What only lies there, some with names that look like results.
FOREIGN = ["notes.txt", "figures/mine.png", "frames/soil_1.vtk", "frames/soil_00000.hdf.bak", "checkpoints/notes",
           "my_results.json", "dx_notes/results.txt", "failure/photo.jpg", "report.html.old"]


class FoldersTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.scene = self.folder / "block.toml"
        self.scene.write_text(BLOCK)
        self.out = self.folder / "out"

    def scarp(self, *arguments):
        return subprocess.run([SCARP, *arguments], cwd=self.folder, capture_output=True, text=True, timeout=100,
                              check=False)

    def run_block(self, *more):
        return self.scarp("run", "block.toml", "-o", "out", "--threads", "1", "-q", *more)

    def put(self, names):
        for name in names:
            path = self.out / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(f"this is {name}")

    def files(self):
        return {p.relative_to(self.out).as_posix(): p.read_bytes() for p in self.out.rglob("*")
                if p.is_file() and p.name != ".lock"}

    def interrupt(self):
        """A run of seconds, stopped once it has a checkpoint."""
        self.scene.write_text(BLOCK.replace("duration = 0.04", "duration = 100"))
        with subprocess.Popen([SCARP, "run", "block.toml", "-o", "out", "--threads", "1", "-q"], cwd=self.folder,
                              stderr=subprocess.PIPE, text=True) as process:
            end = time.monotonic() + 60
            while not list(self.out.glob("checkpoints/step_*.h5")) and time.monotonic() < end:
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.scene.write_text(BLOCK)

    def expect_refused(self, done, *words):
        self.assertEqual(done.returncode, 1, done.stderr)
        for word in (*words, "--overwrite", "-o"):
            self.assertIn(word, done.stderr)

    def test_a_complete_run_is_replaced_and_nothing_of_it_is_left(self):
        self.assertEqual(self.run_block().returncode, 0)
        self.put(["report.html", "figures/history.png", "figures/stress_00003.png", *FOREIGN])
        first = self.files()
        self.assertIn("energy.csv", first)
        self.scene.write_text(BLOCK.replace("energy = true", "frames = false").split("[[probe]]")[0]
                              + "[output]\nframes = false\n" + BLOCK[BLOCK.index("[[stage]]"):])
        done = self.run_block()
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        now = self.files()
        self.assertEqual(set(now), {"scene.toml", "run.json", "results.json", "history.csv", "walls.csv", *FOREIGN}
                         | {name for name in now if name.startswith("checkpoints/step_")})
        for name in FOREIGN:
            self.assertEqual(now[name], first[name])
        self.assertEqual(now["scene.toml"].decode(), self.scene.read_text())

    def test_an_interrupted_run_is_kept(self):
        self.interrupt()
        self.put(["report.html"])
        before = self.files()
        self.expect_refused(self.scarp("converge", "block.toml", "-o", "out", "-q"), "'scarp run'")
        self.expect_refused(self.run_block(), "has not reached its end", "scarp resume out", "block.toml")
        self.assertEqual(self.files(), before)
        self.put(FOREIGN)
        self.assertEqual(self.run_block("--overwrite").returncode, 0)
        now = self.files()
        self.assertNotIn("report.html", now)
        self.assertLessEqual(set(FOREIGN), set(now))
        self.assertTrue(json.loads(now["results.json"])["complete"])
        # the kept states are those of the new run, not the interrupted one's
        self.assertIn("complete", self.scarp("resume", "out").stderr)

    def test_a_killed_run_without_checkpoint_is_kept_too(self):
        self.assertEqual(self.run_block().returncode, 0)
        for path in [*self.out.glob("checkpoints/*"), self.out / "results.json"]:
            path.unlink()
        self.expect_refused(self.run_block(), "has no checkpoint", "scarp resume out")
        (self.out / "run.json").write_text("{")
        self.expect_refused(self.run_block(), "run.json is damaged")
        self.assertEqual(self.run_block("--overwrite").returncode, 0)

    def test_an_unstable_run_makes_way(self):
        self.assertEqual(self.run_block().returncode, 0)
        results = json.loads((self.out / "results.json").read_text())
        results.update(complete=False, failure="too fast", instability={"step": 3})
        (self.out / "results.json").write_text(json.dumps(results))
        self.assertEqual(self.run_block().returncode, 0)

    def test_a_run_of_another_scene_is_kept(self):
        self.assertEqual(self.run_block().returncode, 0)
        (self.folder / "other.toml").write_text(BLOCK)
        before = self.files()
        self.expect_refused(self.scarp("run", "other.toml", "-o", "out", "-q"), "another scene, 'block.toml'")
        self.assertEqual(self.files(), before)

    def test_results_of_other_commands_are_kept(self):
        for names, word in ((STUDY, "'scarp converge'"), (SEARCH, "'scarp fos'"), (CASE, "something else"),
                            (["report.html"], "'report.html'"), (["history.csv"], "'history.csv'"),
                            (STUDY[4:], "'dx_0.5/")):
            self.put([*names, *FOREIGN])
            before = self.files()
            self.expect_refused(self.run_block(), word)
            self.assertEqual(self.files(), before)
            self.assertEqual(self.run_block("--overwrite").returncode, 0)
            now = self.files()
            for name in FOREIGN:
                self.assertEqual(now[name], before[name])
            for name in names:
                self.assertNotEqual(now.get(name), before[name], name)
            done = self.scarp("converge", "block.toml", "-o", "out", "-q")
            self.expect_refused(done, "'scarp run'")
            for path in sorted(self.out.rglob("*"), reverse=True):
                path.rmdir() if path.is_dir() else path.unlink()

    def test_foreign_files_alone_are_no_hindrance(self):
        self.put(FOREIGN)
        before = self.files()
        self.assertEqual(self.run_block().returncode, 0)
        self.assertEqual({name: self.files()[name] for name in FOREIGN}, before)

    def test_a_scene_in_the_folder_is_never_replaced_unasked(self):
        self.out.mkdir()
        (self.out / "scene.toml").write_text("title = 'my own'")
        self.expect_refused(self.run_block(), "scene.toml")
        (self.out / "scene.toml").write_text(BLOCK + "# mine\n")
        for more in ([], [], ["--overwrite"]):
            done = self.scarp("run", "out/scene.toml", "-o", "out", "-q", *more)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual((self.out / "scene.toml").read_text(), BLOCK + "# mine\n")

    def test_resume_says_that_the_scene_differs(self):
        self.assertEqual(self.run_block().returncode, 0)
        for text, words in ((BLOCK, []), (BLOCK + "# a note", []), (BLOCK.replace("0.5", "'50 cm'"), []),
                            (BLOCK.replace("2000", "2100"), ["density = 2000, here material[0].density = 2100"]),
                            (BLOCK.replace("[2, 2]", "[1, 2]"), ["probe[0].at"]),
                            (BLOCK.replace("0.04", "0.08"), ["stage[0].duration = 0.04", "here stage[0]"]),
                            ("nonsense", ["is no scene now"])):
            self.scene.write_text(text)
            done = self.scarp("resume", "out")
            self.assertEqual(done.returncode, 0)
            self.assertIn("the run is complete", done.stderr)
            self.assertEqual("'block.toml' has changed since" in done.stderr, bool(words), done.stderr)
            for word in words:
                self.assertIn(word, done.stderr)
        self.scene.unlink()
        self.assertNotIn("warning", self.scarp("resume", "out").stderr)

    def test_a_resumed_run_has_the_scene_of_its_record(self):
        self.assertEqual(self.run_block().returncode, 0)
        (self.out / "results.json").unlink()
        self.put(["report.html"])
        (self.out / "scene.toml").write_text("edited here")
        self.scene.write_text("edited there")
        done = self.scarp("resume", "out", "-q")
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in ("'out/scene_edited.toml'", "'block.toml' has changed"):
            self.assertIn(word, done.stderr)
        self.assertEqual((self.out / "scene_edited.toml").read_text(), "edited here")
        self.assertEqual((self.out / "scene.toml").read_text(), BLOCK)
        self.assertFalse((self.out / "report.html").exists())

    def test_frames_on_another_disk_stay_there(self):
        self.out.mkdir()
        (self.folder / "disk").mkdir()
        (self.out / "frames").symlink_to(self.folder / "disk")
        for more in ([], [], ["--overwrite"]):
            self.assertEqual(self.run_block(*more).returncode, 0)
            self.assertTrue((self.out / "frames").is_symlink())
            self.assertGreater(len(list((self.folder / "disk").glob("soil_*.hdf"))), 3)

    FOS = ["fos", "slope.toml", "-o", "out", "--from", "1.2", "--to", "1.6"]

    def kept(self):
        return sorted(path.name for path in self.out.glob("checkpoints/*.h5"))

    def interrupt_search(self, word, *more, past=None):
        """A search stopped at the first line that begins with a word, and not before it has kept other states than
        those in `past`; what it had said."""
        said = ""
        with subprocess.Popen([SCARP, *self.FOS, "--threads", "1", *more], cwd=self.folder, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True) as process:
            for line in process.stderr:
                said += line
                if line.startswith(word):
                    while process.poll() is None and past is not None and self.kept() in (past, []):
                        time.sleep(0.002)
                    process.send_signal(signal.SIGINT)
                    break
            said += process.stderr.read()
            self.assertEqual(process.wait(60), 130, said)
        return said

    def trials(self):
        """Rows of fos.csv without the steps and the time each took: after a stop nothing is left of shared cuts."""
        return [row.rsplit(",", 2)[0] for row in (self.out / "fos.csv").read_text().splitlines()]

    def test_a_search_goes_on_where_it_was_stopped(self):
        slope = self.folder / "slope.toml"
        slope.write_text(SLOPE)
        search = [*self.FOS, "--tolerance", "0.1"]
        self.assertEqual(self.scarp(*search, "-q").returncode, 0)
        whole = self.files()
        trials = self.trials()
        self.assertEqual(len(trials), 5)
        said = self.interrupt_search("SRF 1.6", "--tolerance", "0.1", "--overwrite")
        for word in ("expected: ", "to settle", "more trials", "To go on: the same command"):
            self.assertIn(word, said)
        before = self.files()
        for text, more, word in ((SLOPE.replace("10 kPa", "11 kPa"), [], "material[0].parameters"),
                                 (SLOPE.replace("at = [12, 15]", "at = [10, 15]"), [], "probe[0].at"),
                                 (SLOPE, ["--window", "3 s"], "criterion.window")):
            slope.write_text(text)
            self.expect_refused(self.scarp(*search, "-q", *more), "has not reached its end", word)
            self.assertEqual(self.files(), before)
        slope.write_text(SLOPE)
        done = self.scarp(*search, "--threads", "2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2 trials are known from before", done.stderr)
        self.assertEqual(self.trials(), trials)
        now = self.files()
        self.assertEqual(set(now), set(whole))
        for name, data in whole.items():
            if name.startswith("failure/frames/"):
                self.assertEqual(now[name], data, name)
        # with a finer tolerance the same trials and some more, without the settling
        (self.out / "report.html").write_text("old")
        done = self.scarp(*self.FOS, "--tolerance", "0.05")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("4 trials are known", done.stderr)
        self.assertNotIn("expected: ", done.stderr)
        self.assertEqual(self.trials()[:5], trials)
        self.assertNotEqual((self.out / "report.html").read_text(), "old")
        # a search that has ended makes way for another
        slope.write_text(SLOPE.replace("10 kPa", "11 kPa"))
        done = self.scarp(*self.FOS, "--tolerance", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("known", done.stderr)

    def test_a_search_stopped_while_it_settles_goes_on_from_there(self):
        scene = SLOPE.replace('"1 m"', '"0.25 m"') + '[checkpoint]\nwall_every = "100 ms"\n'
        (self.folder / "slope.toml").write_text(scene)
        self.interrupt_search("expected: ", past=[])
        first = self.kept()
        self.assertEqual(len(first), 1)
        said = self.interrupt_search("goes on with the state", past=first)
        self.assertNotIn("expected: ", said)
        second = self.kept()
        self.assertEqual(len(second), 1)
        self.assertGreater(second, first)

    def test_a_study_forgets_its_page_and_takes_what_is_complete(self):
        study = ["converge", "block.toml", "-o", "out", "--threads", "1", "--spacings", "1, 0.5, 0.25", "-q"]
        self.assertEqual(self.scarp(*study).returncode, 0)
        self.put(["figures/mine.png"])
        (self.out / "report.html").write_text("old")
        (self.out / "dx_1" / "report.html").write_text("old")
        self.scene.write_text(BLOCK.replace("2000", "2100"))
        done = self.scarp(*study)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertNotEqual((self.out / "report.html").read_text(), "old")
        self.assertFalse((self.out / "dx_1" / "report.html").exists())
        self.assertEqual(self.files()["figures/mine.png"], b"this is figures/mine.png")


if __name__ == "__main__":
    unittest.main()
