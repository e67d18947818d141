"""Claims: the command gives the answers of docs/manual/limits.md that are warnings or errors, row
by row, in a line that names what the row says."""
import os
import pathlib
import re
import subprocess

import pytest

SOURCE = pathlib.Path(__file__).parents[2]
SCENES = SOURCE / "scenes"
QUAD = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
FACE = "f 1 2 3 4\n"
WITH_NORMAL = "f 1//1 2//1 3//1 4//1\n"


def sphere(keys="", head=""):
    return {"s.toml": f'{head}[[object]]\nshape = "sphere"\nmaterial = "m"\n{keys}\n'
                      "[material.m]\nKd = 0.5\n"}


def model(mtl="", head="", faces=FACE):
    return {"s.obj": f"mtllib m.mtl\nusemtl a\n{head}{QUAD}{faces}", "m.mtl": f"newmtl a\n{mtl}"}


def room(keys, head=""):
    return {"s.toml": f'{head}[[object]]\nshape = "room"\nmaterial = "m"\n'
                      f"[material.m]\nKe = 1\n{keys}\n"}


def outline():
    at = [(0, 0), (4, 0.3), (4.5, 3), (1, 4), (0, 0)]
    points = [(p[0] + (q[0] - p[0]) * k / 50, p[1] + (q[1] - p[1]) * k / 50)
              for p, q in zip(at, at[1:]) for k in range(50)]
    return {"s.obj": "".join(f"v {x!r} {y!r} 0\n" for x, y in points)
                     + "f " + " ".join(str(i + 1) for i in range(200)) + "\n"}


# A row's first words, files, options of gw render, and what the line says.
RENDERED = [
    ("fitted near plane",
     model(faces=FACE + "v 0 0 -200000\nv 1 0 -200000\nv 0 1 -200000\nf 5 6 7\n"),
     "--eye 0,0,1 --at 0,0,0", "is cut off"),
    ("coordinates, planes and other lengths", sphere("translate = [1e19, 0, 0]"), "",
     "to 1e\\+18"),
    ("keys without effect", sphere(head="[[light]]\nposition = [0, 3, 0]\ncone = 30\n"), "",
     "cone"),
    ("colours of materials", model("Kd 255 100 20\n"), "", "warning: .*'s'.*255"),
    ("normals that look to the clockwise", model(head="vn 0 0 -1\n", faces=WITH_NORMAL), "",
     "warning: .*normals"),
    ("a fault in a material of MTL", model("Kd 1\nnewmtl b\nKd spectral x.rfl\n"), "",
     "warning: .*m.mtl:4"),
    ("coincident faces of two objects",
     model("Kd 1 0 0\nnewmtl b\nKd 0 1 0\n", "o a\n", FACE + "o b\nusemtl b\n" + FACE), "",
     "'a' and 'b' share a part of a plane"),
    ("numbers that are not finite", model(head="vn nan 0 0\n", faces=WITH_NORMAL), "", "finite"),
    ("maps on faces without texture coordinates", model(f"map_Kd {SCENES}/maps/granite.png\n"), "",
     "has no texture coordinates for granite.png"),
    ("normals of length 0", model(head="vn 0 0 0\n", faces=WITH_NORMAL), "", "warning: .*normal"),
    ("... that does not exist", {"s.obj": "mtllib gone.mtl\n" + QUAD + FACE}, "",
     "warning: .*gone.mtl"),
    ("pictures that MTL and glTF name", model("map_Kd gone.png\n"), "",
     "warning: .*m.mtl:2: map_Kd .*gone.png: no such file"),
    ("statements of other programs", model("bump b.png\n"), "", "warning: .*bump"),
    ("MTL values out of range", model("Ns -3\n"), "", "warning: .*Ns"),
    ("`illum` 0 and 1", model("Ks 1 1 1\nillum 1\n"), "", "warning: .*illum 1"),
    ("opacity 0", model("d 0\n"), "", "warning: .*'a'"),
    ("lengths of shapes", sphere("radius = 1e7"), "", "expected .*1e-0?6"),
    ("`fov`", sphere(), "--fov 0.01", "0.1"),
    ("rotations", sphere("rotate = [0, 1, 0, 1e6]"), "", "expected"),
    ("lines and points", {"s.obj": "v 0 0 0\nv 1 1 0\nl 1 2\n"}, "--renderer raytrace",
     "lines and points"),
    ("an effect that a renderer", sphere(head="[fog]\nstart = 1\nend = 9\n"), "--renderer scanline",
     "leaves out of this scene: fog"),
    ("a scene without visible objects", {"s.toml": ""}, "", "has nothing to draw"),
    ("a picture without a pixel", sphere(), "--eye 0,0,100 --at 0,0,200", "the picture is empty"),
    ("pictures", sphere(), "--size 5000x10", "4096"),
    ("samples", sphere(), "--samples 20000", "expected 1..16384"),
    ("facing of each triangle", outline(), "--size 320x240 --eye 3.2,1.8,6 --at 2.2,1.8,0",
     "polygon with 200 corners"),
]
SOLVED = [
    ("lights without area", room("Kd = 0.5", '[[light]]\nname = "key"\nposition = [0, 1, 0]\n'), "",
     "light 'key' is not in candela or lumen"),
    ("light that is not absorbed", room("Kd = 1"), "", "reflects 1 of its light"),
    ("texels", room("Kd = 0.5"), "--texels 100000", "expected"),
    ("reflectance", room("Kd = 2"), "", "expected"),
]


def said(folder, files, command):
    for name, text in files.items():
        (folder / name).write_text(text)
    scene = next(name for name in files if name.startswith("s."))
    words = command.split()
    run = subprocess.run([os.environ["GW"], words[0], scene, *words[1:]], cwd=folder,
                         capture_output=True, text=True, timeout=100)
    assert run.returncode in (0, 1, 2), run
    return run.stderr


def has_row(row):
    limits = (SOURCE / "docs/manual/limits.md").read_text()
    return re.search(r"^\| " + re.escape(row), limits, re.M)


@pytest.mark.parametrize("row, files, options, words", RENDERED, ids=[r[0] for r in RENDERED])
def test_a_picture_gets_the_answer_of_its_row(tmp_path, row, files, options, words):
    assert has_row(row)
    options = options if "--size" in options else "--size 64x48 " + options
    lines = said(tmp_path, files, "render -o x.png " + options)
    assert re.search(words, lines), lines


@pytest.mark.parametrize("row, files, options, words", SOLVED, ids=[r[0] for r in SOLVED])
def test_a_solution_gets_the_answer_of_its_row(tmp_path, row, files, options, words):
    assert has_row(row)
    options = options if "--texels" in options else "--texels 1 " + options
    lines = said(tmp_path, files, "radiosity -o out --size 32x24 --hemicube 16 " + options)
    assert re.search(words, lines), lines
