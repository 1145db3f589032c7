#!/usr/bin/env python3
"""streams.py PROGRAM: every command with standard streams that are closed, full, or whose reader is gone.

Messages are dropped without harm, outputs are written in any case, and a lost standard output is exit code 2.
"""
import subprocess
import sys

from commands import COMMANDS, Failures, Workplace, shown

STREAMS = [">&-", "2>&-", "<&-", ">&- 2>&-", "<&- >&- 2>&-", ">/dev/full", "2>/dev/full", ">/dev/full 2>/dev/full",
           "| true", "2>&1 >/dev/null | true"]

program = sys.argv[1]
failures = Failures()
place = Workplace(program)
tried = 0

for command in COMMANDS:
    place.prepare(command, False)
    status, out, _ = place.run(command)
    if status not in command.codes:
        failures.add(shown(command), f"exit status {status}")
    for streams in STREAMS:
        place.prepare(command, True)
        # Progress fills the messages of the commands that have it.
        progress = ["--progress", "json"] if command.name.startswith(("render", "trade", "lab")) else []
        script = f'set -o pipefail; "$0" "$@" {streams}'
        status = subprocess.run(["bash", "-c", script, program, *command.arguments, *progress], cwd=place.path,
                                env=place.environment, capture_output=True).returncode
        line = shown(command, streams)
        tried += 1
        loses_output = out != "" and (streams.startswith((">&-", "<&- >&-", ">/dev/full")))
        ends_by_pipe = out != "" and streams == "| true"
        allowed = (2,) if loses_output else (*command.codes, 141) if ends_by_pipe else command.codes
        if status not in allowed:
            failures.add(line, f"exit status {status}, expected one of {allowed}")
        for name in command.outputs:
            if not place.is_new(name):
                failures.add(line, f"{name} is not written")
        for problem in place.problems(command):
            failures.add(line, problem)
place.remove()
failures.end(f"{tried} runs")
