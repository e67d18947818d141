"""Runs `gw hidden --steps` and reads the log. Steps are handed to oracles without their values:
what an oracle expects cannot depend on what was said."""
import json
import pathlib
import subprocess

from oracle.camera import Camera


class Run:
    def __init__(self, gw, scene, algorithm, level, size, folder):
        self.scene, self.algorithm, self.level = scene.stem, algorithm, level
        self.name = f"{scene.stem}, {algorithm}, {level}"
        to = pathlib.Path(folder) / f"{scene.stem}_{algorithm}_{level}"
        subprocess.run([gw, "hidden", scene, "--algorithm", algorithm, "--level", level, "--size",
                        size, "--steps", to, "--quiet"], check=True, stdout=subprocess.DEVNULL)
        with open(to / "steps.jsonl", encoding="utf8") as file:
            self.header = json.loads(file.readline())
            self.steps = [json.loads(line) for line in file]
        self.end = self.steps.pop()
        self.words = self.header["words"]
        self.camera = Camera(self.header)
        self.polygons = {p["id"]: p for p in self.header["polygons"]}


class Said:
    """What a step says besides its numbers."""

    def __init__(self, step):
        self.number, self.test, self.result = step["step"], step["test"], step["result"]
        self.pieces = step.get("pieces", [])
        self.made = step.get("made", [])
        self.painted = step.get("painted", [])
        self.line = step.get("line")
        self.window = step.get("window")


def polygon_of(name):
    """The polygon's number of a piece: 3 of 3.1ab."""
    return int(name.rstrip("ab").split(".")[0])
