"""The conformance suite for a machine written in Python (docs/conformance.md).

    def play(recording):                       # a gw.Recording
        machine = MyMachine(recording.profile, recording.width, recording.height)
        for one in machine.execute(recording.encode()):
            yield one.name, one.counters, one.digests

    for result in gw.conformance.run(play, groups=["raster"]):
        print(result)
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Iterable, Iterator, Mapping, Sequence

from ._gw import Error, Recording, conformance_groups, conformance_members

Pass = tuple[str, Mapping[str, int], Mapping[str, str]]
"""A pass as a machine reports it: its name, its counters and the digests of its planes."""


@dataclass(frozen=True)
class Result:
    """The answer to one recording."""

    name: str
    group: str
    passes: int
    difference: str
    """The first difference; "" if the machine agrees."""

    @property
    def agrees(self) -> bool:
        return not self.difference

    def __str__(self) -> str:
        return f"{self.name}: {self.difference or f'agrees, {self.passes} passes'}"


def run(play: Callable[[Recording], Iterable[Pass]], groups: Sequence[str]
        | None = None) -> Iterator[Result]:
    """Plays every recording of the groups (default: all) and yields a result for each. What `play`
    raises is a difference too."""
    known = [str(group["name"]) for group in conformance_groups()]
    for name in groups if groups is not None else known:
        if name not in known:
            raise Error(f"no group '{name}'; expected one of {', '.join(known)}")
        for member, recording in conformance_members(name):
            yield _check(name, member, recording, play)


def _check(
    group: str, name: str, recording: Recording, play: Callable[[Recording], Iterable[Pass]]
) -> Result:
    expected = recording.passes(reference=True)
    count = 0
    try:
        for count, actual in enumerate(play(recording), 1):
            if count > len(expected):
                return Result(name, group, count,
                              f"pass {count} '{actual[0]}': expected only {len(expected)}")
            difference = _difference(actual, expected[count - 1])
            if difference:
                return Result(name, group, count, f"pass {count} '{actual[0]}': {difference}")
    except Exception as error:  # a machine under test may raise anything
        return Result(name, group, count, f"after {count} passes: {type(error).__name__}: {error}")
    if count < len(expected):
        return Result(name, group, count, f"{count} passes, expected {len(expected)}")
    return Result(name, group, count, "")


def _difference(actual: Pass, expected: Mapping[str, object]) -> str:
    name, counters, digests = actual
    if name != expected["pass"]:
        return f"name '{name}', expected '{expected['pass']}'"
    planes = expected["digests"]
    assert isinstance(planes, dict)
    for plane, digest in planes.items():
        if digests.get(plane) != digest:
            return f"plane {plane}: digest {digests.get(plane)}, expected {digest}"
    if "shown" in digests and "shown" not in planes:
        return "plane shown: colours are not indices"
    for counter, count in expected.items():
        if counter not in ("pass", "digests") and counters.get(counter, 0) != count:
            return f"counter {counter}: {counters.get(counter, 0)}, expected {count}"
    return ""
