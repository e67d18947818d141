"""The machine of 1991 in Python: command lists in, planes and counters out, exact to the bit.

    import gw
    machine = gw.Machine("vgx", 64, 64)
    commands = gw.CommandList()
    commands.clear(color=(0, 0, 0.5, 1), depth=1)
    machine.execute(commands)
    gw.picture(machine.color).save("blue.png")

Rows count from the bottom, as in OpenGL; a picture turns them. docs/python.md is the guide.
"""
from typing import Any

from ._gw import *
from ._gw import Error
from . import hidden
from .pictures import Picture, picture


def render(
    scene: Scene,
    width: int = 640,
    height: int = 480,
    renderer: RendererName | str = "multipass",
    camera: Camera | None = None,
    **options: Any,
) -> Machine:
    """Draws a scene; the machine has the picture in its colour plane, and the passes' counters.
    Options are those of Renderer."""
    drawer = Renderer(scene, width, height, renderer, **options)
    drawer.draw(camera)
    return drawer.machine

__version__ = "0.1.0"
