"""The machine of 1991 in Python: command lists in, planes and counters out, exact to the bit.

    import gw
    machine = gw.Machine("vgx", 64, 64)
    commands = gw.CommandList()
    commands.clear(color=(0, 0, 0.5, 1), depth=1)
    machine.execute(commands)
    gw.picture(machine.color).save("blue.png")

Rows count from the bottom, as in OpenGL; a picture turns them. docs/python.md is the guide.
"""
from pkgutil import extend_path
from typing import TYPE_CHECKING

# flatc puts the modules of recording.fbs into gw.gwt, in another folder.
__path__ = extend_path(__path__, __name__)

from ._gw import *
from ._gw import Error as Error
from . import conformance as conformance, hidden as hidden
from .pictures import Picture as Picture, picture as picture
from .rendering import render as render

if TYPE_CHECKING:
    from . import testing as testing
else:

    def __getattr__(name):
        """gw.testing, which needs pytest, at its first use."""
        if name != "testing":
            raise AttributeError(f"module 'gw' has no attribute '{name}'")
        from importlib import import_module

        return import_module(".testing", __name__)


__version__ = "0.1.0"
