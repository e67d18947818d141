"""Pictures of scenes, as `gw render` draws them."""
from __future__ import annotations

import os
from typing import Any

from ._gw import Camera, Machine, Renderer, RendererName, Scene, read_passes


def render(
    scene: Scene | str | os.PathLike[str],
    width: int = 640,
    height: int = 480,
    renderer: RendererName | str = "multipass",
    camera: Camera | None = None,
    **options: Any,
) -> Machine:
    """Draws a scene, or that of a file with its own passes; the machine has the picture in its
    colour plane, and the passes' counters. Options are those of Renderer."""
    if not isinstance(scene, Scene):
        file = scene
        scene = Scene.open(file)
        if renderer in ("multipass", RendererName.multipass):
            options.setdefault("passes", read_passes(file))
    drawer = Renderer(scene, width, height, renderer, **options)
    drawer.draw(camera)
    return drawer.machine
