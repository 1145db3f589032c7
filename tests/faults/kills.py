#!/usr/bin/env python3
"""kills.py PROGRAM SHIM KILLS [SEED]: interrupts and kills commands at random instants.

After each: outputs are absent, old or whole, nothing else is left, and the exit code tells how the command ended. Every
second run is on a simulated file system without unnamed files.
"""
import os
import random
import signal
import sys
import time

from commands import COMMANDS, Failures, Workplace, crash_in, shown

SEQUENCES = [["INT"], ["TERM"], ["HUP"], ["INT", "INT"], ["TERM", "INT"], ["HUP", "TERM"], ["KILL"]]
MOST_SECONDS = 120  # against processes that never end

program, shim, kills = sys.argv[1], sys.argv[2], int(sys.argv[3])
choice = random.Random(int(sys.argv[4]) if len(sys.argv) > 4 else 1)
failures = Failures()
place = Workplace(program)
unnamed_files = True
try:
    os.close(os.open(place.path, os.O_TMPFILE | os.O_WRONLY))
except OSError:
    unnamed_files = False


def run(command, names, delay, environment):
    """The exit status, the seconds from the first signal to the end, and the messages."""
    with open(place.path / "err", "wb") as err, open(place.path / "out", "wb") as out:
        process = place.start(command, environment, stdout=out, stderr=err)
        time.sleep(delay)
        begin = time.monotonic()
        for name in names:
            process.send_signal(getattr(signal, "SIG" + name))
        try:
            status = process.wait(MOST_SECONDS)
        except Exception:
            process.kill()
            status = None
            process.wait()
    return status, time.monotonic() - begin, (place.path / "err").read_text(errors="replace")


durations, slowest, left_by_kill, hard_kills = {}, (0.0, ""), 0, 0
for command in COMMANDS:
    place.prepare(command, False)
    begin = time.monotonic()
    status, _, messages = run(command, [], 0, {})
    durations[command.name] = time.monotonic() - begin
    if status not in command.codes:
        failures.add(shown(command), f"exit status {status} without a signal: {messages[-300:]}")

for number in range(kills):
    command, names = choice.choice(COMMANDS), choice.choice(SEQUENCES)
    delay = choice.uniform(0.0, 1.05 * durations[command.name])
    named = number % 2 == 1
    keep_old = choice.random() < 0.5
    place.prepare(command, keep_old)
    progress = command.name.startswith("render")
    command.arguments += ["--progress", "json"] if progress else []
    status, seconds, messages = run(command, names, delay, {"LD_PRELOAD": shim, "SHIM_NO_UNNAMED": "1"} if named else {})
    line = shown(command, f"({' '.join(names)} after {delay:.3f} s, {'named' if named else 'unnamed'} files)")
    command.arguments = command.arguments[:-2] if progress else command.arguments
    if status is None:
        failures.add(line, f"did not end within {MOST_SECONDS} s")
    elif status not in (130, *command.codes, *(-getattr(signal, "SIG" + name) for name in names)):
        failures.add(line, f"exit status {status}: {messages[-300:]}")
    if crash_in(messages):
        failures.add(line, f"crashed: {messages[-300:]}")
    found = place.problems(command)
    if names == ["KILL"]:
        hard_kills += 1
        temporary = [problem for problem in found if problem.startswith("the temporary file")]
        left_by_kill += len(temporary) if not named and unnamed_files else 0
        found = [problem for problem in found if problem not in temporary]
    for problem in found:
        failures.add(line, problem)
    # After the first report of the render the image is kept.
    if len(names) == 1 and status == 130 and '"samples"' in messages:
        for name in command.outputs:
            if name.count(".") == 1 and name != "s.json" and not place.is_new(name):
                failures.add(line, f"{name} is not written")
    if len(names) == 1 and names != ["KILL"] and seconds > slowest[0]:
        slowest = (seconds, line)

# Between giving a whole file its name and moving it lie microseconds.
if left_by_kill > max(1, hard_kills // 50):
    failures.add("", f"{left_by_kill} temporary files are left after {hard_kills} times SIGKILL")
place.remove()
print(f"slowest answer: {slowest[0]:.2f} s, {slowest[1]}")
failures.end(f"{kills} kills")
