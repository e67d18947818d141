"""Goldens for pytest: the passes of a command list, bit for bit, on both machines.

    from gw.testing import expect_passes_equal

    def test_my_renderer(goldens):
        expect_passes_equal(goldens.recording(my_list(), "vgx", 64, 64), "goldens/triangle.json")

A golden is written only by `pytest --gw-update-goldens` (or GW_UPDATE_GOLDENS=1). The fixture
`goldens` and the flag come with `pytest_plugins = ["gw.testing"]` in conftest.py.
"""
from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any, Iterator

import pytest

from ._gw import CommandList, Difference, Error, Machine, Profile, Recording


def pytest_addoption(parser: Any) -> None:
    parser.addoption(
        "--gw-update-goldens", action="store_true", default=False,
        help="gw: write goldens instead of comparing"
    )


class Goldens:
    """The goldens of one test."""

    def __init__(self, test: str, update: bool) -> None:
        self.test = test
        self.update = update

    @staticmethod
    def recording(commands: CommandList, profile: Profile | str, width: int,
                  height: int) -> Recording:
        """A list and the machine it is meant for."""
        return Recording([commands], Profile(profile) if isinstance(profile, str) else profile,
                         width, height)

    def expect(self, actual: Recording | Machine, golden: str | os.PathLike[str]) -> None:
        """As expect_passes_equal."""
        expect_passes_equal(actual, golden, update=self.update, test=self.test)


@pytest.fixture
def goldens(request: pytest.FixtureRequest) -> Iterator[Goldens]:
    """The goldens of this test, which `--gw-update-goldens` writes."""
    update = bool(request.config.getoption("--gw-update-goldens", False)) or updates_goldens()
    yield Goldens(request.node.name, update)


def updates_goldens() -> bool:
    """Whether GW_UPDATE_GOLDENS asks for goldens to be written."""
    return os.environ.get("GW_UPDATE_GOLDENS", "") not in ("", "0")


def output_folder() -> Path:
    """The folder for pictures of failures: GW_TESTING_OUTPUT, or gw-testing here."""
    return Path(os.environ.get("GW_TESTING_OUTPUT") or "gw-testing")


def expect_passes_equal(
    actual: Recording | Machine,
    golden: str | os.PathLike[str] | Recording,
    *,
    update: bool | None = None,
    test: str | None = None,
) -> None:
    """Fails unless after every pass all planes and counters are as expected: those of a golden
    file, on both machines, or of another recording. A machine must have been made with record=True.
    The failure names pass, plane, pixel, both values, the stage, and pictures of the plane."""
    __tracebackhide__ = True
    name = test or _test_name()
    recording = actual if isinstance(actual, Recording) else actual.recording()
    if isinstance(golden, Recording):
        _fail_on(golden.compare(recording), name, "the other recording")
        return
    golden = Path(golden)
    if updates_goldens() if update is None else update:
        golden.parent.mkdir(parents=True, exist_ok=True)
        recording.save_manifest(golden)
        return
    try:
        difference = recording.verify(golden)
    except Error as error:
        pytest.fail(f"{error}\nA golden is written by pytest --gw-update-goldens", pytrace=False)
    if difference is not None:
        _fail_on(difference, f"{name}-{golden.stem}", str(golden), recording)
    _fail_on(recording.compare_machines(), name, "the two machines differ")


def expect_planes_equal(actual: Any, expected: Any, plane: str = "plane") -> None:
    """Fails unless two arrays have the same bits; names the worst pixel, row 0 at the bottom."""
    __tracebackhide__ = True
    import numpy as np

    a, b = np.asarray(actual), np.asarray(expected)
    if a.shape != b.shape:
        pytest.fail(f"{plane}: shape {a.shape}, expected {b.shape}", pytrace=False)
    if a.ndim not in (2, 3) or a.dtype.kind not in "biuf" or b.dtype.kind not in "biuf":
        raise TypeError(f"{plane}: shape {a.shape} of {a.dtype} and {b.dtype}; expected numbers of "
                        "shape (height, width) or (height, width, channels)")
    differs = (a != b) & ~((a != a) & (b != b))  # not a number equals itself
    if not differs.any():
        return
    off = np.where(differs, np.abs(a.astype(np.float64) - b.astype(np.float64)), 0)
    off = np.where(np.isnan(off), np.inf, off)
    per_pixel, count = off, int(differs.sum())
    if off.ndim == 3:
        per_pixel, count = off.sum(axis=2), int(differs.any(axis=2).sum())
    y, x = np.unravel_index(int(per_pixel.argmax()), per_pixel.shape)
    pytest.fail(
        f"{plane}: {count} pixels differ; the worst, {x} {y}: "
        f"expected {b[y, x].tolist()}, got {a[y, x].tolist()}",
        pytrace=False,
    )


def _fail_on(difference: Difference | None, name: str, what: str, recording: Recording
             | None = None) -> None:
    __tracebackhide__ = True
    if difference is None:
        return
    lines = [f"{what}: {difference.text.rstrip()}"]
    folder = output_folder()
    folder.mkdir(parents=True, exist_ok=True)
    if recording is not None:
        kept = folder / f"{name}.gwt"
        recording.save(kept)
        lines.append(f"recording:\n  {kept}")
        if difference.pixel is not None:
            x, y = difference.pixel
            lines.append(f"  gw pixel {kept} {x} {recording.height - 1 - y}")
    number = "" if difference.pass_number is None else f"-pass{difference.pass_number}"
    pictures = difference.save_pictures(str(folder / f"{name}{number}"))
    if pictures:
        lines.append("pictures:\n  " + "\n  ".join(pictures))
    pytest.fail("\n".join(lines), pytrace=False)


def _test_name() -> str:
    current = os.environ.get("PYTEST_CURRENT_TEST", "test").split(" ")[0]
    return re.sub(r"[^\w.-]+", "_", current.split("/")[-1])
