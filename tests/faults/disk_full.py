#!/usr/bin/env python3
"""disk_full.py PROGRAM SHIM [all]: each call that creates, writes, names or moves a file fails in turn.

The exit code is 2 with a message, or the output that failed is not one that was asked for; the other outputs are written
and nothing is left.
"""
import sys

from commands import COMMANDS, Failures, Workplace, crash_in, shown

program, shim = sys.argv[1], sys.argv[2]
failures = Failures()
place = Workplace(program)
tried = 0


def check(command, point, keep_old, extra):
    place.prepare(command, keep_old)
    status, out, err = place.run(command, {"LD_PRELOAD": shim, "SHIM_FAIL": str(point), **extra})
    line = shown(command, f"(SHIM_FAIL={point} {' '.join(f'{k}={v}' for k, v in extra.items())})")
    new = [name for name in command.outputs if place.is_new(name)]
    lost = len(command.outputs) - len(new)
    if status == 2:
        if "error: " not in err or "No space left on device" not in err:
            failures.add(line, f"no message that says why: {err[-300:]}")
        if lost == 0 and command.name != "lab":  # which also writes rays and meshes of its failures
            failures.add(line, "exit code 2 although all outputs are written")
    elif status not in command.codes:
        failures.add(line, f"exit status {status}: {err[-300:]}")
    elif lost > 0:
        failures.add(line, f"exit code {status}, but only {new} are written")
    if crash_in(err):
        failures.add(line, f"crashed: {err[-300:]}")
    # A failed check of a destination comes before the work; later a failure costs one output.
    if "SHIM_FAIL_ALL" not in extra and 0 < len(new) and lost > 1:
        failures.add(line, f"one failure, but only {new} are written")
    for problem in place.problems(command):
        failures.add(line, problem)


modes = [{"SHIM_FAIL_ALL": "1"}, {}, {"SHIM_NO_UNNAMED": "1"}, {"SHIM_NO_LINK": "1"}]
quick_modes = {"render": modes[:2]}
for command in COMMANDS:
    if not command.outputs:
        continue
    for mode in modes if "all" in sys.argv[3:] else quick_modes.get(command.name, modes[:1]):
        place.prepare(command, False)
        count = place.path / "count"
        status, _, err = place.run(command, {"LD_PRELOAD": shim, "SHIM_COUNT": str(count), **mode, "SHIM_FAIL_ALL": ""})
        points = int(count.read_text())
        if status not in command.codes or points < 4 * len(command.outputs):
            failures.add(shown(command), f"exit status {status} with {points} calls and no failure: {err[-300:]}")
        # Commands that measure time make a different number of calls each time.
        for point in range(1, points + 1):
            check(command, point, point % 2 == 0, mode)
            tried += 1
place.remove()
failures.end(f"{tried} failing calls")
