"""python3 -m python_machine.conformance [GROUP ...]

Runs this machine on the conformance suite by the package gw (docs/python.md). Exit code 0: all
agree; 3: a difference.
"""
import pathlib
import sys
import tempfile

import gw.conformance
import numpy as np

from .machine import Machine
from .files import readers


def play(recording):
    """Name, counters and digests of every pass of a recording."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "recording.gwt"
        recording.save(path)
        for reader in readers(path):
            machine = Machine(reader.profile, reader.width, reader.height)
            for name, counters, digests, _ in machine.execute(reader.commands()):
                yield name, counters, digests


def main(groups):
    np.seterr(all="ignore")
    results = list(gw.conformance.run(play, groups or None))
    for result in results:
        if not result.agrees:
            print(result)
    agree = sum(result.agrees for result in results)
    print(f"{agree} of {len(results)} recordings agree")
    return 0 if agree == len(results) else 3


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
