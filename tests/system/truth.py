"""Reads the simulator's truth file (geon.truth.v1), for judging a run; no program of the robot does."""

import json
import math
import pathlib
import time

STANDS_M_S = 0.01
STANDS_RAD_S = 0.01


class Truth:
    """The events so far; update() reads what has been written since."""

    def __init__(self, run_directory):
        self._path = pathlib.Path(run_directory) / "truth.jsonl"
        self._offset = 0
        self.events = []
        self.update()

    def update(self):
        if not self._path.exists():
            return
        with self._path.open("rb") as file:
            file.seek(self._offset)
            for line in file:
                if line.endswith(b"\n"):
                    self._offset += len(line)
                    self.events.append(json.loads(line))

    def states(self, since_utime=0):
        return [e for e in self.events if e["event"] == "state" and e["utime"] >= since_utime]

    def contacts(self):
        """How often the body touched something."""
        return max((e["contacts"] for e in self.events if "contacts" in e), default=0)

    def moves(self):
        states = self.states()
        return bool(states) and states[-1]["speed_m_s"] > 0.15

    def burns(self):
        lit = {}
        for event in self.events:
            if event["event"] == "laser":
                lit[event["laser"]] = event["on"]
        return any(lit.values())

    def await_moment(self, moment, ended, timeout_s):
        """Waits until the robot moves ("motion") or a laser burns ("scan"); False where ended() comes first."""
        end = time.monotonic() + timeout_s
        while time.monotonic() < end and not ended():
            self.update()
            if self.moves() if moment == "motion" else self.burns():
                return True
            time.sleep(0.01)
        return False

    def stop_after(self, utime):
        """(seconds, metres) until the robot stands, or None if it never did."""
        states = self.states(utime)
        path_m = 0.0
        for before, state in zip([states[0], *states] if states else [], states):
            path_m += math.hypot(state["x_m"] - before["x_m"], state["y_m"] - before["y_m"])
            if abs(state["speed_m_s"]) < STANDS_M_S and abs(state["turn_rate_rad_s"]) < STANDS_RAD_S:
                return (state["utime"] - utime) * 1e-6, path_m
        return None

    def dark_after(self, utime):
        """Seconds until no laser burns (0: none did), or None if one burns still."""
        lit = {"horizontal": False, "vertical": False}
        for event in self.events:
            if event["event"] != "laser":
                continue
            if event["utime"] > utime and not any(lit.values()):
                return 0.0
            lit[event["laser"]] = event["on"]
            if event["utime"] > utime and not any(lit.values()):
                return (event["utime"] - utime) * 1e-6
        return None if any(lit.values()) else 0.0
