"""The lecture's hidden-surface algorithms with their steps, and algorithms of one's own.

    run = gw.hidden.run(scene, "bsp")
    for step in gw.hidden.steps(run): print(step["sentence"])

    def painter(header):                        # header["polygons"]: docs/step_logs.md
        in_window = [p for p in header["polygons"] if p["outline"]]
        for polygon in sorted(in_window, key=lambda p: -p["farthest"]):
            yield {"kind": "draw", "pieces": [str(polygon["id"])]}
    mine = gw.hidden.play(scene, painter)       # graded: mine.counts()["wrong"], mine.grades()
    for spoilt in gw.hidden.blame(mine): print(spoilt["step"], spoilt["pixels"])
    gw.hidden.save_player(mine, "painter.html")
"""
from __future__ import annotations

import base64
import gzip
import json
import os
from pathlib import Path
from typing import Any, Callable, Iterable, Iterator, Mapping

from ._gw import (Camera, Error, HiddenRun, Profile, Scene, hidden_algorithms,
                  hidden_polygons_json, play_hidden)
from ._gw import run_hidden as run
from ._gw import write_file

__all__ = ["algorithms", "run", "steps", "polygons", "play", "blame", "save_player"]

_MARK = "<!-- data -->"
_MOST_STEPS = 2_000_000  # hiddensurface/interface/steps.h


def algorithms() -> dict[str, str]:
    """Titles by name, in the lecture's order."""
    return dict(hidden_algorithms())


def steps(run: HiddenRun, language: str = "en") -> Iterator[dict[str, Any]]:
    """The steps of a run as docs/step_logs.md describes them, each with its sentence."""
    for i in range(len(run)):
        step = json.loads(run.step_json(i))
        step["sentence"] = run.sentence(i, language)
        yield step


def polygons(
    scene: Scene, *, width: int = 320, height: int = 240, profile: Profile | str = "vgx",
    camera: Camera | None = None
) -> dict[str, Any]:
    """The polygons on the window grid with their planes, as `gw play --polygons` writes them."""
    text = hidden_polygons_json(scene, width=width, height=height, profile=profile, camera=camera)
    found: dict[str, Any] = json.loads(text)
    return found


def play(
    scene: Scene,
    algorithm: Callable[[dict[str, Any]], Iterable[Mapping[str, Any]]],
    *,
    width: int = 320,
    height: int = 240,
    profile: Profile | str = "vgx",
    camera: Camera | None = None,
) -> HiddenRun:
    """Runs an algorithm written in Python: it gets what `polygons` returns and yields steps. They
    are drawn by the machine, counted, and graded against the Z-buffer."""
    name = getattr(algorithm, "__name__", "mine")
    header = polygons(scene, width=width, height=height, profile=profile, camera=camera)
    lines = []
    for number, step in enumerate(algorithm(header), 1):
        if number > _MOST_STEPS:
            raise Error(f"{name}: step {number} is one too many; expected at most {_MOST_STEPS:,}")
        try:
            lines.append(json.dumps(step))
        except (TypeError, ValueError) as error:
            raise Error(
                f"{name}: step {number} is no JSON: {error}; expected a dict of plain values") from None
    return play_hidden(
        scene, "\n".join(lines) + "\n", name, width=width, height=height, profile=profile,
        camera=camera
    )


def blame(run: HiddenRun) -> list[dict[str, Any]]:
    """Who painted the wrong pixels last, by steps, as the end of a log has it (docs/step_logs.md)."""
    end = json.loads(run.log().rstrip("\n").rpartition("\n")[2])
    found: list[dict[str, Any]] = end.get("blame", [])
    return found


def save_player(run: HiddenRun, file: str | os.PathLike[str]) -> None:
    """Writes the run as an offline page, the player of `gw hidden --steps`."""
    page = Path(__file__).parent / "player.html"
    if not page.exists():
        raise Error("this build has no pages: Node was missing when it was made")
    packed = base64.b64encode(gzip.compress(run.log().encode(), 9, mtime=0)).decode()
    data = f'<script class="data" type="text/plain">{packed}</script>\n'
    before, mark, after = page.read_text(encoding="utf-8").partition(_MARK)
    if not mark:
        raise Error(f"player.html lacks '{_MARK}'")
    write_file(file, (before + data + after).encode())
