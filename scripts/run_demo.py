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

SAME_GEON_M = 0.5  # a finding nearer to a geon than this is of that geon


def talk(text):
    print(text, file=sys.stderr, flush=True)


def parse_arguments():
    parser = argparse.ArgumentParser(prog="scripts/demo", description=__doc__.split("\n")[0])
    parser.add_argument("--world", type=pathlib.Path, help="world file (default: a random pen made from the seed)")
    parser.add_argument("--seed", type=int, default=1, help="of the random pen and of all noise (default 1)")
    parser.add_argument("--inventory", action="store_true",
                        help="name every geon of the pen (default world: one with three geons)")
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
    geons = "3" if arguments.inventory else "1"
    if run.geon("world", "--seed", str(arguments.seed), "--geons", geons, "-o", world,
                stdout=sys.stderr).returncode != 0:
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


def in_pen(world, place_m):
    """A place of odometry's frame W, which starts where the robot started, in the world file's."""
    robot = yaml.safe_load(world.read_text())["robot"]
    heading = math.radians(robot["heading_deg"])
    x_m, y_m = place_m
    return (robot["x_m"] + math.cos(heading) * x_m - math.sin(heading) * y_m,
            robot["y_m"] + math.sin(heading) * x_m + math.cos(heading) * y_m)


def true_geons(world):
    """What the world file says of its geons: (label, x_m, y_m)."""
    objects = yaml.safe_load(world.read_text()).get("objects") or []
    return [(o.get("truth", o.get("geon")), o["x_m"], o["y_m"]) for o in objects if "geon" in o or "truth" in o]


def true_label(world, target_m):
    """What stands nearest to the target."""
    geons = true_geons(world)
    if not geons:
        return None
    x_m, y_m = in_pen(world, target_m or (0.0, 0.0))
    return min(geons, key=lambda geon: math.hypot(geon[1] - x_m, geon[2] - y_m))[0]


def judge_inventory(world, findings):
    """For every geon of the world: its label, what was found nearest to it, and how far off."""
    places = [(in_pen(world, finding["place_m"]), finding["label"]) for finding in findings]
    judged = []
    for label, x_m, y_m in true_geons(world):
        off = [(math.hypot(p[0] - x_m, p[1] - y_m), found) for p, found in places]
        off_m, found = min(off, default=(math.inf, None))
        same = off_m < SAME_GEON_M
        judged.append({"truth": label, "label": found if same else None, "off_m": round(off_m, 3) if same else None})
    return judged


def print_geons(result):
    for geon in result["geons"]:
        off = f", {geon['off_m']:.2f} m off" if geon["off_m"] is not None else ""
        right = "right" if geon["label"] == geon["truth"] else "wrong"
        print(f"geon      {geon['truth']}: found as {geon['label'] or 'nothing'}{off}: {right}")
    print(f"mission   {result['text']}")


def print_result(result):
    verdict = result["verdict"] or {}
    if "geons" in result:
        print_geons(result)
    elif result["label"] is None:
        print(f"verdict   none: {result['outcome']} ({result['text']})")
    else:
        print(f"verdict   {result['label']} (confidence {verdict['confidence']:.2f}, method {verdict['method']})")
    if "geons" not in result:
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
    if arguments.inventory:
        os.environ["GEON_PLANNER_FLAGS"] = "--inventory"
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
    findings = outcome.get("findings", [])
    # Of all views together; the verdict is that of the last.
    label = findings[-1]["label"] if findings and outcome["outcome"] == "named" else None
    truth = true_label(world, outcome["target_m"])
    result = {"format": "geon.demo.v1", "seed": arguments.seed, "world": str(world), "outcome": outcome["outcome"],
              "text": outcome["text"], "label": label, "truth": truth, "correct": label is not None and label == truth,
              "verdict": verdict, "seconds": round(time.monotonic() - begin, 1), "frames_lost": outcome["frames_lost"],
              "restarts": outcome["restarts"], "log": str(log), "report": str(report) if reporting.returncode == 0 else None,
              "run_directory": str(run.folder)}
    if arguments.inventory:
        result["geons"] = judge_inventory(world, findings)
        result["correct"] = (outcome["outcome"] == "surveyed" and len(findings) == len(result["geons"])
                             and all(geon["label"] == geon["truth"] for geon in result["geons"]))
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
