#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Follows a run in a browser: `scarp_watch.py DIR` serves its frames as they appear, on this machine alone, until Ctrl-C."""

import argparse
import collections
import json
import os
import pathlib
import re
import signal
import sys
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
try:
    from scarp_frames import Damaged, frame_info, load_faces, load_frame, read_results
    from scarp_picture import PackedFrame, head, materials_of, walls_of
    from scarp_viewer import MISSING, picture_page, script_file
except ImportError as error:
    sys.exit(f"scarp watch: {error}; install Debian's python3-h5py.")

LOOPBACK = "127.0.0.1"
FRAME = re.compile(r"soil_(\d{5,9})\.hdf")
KEPT_BYTES = 500e6  # of packed frames
# Nothing from elsewhere, nothing inside another page.
POLICY = ("default-src 'none'; script-src 'self'; style-src 'unsafe-inline'; connect-src 'self'; img-src data:; "
          "frame-ancestors 'none'; base-uri 'none'; form-action 'none'")


class Run:
    """The frames of a folder, read when they are asked for. A frame appears under its name when it is complete; its key also
    tells it from one of the same number that a new run in the folder leaves."""

    def __init__(self, folder):
        self.folder, self.infos, self.packed, self.heads = folder, {}, collections.OrderedDict(), {}
        self.turn = threading.Lock()

    def frames(self):
        """{key: number, path, time, ...}, in order."""
        found = {}
        for path in sorted((self.folder / "frames").glob("soil_*.hdf"), key=lambda path: (len(path.name), path.name)):
            match = FRAME.fullmatch(path.name)
            try:
                key = f"{int(match.group(1))}-{path.stat().st_mtime_ns:x}" if match else None
                if key and key not in self.infos:
                    info = frame_info(path)
                    self.infos[key] = {"number": int(match.group(1)), "path": path, **{name: info.get(name) for name in (
                        "time", "step", "stage", "event")}}
            except (OSError, Damaged):
                continue  # removed by a new run since it was listed, or damaged
            if key:
                found[key] = self.infos[key]
        return found

    def index(self):
        frames = self.frames()
        shown = [{"key": key, **{name: info[name] for name in ("number", "time", "stage", "event")}} for key, info in frames.items()]
        if not shown:
            return {"frames": [], "notes": []}
        first = next(iter(frames))
        if first not in self.heads:
            frame = load_frame(frames[first]["path"])
            self.heads = {first: head(frame.get("title") or self.folder.name, frame, materials_of(self.folder))}
        return {**self.heads[first], "frames": shown, "notes": [self.state()]}

    def state(self):
        try:
            results = read_results(self.folder)
        except Damaged:
            results = {}
        if not results:
            return "The run goes on, and new moments appear here; or it was killed: it has left no results.json."
        return f"The run has ended{': ' + results['failure'] if results.get('failure') else '.'}"

    def frame(self, key):
        """(entry, blocks) of a frame; KeyError if there is none of this key."""
        with self.turn:
            if key not in self.packed:
                info = self.frames()[key]
                packed = PackedFrame(load_frame(info["path"]))
                faces = load_faces(self.folder, info["number"])
                self.packed[key] = ({**packed.entry, "outside": packed.outside,
                                     "faces": walls_of(faces) if faces else None}, packed.blocks)
                while len(self.packed) > 1 and self.bytes() > KEPT_BYTES:
                    self.packed.popitem(last=False)
            self.packed.move_to_end(key)
            return self.packed[key]

    def bytes(self):
        return sum(len(block) for _, blocks in self.packed.values() for block in blocks.values())


class Handler(BaseHTTPRequestHandler):
    """Answers to GET of the page, its script, the index and the blocks; of nothing else, and to nobody else."""

    server_version, sys_version, protocol_version = "scarp", "", "HTTP/1.1"
    timeout = 60

    def do_GET(self):
        # A page from elsewhere whose name was made to lead here says its own name.
        if self.headers.get("Host") not in (f"{name}:{self.server.server_port}" for name in (LOOPBACK, "localhost")):
            return self.answer(403, "text/plain", b"This server answers to its own address only.\n")
        try:
            kind, body = self.content([part for part in self.path.split("?")[0].split("/") if part])
        except (KeyError, FileNotFoundError):
            return self.answer(404, "text/plain", b"There is no such thing here.\n")
        except Damaged as error:
            return self.answer(500, "text/plain; charset=utf-8", str(error).encode())
        return self.answer(200, kind, body)

    def content(self, parts):
        run = self.server.run
        if not parts:
            return "text/html; charset=utf-8", self.server.page
        if parts == ["scarp_viewer.js"]:
            return "text/javascript; charset=utf-8", script_file().read_bytes()
        if parts == ["index.json"]:
            return "application/json", json.dumps(run.index()).encode()
        if len(parts) == 3 and parts[0] == "frames":
            entry, blocks = run.frame(parts[1])
            if parts[2] == "entry.json":
                return "application/json", json.dumps(entry).encode()
            return "application/octet-stream", blocks[parts[2]]
        raise KeyError(self.path)

    def answer(self, status, kind, body):
        self.send_response(status)
        for name, value in (("Content-Type", kind), ("Content-Length", str(len(body))), ("Cache-Control", "no-store"),
                            ("X-Content-Type-Options", "nosniff"), ("Content-Security-Policy", POLICY),
                            ("Cross-Origin-Resource-Policy", "same-origin")):
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_):
        pass


class Server(ThreadingHTTPServer):
    daemon_threads = True

    def __init__(self, folder, port):
        super().__init__((LOOPBACK, port), Handler)
        self.run, self.parent = Run(folder), os.getppid()
        self.page = picture_page(folder.name, '<div class="scarp-picture alone" data-served></div>',
                                 '<script src="scarp_viewer.js"></script>').encode()

    def service_actions(self):
        if os.getppid() != self.parent:  # whoever began it was killed
            stop(self)

    def handle_error(self, request, client_address):
        if not isinstance(sys.exception(), OSError):  # a browser that went away
            super().handle_error(request, client_address)


def stop(server):
    threading.Thread(target=server.shutdown, daemon=True).start()  # shutdown() waits for serve_forever()


def watch(folder, port):
    if script_file() is None:
        sys.exit(f"scarp watch: {MISSING}")
    try:
        server = Server(folder, port)
    except OSError as error:
        sys.exit(f"scarp watch: port {port}: {error.strerror}. Try another one, or leave --port out.")
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, lambda *_: stop(server))
    print(f"Open http://{LOOPBACK}:{server.server_port}/ in a browser on this machine; Ctrl-C ends this.", flush=True)
    with server:
        server.serve_forever(poll_interval=0.2)


def main():
    parser = argparse.ArgumentParser(description="Follow a run in a browser on this machine.")
    parser.add_argument("folder", metavar="DIR", type=pathlib.Path, help="output folder of a run")
    parser.add_argument("--port", type=int, default=0, help="listen on this port; default: a free one")
    options = parser.parse_args()
    if not options.folder.is_dir():
        sys.exit(f"scarp watch: '{options.folder}' is no folder; give the output folder of a run.")
    watch(options.folder.resolve(), options.port)


if __name__ == "__main__":
    main()
