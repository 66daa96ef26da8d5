"""One run of the system: its own run directory, its own bus, and an end that leaves no process behind.

Used by scripts/demo and by tests/system.
"""

import json
import os
import pathlib
import socket
import subprocess
import sys
import tempfile
import time

SOURCE = pathlib.Path(__file__).resolve().parent.parent
BIN = pathlib.Path(os.environ.get("GEON_BIN_DIR", SOURCE / "build" / "bin"))
LONGEST_RUN_DIRECTORY = 70  # a socket's path has 107 characters; ours need 37 below the run directory


class NotReady(Exception):
    """The system did not come up, or did not answer."""


def new_run_directory(name):
    """run/NAME-TIME-PID, or a folder in /tmp where that would be too long for a socket."""
    folder = SOURCE / "run" / f"{name}-{time.strftime('%Y%m%d-%H%M%S')}-{os.getpid()}"
    if len(str(folder)) > LONGEST_RUN_DIRECTORY:
        return pathlib.Path(tempfile.mkdtemp(prefix=f"geon-{name}-"))
    folder.mkdir(parents=True)
    return folder


def free_port():
    """A UDP port nobody uses, for a bus of our own."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("", 0))
        return probe.getsockname()[1]


class Run:
    """What was started for one run, and how to talk to it."""

    def __init__(self, folder, environment=None, prefix=()):
        """`prefix`: words before every command, such as those that enter a network namespace."""
        self.folder = pathlib.Path(folder).resolve()
        self.folder.mkdir(parents=True, exist_ok=True)
        self.prefix = [str(word) for word in prefix]
        self.environment = dict(os.environ, GEON_RUN_DIR=str(self.folder), GEON_BIN_DIR=str(BIN))
        self.environment.setdefault(
            "LCM_DEFAULT_URL", f"udpm://239.255.76.67:{free_port()}?ttl=0&recv_buf_size=4194304")
        self.environment["PATH"] = f"{BIN}:{self.environment['PATH']}"
        self.environment.update(environment or {})
        self._started = []
        self._groups_up = False

    def command(self, words):
        return self.prefix + [str(word) for word in words]

    def geon(self, *words, **options):
        """Runs `geon WORDS` to its end."""
        return subprocess.run(self.command([BIN / "geon", *words]), env=self.environment, text=True, **options)

    def start(self, words, **options):
        process = subprocess.Popen(self.command(words), env=self.environment, text=True, **options)
        self._started.append(process)
        return process

    def up(self, *words):
        self._groups_up = True
        if self.geon("up", *words, stdout=sys.stderr).returncode != 0:
            raise NotReady("the processes did not come up (see above)")

    def processes(self):
        """What `geon status --json` says, by process name."""
        answer = self.geon("status", "--json", stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        try:
            return {process["process"]: process for process in json.loads(answer.stdout)["processes"]}
        except (ValueError, KeyError) as error:
            raise NotReady(f"geon status: {error}") from None

    def down(self):
        if self._groups_up:
            self.geon("down", stdout=subprocess.DEVNULL)
            self._groups_up = False

    def stop(self):
        """Groups first, so that recorders hear the end; then what start() started."""
        self.down()
        for process in reversed(self._started):
            if process.poll() is None:
                process.terminate()  # SIGINT may be ignored where we were started in the background
                try:
                    process.wait(20)
                except subprocess.TimeoutExpired:
                    process.kill()
                    process.wait()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.stop()
