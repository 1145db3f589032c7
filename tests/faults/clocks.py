#!/usr/bin/env python3
"""clocks.py PROGRAM SHIM: the time of day jumps at each reading, and the monotonic clock jumps once; results stay the same."""
import json
import signal
import subprocess
import sys
import time

from commands import COMMANDS, Command, Failures, SMALL, Workplace, crash_in, shown

program, shim = sys.argv[1], sys.argv[2]
failures = Failures()
place = Workplace(program)
tried = 0


def check(command, extra, codes=None):
    global tried
    tried += 1
    place.prepare(command, False)
    begin = time.monotonic()
    status, out, err = place.run(command, {"LD_PRELOAD": shim, **extra})
    line = shown(command, "(" + " ".join(f"{k}={v}" for k, v in extra.items()) + ")")
    if status not in (codes or command.codes):
        failures.add(line, f"exit status {status}: {err[-300:]}")
    if time.monotonic() - begin > 60.0:
        failures.add(line, "took more than a minute")
    if crash_in(err):
        failures.add(line, f"crashed: {err[-300:]}")
    for name in command.outputs:
        if not place.is_new(name):
            failures.add(line, f"{name} is not written")
    for problem in place.problems(command):
        failures.add(line, problem)
    return line, out, err


def check_progress(line, messages):
    """Times of the progress are numbers of at least 0."""
    reports = [json.loads(text) for text in messages.splitlines() if text.startswith("{")]
    if not reports:
        failures.add(line, "no progress")
    for report in reports:
        if not (report["elapsed_s"] >= 0.0 and report.get("remaining_s", 0.0) >= 0.0):
            failures.add(line, f"times in {report}")
            return


def image(extra):
    command = Command("render", ["render", *SMALL, "--spp", "256", "--progress", "json", "-o", "a.pfm"], ["a.pfm"])
    line, _, err = check(command, extra)
    check_progress(line, err)
    return (place.path / "a.pfm").read_bytes()


for command in COMMANDS:
    check(command, {"SHIM_JUMP": "100000000"})

exact = image({})
for extra in [{"SHIM_JUMP": "100000000"}, *({"SHIM_STEP": step, "SHIM_STEP_AFTER": after} for step in
                                            ("-100000", "-3", "3", "100000") for after in ("5", "20", "60"))]:
    if image(extra) != exact:
        failures.add(str(extra), "another image")

limited = Command("limit", ["render", "builtin:cornell-area", "--size", "100x100", "--spp", "1000000", "--time-limit", "1",
                            "--progress", "json", "-o", "a.pfm"], ["a.pfm"], codes=(3,))
for extra in [{"SHIM_JUMP": "100000000"}, {"SHIM_STEP": "100000", "SHIM_STEP_AFTER": "30"},
              {"SHIM_STEP": "-1", "SHIM_STEP_AFTER": "30"}]:
    line, _, err = check(limited, extra)
    check_progress(line, err)

# A process that was stopped goes on where it was.
place.prepare(limited, False)
process = place.start(limited, stderr=subprocess.DEVNULL)
time.sleep(0.5)
process.send_signal(signal.SIGSTOP)
time.sleep(1.5)
process.send_signal(signal.SIGCONT)
if (status := process.wait(60)) != 3 or not place.is_new("a.pfm"):
    failures.add(shown(limited, "(stopped for 1.5 s)"), f"exit status {status}")

place.remove()
failures.end(f"{tried + 1} runs")
