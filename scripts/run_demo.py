#!/usr/bin/python3
"""Runs one mission on the simulated robot and says whether the geon was named rightly.

Called by scripts/demo, which has installed and built everything. Every run has its own run directory and its
own LCM port, so that several can run side by side. Exit code 0: the named shape is the true one; 1: it is not,
or none was named; 2: usage; 3: the system did not come up.
"""

import argparse
import json
import math
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

import yaml

from geon_run import BIN, SOURCE, NotReady, Run, new_run_directory


def talk(text):
    print(text, file=sys.stderr, flush=True)


def parse_arguments():
    parser = argparse.ArgumentParser(prog="scripts/demo", description=__doc__.split("\n")[0])
    parser.add_argument("--world", type=pathlib.Path, help="world file (default: a random pen made from the seed)")
    parser.add_argument("--seed", type=int, default=1, help="of the random pen and of all noise (default 1)")
    parser.add_argument("--headless", action="store_true", help="do not open the report in a browser")
    parser.add_argument("--json", action="store_true", help="print one JSON object (geon.demo.v1)")
    parser.add_argument("--timeout-s", type=float, default=900.0, help="longest mission (default 900)")
    parser.add_argument("--run-dir", type=pathlib.Path, help="where to keep everything (default: run/demo-...)")
    arguments = parser.parse_args()
    if arguments.world and not arguments.world.is_file():
        parser.error(f"{arguments.world}: no such world file")
    return arguments


def world_file(arguments, run):
    if arguments.world:
        return arguments.world.resolve()  # meshes are found beside it
    world = run.folder / "world.yaml"
    if run.geon("world", "--seed", str(arguments.seed), "-o", world, stdout=sys.stderr).returncode != 0:
        raise NotReady("geon world made no world")
    return world


def mission(arguments, run, world, log):
    """The planner's outcome, as `geon watch --json` tells it."""
    recorder = run.start([SOURCE / "scripts" / "record", log], stdout=sys.stderr)
    watch = run.start([BIN / "geon", "watch", "--json", "--timeout-s", arguments.timeout_s], stdout=subprocess.PIPE)
    run.up("--world", world, "--seed", arguments.seed)
    output, _ = watch.communicate()
    processes = run.processes().values()
    run.stop()
    if recorder.returncode not in (0, -signal.SIGTERM):
        talk(f"scripts/record ended with code {recorder.returncode}: the log may be short")
    try:
        outcome = json.loads(output)
    except ValueError:
        raise NotReady("geon watch said nothing") from None
    outcome["frames_lost"] = sum(process["rx_lost"] or 0 for process in processes)
    outcome["restarts"] = sum(process["restarts"] for process in processes)
    return outcome


def true_label(world, target_m):
    """What the world file says the object at the target is. W starts where the robot started."""
    content = yaml.safe_load(world.read_text())
    geons = [o for o in content["objects"] if "geon" in o or "truth" in o]
    if not geons:
        return None
    robot = content["robot"]
    heading = math.radians(robot["heading_deg"])
    x_m, y_m = target_m or (0.0, 0.0)
    position = (robot["x_m"] + math.cos(heading) * x_m - math.sin(heading) * y_m,
                robot["y_m"] + math.sin(heading) * x_m + math.cos(heading) * y_m)
    nearest = min(geons, key=lambda o: math.hypot(o["x_m"] - position[0], o["y_m"] - position[1]))
    return nearest.get("truth", nearest.get("geon"))


def print_result(result):
    verdict = result["verdict"] or {}
    if result["label"] is None:
        print(f"verdict   none: {result['outcome']} ({result['text']})")
    else:
        print(f"verdict   {result['label']} (confidence {verdict['confidence']:.2f}, method {verdict['method']})")
    for reason in verdict.get("evidence", {}).get("reasons", []):
        print(f"          {reason}")
    print(f"truth     {result['truth']}: {'right' if result['correct'] else 'wrong'}")
    print(f"mission   {result['seconds']:.0f} s, {result['frames_lost']} messages lost, {result['restarts']} restarts")
    print(f"log       {result['log']}")
    print(f"report    {result['report']}")


def open_report(report):
    has_display = os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    if report and has_display and shutil.which("xdg-open"):
        subprocess.Popen(["xdg-open", report], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def main():
    arguments = parse_arguments()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))  # leaves through Run's end
    begin = time.monotonic()
    folder = arguments.run_dir or new_run_directory(f"demo-seed{arguments.seed}")
    with Run(folder) as run:
        log, report = run.folder / "mission.lcmlog", run.folder / "report.html"
        try:
            world = world_file(arguments, run)
            outcome = mission(arguments, run, world, log)
        except NotReady as error:
            talk(f"scripts/demo: {error}; logs are in {run.folder}/log")
            return 3
        reporting = run.geon("report", log, "--truth", run.folder / "truth.jsonl", "-o", report, stdout=sys.stderr)
    verdict = outcome["verdict"]
    label = verdict["label"] if verdict and outcome["outcome"] == "named" else None
    truth = true_label(world, outcome["target_m"])
    result = {"format": "geon.demo.v1", "seed": arguments.seed, "world": str(world), "outcome": outcome["outcome"],
              "text": outcome["text"], "label": label, "truth": truth, "correct": label is not None and label == truth,
              "verdict": verdict, "seconds": round(time.monotonic() - begin, 1), "frames_lost": outcome["frames_lost"],
              "restarts": outcome["restarts"], "log": str(log), "report": str(report) if reporting.returncode == 0 else None,
              "run_directory": str(run.folder)}
    (run.folder / "result.json").write_text(json.dumps(result) + "\n")
    if arguments.json:
        print(json.dumps(result))
    else:
        print_result(result)
    if not arguments.headless:
        open_report(result["report"])
    return 0 if result["correct"] else 1


if __name__ == "__main__":
    sys.exit(main())
