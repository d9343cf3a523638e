# SPDX-License-Identifier: BSD-3-Clause
"""`scarp watch` serves the frames of one folder to this machine alone, shows new ones, and ends in good order.

Usage: watch_test.py SCARP"""

import http.client
import json
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

from run_folder import lattice, write_frame, write_run

SCARP = sys.argv.pop(1)


class WatchTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.run_folder = self.folder / "run"
        write_run(self.run_folder, lattice(16, 8))
        (self.folder / "viewer.js").write_text("/* the viewer */")
        self.environment = {**os.environ, "SCARP_VIEWER": str(self.folder / "viewer.js")}

    def begin(self, *options):
        self.process = subprocess.Popen([SCARP, "watch", str(self.run_folder), *options], env=self.environment,
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(lambda: (self.process.kill(), self.process.communicate()))
        self.said = self.process.stdout.readline()
        self.port = int(re.search(r"http://127\.0\.0\.1:(\d+)/", self.said).group(1))

    def get(self, path, method="GET", **headers):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=30)
        self.addCleanup(connection.close)
        connection.request(method, path, headers=headers)
        answer = connection.getresponse()
        return answer.status, answer.read(), answer

    def index(self):
        return json.loads(self.get("/index.json")[1])

    def test_serves_the_page_its_script_and_the_frames(self):
        self.begin()
        status, page, answer = self.get("/")
        self.assertEqual(status, 200)
        self.assertIn(b"data-served", page)
        self.assertIn("default-src 'none'", answer.headers["Content-Security-Policy"])
        self.assertEqual(self.get("/scarp_viewer.js")[1], b"/* the viewer */")
        index = self.index()
        self.assertEqual([frame["time"] for frame in index["frames"]], [0.0, 2.0])
        key = index["frames"][1]["key"]
        entry = json.loads(self.get(f"/frames/{key}/entry.json")[1])
        self.assertEqual(entry["count"], 16 * 8)
        for name in ("position", *entry["fields"]):
            self.assertEqual(self.get(f"/frames/{key}/{name}")[0], 200, name)

    def test_refuses_whoever_calls_it_by_another_name(self):
        self.begin()
        for host in ("evil.example", f"evil.example:{self.port}", "127.0.0.1", f"127.0.0.1:{self.port}.evil.example", ""):
            status, body, _ = self.get("/index.json", Host=host)
            self.assertEqual(status, 403, host)
            self.assertNotIn(b"frames", body)
        self.assertEqual(self.get("/index.json", Host=f"localhost:{self.port}")[0], 200)

    def test_gives_out_nothing_else(self):
        self.begin()
        key = self.index()["frames"][0]["key"]
        for path in ("/results.json", "/../run/results.json", "/%2e%2e/results.json", "/frames/soil_00000.hdf", "/frames/x/position",
                     f"/frames/{key}/../../results.json", f"/frames/{key}/none", "//etc/passwd"):
            self.assertEqual(self.get(path)[0], 404, path)
        self.assertEqual(self.get("/", method="POST")[0], 501)

    def test_listens_on_the_loopback_alone(self):
        self.begin()
        lines = pathlib.Path("/proc/net/tcp").read_text().splitlines()
        ours = [line.split()[1] for line in lines if line.split()[1].endswith(f":{self.port:04X}") and line.split()[3] == "0A"]
        self.assertEqual(ours, [f"0100007F:{self.port:04X}"])

    def test_shows_new_frames_once_they_are_complete(self):
        self.begin()
        frames = self.run_folder / "frames"
        write_frame(self.folder / "new.hdf", lattice(16, 8), time=3.0)
        half = (self.folder / "new.hdf").read_bytes()[:3000]
        (frames / "soil_00002.hdf.part").write_bytes(half)
        self.assertEqual(len(self.index()["frames"]), 2)
        shutil.move(self.folder / "new.hdf", frames / "soil_00002.hdf")
        self.assertEqual([frame["time"] for frame in self.index()["frames"]], [0.0, 2.0, 3.0])

    def test_a_run_begun_anew_has_other_frames(self):
        self.begin()
        before = [frame["key"] for frame in self.index()["frames"]]
        shutil.rmtree(self.run_folder)
        time.sleep(0.02)
        write_run(self.run_folder, lattice(8, 8))
        after = [frame["key"] for frame in self.index()["frames"]]
        self.assertFalse(set(before) & set(after))

    def test_waits_for_the_first_frame(self):
        shutil.rmtree(self.run_folder / "frames")
        self.begin()
        self.assertEqual(self.index()["frames"], [])

    def test_a_damaged_frame_is_named(self):
        self.begin()
        (self.run_folder / "frames" / "soil_00000.hdf").write_bytes(b"nothing")
        self.assertEqual([frame["time"] for frame in self.index()["frames"]], [2.0])

    def test_signals_end_it_with_success(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            self.begin()
            self.process.send_signal(number)
            out, err = self.process.communicate(timeout=30)
            self.assertEqual((self.process.returncode, out, err), (0, "", ""))

    def test_a_killed_program_leaves_no_server(self):
        self.begin()
        self.process.kill()
        deadline = time.monotonic() + 20
        while time.monotonic() < deadline:
            with socket.socket() as other:
                if other.connect_ex(("127.0.0.1", self.port)) != 0:
                    return
            time.sleep(0.1)
        self.fail("the server goes on")

    def failing(self, *arguments):
        done = subprocess.run([SCARP, "watch", *arguments], env=self.environment, capture_output=True, text=True, timeout=60)
        return done.returncode, done.stderr

    def test_a_port_that_is_taken_is_an_error(self):
        self.begin()
        code, said = self.failing(str(self.run_folder), "--port", str(self.port))
        self.assertEqual(code, 1)
        self.assertIn(f"port {self.port}: Address already in use", said)

    def test_without_the_viewer_it_says_how_to_get_it(self):
        self.environment["SCARP_VIEWER"] = str(self.folder / "none.js")
        code, said = self.failing(str(self.run_folder))
        self.assertEqual(code, 1)
        self.assertIn("scarp was built without it", said)

    def test_what_cannot_be_a_port_or_a_folder_is_refused(self):
        self.assertEqual(self.failing(str(self.run_folder), "--port", "70000")[0], 2)
        self.assertEqual(self.failing(str(self.folder / "none"))[0], 2)


if __name__ == "__main__":
    unittest.main()
