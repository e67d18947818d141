"""OpenGL of Python programs on the machine, off the screen: import this before PyOpenGL.

    import gw.osmesa            # says in one line on stderr what it did
    import OpenGL.GL            # or mujoco, trimesh, pyrender: what draws by PyOpenGL on OSMesa

It sets PYOPENGL_PLATFORM and MUJOCO_GL to osmesa. When ctypes is asked for a libOSMesa, it loads
gw's. Raises ImportError if there is no library, or if it comes too late.
"""
from __future__ import annotations

import ctypes
import os
import re
import sys
from pathlib import Path
from typing import Any

__all__ = ["library"]

_NAME = "libOSMesa.so.8"


def _find() -> Path:
    package = Path(__file__).resolve().parent
    folders = [
        package / "opengl",  # a wheel
        package.parents[1] / "lib/opengl",  # the build tree
        *sorted(package.parents[2].glob("*-linux-gnu*/gw/opengl")),  # Debian's package gw
    ]
    for folder in folders:
        if (folder / _NAME).exists():
            return folder / _NAME
    raise ImportError(f"gw.osmesa: no {_NAME} in {', '.join(map(str, folders))}; expected a build "
                      "with gl/, or the package gw")


def _load() -> Path:
    if "OpenGL.platform" in sys.modules:
        raise ImportError("gw.osmesa: OpenGL is loaded already; expected import gw.osmesa before it")
    path = _find()
    load = ctypes.CDLL.__init__

    def load_ours(self: ctypes.CDLL, name: Any, *words: Any, **more: Any) -> None:
        asked = isinstance(name, str) and re.fullmatch(r"(lib)?OSMesa(\.so[.\d]*)?", name)
        load(self, str(path) if asked else name, *words, **more)

    setattr(ctypes.CDLL, "__init__", load_ours)
    os.environ["PYOPENGL_PLATFORM"] = os.environ["MUJOCO_GL"] = "osmesa"
    print(f"gw.osmesa: OpenGL is drawn by {path}", file=sys.stderr)
    return path


library = _load()
