"""python3 -m python_machine [--stop-after N] RECORDING.gwt ...

Executes recordings and compares every pass with its manifest, the file NAME.json beside the
recording. Of a stream with several machines, numbered from 0, they are NAME_0.json and so on. Stops
after N recordings that differ, if N is given. Exit code 0: all agree; 3: a difference; 2: usage.
"""
import json
import pathlib
import sys

import numpy as np

from .machine import Machine
from .files import readers


def differences(name, counters, digests, queries, expected):
    """What a pass has otherwise than its manifest says."""
    if name != expected["name"]:
        yield f"name '{name}', expected '{expected['name']}'"
    for plane in sorted(set(expected["digests"]) | set(digests)):
        if digests.get(plane) != expected["digests"].get(plane):
            yield f"plane {plane}"
    if queries != expected.get("queries", []):
        yield f"queries {queries}, expected {expected.get('queries', [])}"
    wanted = expected["counters"]
    for counter in sorted(set(wanted) | set(counters)):
        if counters.get(counter, 0) != wanted.get(counter, 0):
            yield f"{counter} {counters.get(counter, 0)}, expected {wanted.get(counter, 0)}"


def check(recording):
    """The number of passes, and the lines to print of the first that differs."""
    machines = readers(recording)
    passes = 0
    for number, reader in enumerate(machines):
        suffix = f"_{number}" if len(machines) > 1 else ""
        count, lines = check_machine(reader, recording.with_name(f"{recording.stem}{suffix}.json"))
        passes += count
        if lines:
            return passes, lines
    return passes, []


def check_machine(reader, manifest):
    expected = json.loads(manifest.read_text(encoding="utf-8"))["passes"]
    machine = Machine(reader.profile, reader.width, reader.height)
    passes = 0
    for number, ended in enumerate(machine.execute(reader.commands())):
        if number >= len(expected):
            return passes, [f"pass {number + 1} '{ended[0]}': the manifest has only {number}"]
        lines = [f"pass {number + 1} '{ended[0]}': {line}"
                 for line in differences(*ended, expected[number])]
        if lines:
            return passes, lines
        passes += 1
    if passes < len(expected):
        return passes, [f"{passes} passes, expected {len(expected)}"]
    return passes, []


def main(arguments):
    most = len(arguments)
    if len(arguments) > 1 and arguments[0] == "--stop-after" and arguments[1].isdigit():
        most, arguments = int(arguments[1]), arguments[2:]
    if not arguments:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    np.seterr(all="ignore")
    agree, passes, differing = 0, 0, 0
    for argument in arguments:
        if differing == most:
            break
        recording = pathlib.Path(argument)
        count, lines = check(recording)
        passes += count
        if lines:
            differing += 1
            for line in lines:
                print(f"{recording}: {line}")
        else:
            agree += 1
    print(f"{agree} of {agree + differing} recordings agree, {passes} passes")
    return 3 if differing else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
