"""Scenes of the oracle's own: polygons of three to six corners, some bent, in one plane, piercing,
seen from the back or from the edge, or outside the picture; and hills seen along parallel lines."""
import math

CORNERS = """
-3 -2 -2  3 -2 -2  4 0.3 -2  2.5 2.2 -2  -2 2.5 -2  -3.6 0.5 -2
-2 -1.2 -3  0.4 -1.6 0.5  1.5 0.2 1  0.3 1.7 -0.2  -1.7 0.9 -2.5
-2.2 -0.4 0.2  1.9 -0.7 -0.6  2.3 1.1 0.9  -1.6 1.2 -0.3
1.4 -1.9 -1  3.3 -1.5 0.5  2.6 1.4 1.2
-0.5 -1 -1  0.5 1 -1  0.25 0.5 1.5
-3.1 -1.4 -1  -3 1.3 -1  -1.2 1.1 -1.7
20 1 -1  21 1 -1  20 2 -1.5
-1.4 -2.1 -2  1.2 -2.2 -2  0.1 -0.9 -2
-0.6 -0.4 -4  0.5 -0.5 -4  0.1 0.4 -4
0.9 -0.2 -4  1.3 -0.3 -4.5  1.2 0.3 -4
-1.3 -0.2 -4  -0.9 -0.3 -4.5  -1 0.3 -4
7 -1 -1  12 -1 -1  9 0 -1
"""
POLYGONS = (6, 5, 4, 3, 3, 3, 3, 3, 3, 3, 3, 3)
# So many so near each other behind the first that the octree has a small cube for them.
for i in range(9):
    CORNERS += " ".join(f"{x} {y} {-3.5 - i / 256} " for x, y in
                        ((-1.64, 0.79), (-1.61, 0.79), (-1.64, 0.82)))
    POLYGONS += (3,)

VIEW = """name = "{name}"
[camera]
eye = [0, 0, 9]
at = [0, 0, 0]
{lens}
[[light]]
direction = [-0.4, -0.5, -0.8]
[[object]]
{shape}
"""


def heights():
    across = [v / 4 - 1.5 for v in range(13)]
    rows = [[round(0.4 * math.sin(2 * x) * math.cos(3 * z), 3) for x in across] for z in across]
    return f'shape = "height_field"\nx = {across}\nz = {across}\nheights = {rows}'


def write(folder):
    """{name: file}"""
    numbers = CORNERS.split()
    obj, next_corner = [], 1
    for i in range(0, len(numbers), 3):
        obj.append("v " + " ".join(numbers[i:i + 3]))
    for size in POLYGONS:
        obj.append("f " + " ".join(str(next_corner + i) for i in range(size)))
        next_corner += size
    (folder / "mixed.obj").write_text("\n".join(obj) + "\n", encoding="utf8")
    found = {}
    for name, lens, shape in (("mixed", "fov = 32", 'file = "mixed.obj"'),
                              ("mixed_parallel", "ortho = 5", 'file = "mixed.obj"'),
                              ("hills_parallel", "ortho = 4", heights())):
        text = VIEW.format(name=name, lens=lens, shape=shape)
        if shape[0] == "s":
            text = text.replace("eye = [0, 0, 9]", "eye = [3, 2, 9]")
        found[name] = folder / f"{name}.toml"
        found[name].write_text(text, encoding="utf8")
    return found
