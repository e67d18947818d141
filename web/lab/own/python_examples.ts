// The programs to begin with in Python: those of examples.ts, by the same names.

export const pythonExamples: Readonly<Record<string, string>> = {
  painter: `# A painter's algorithm: sorts by the farthest corner, draws far to near.
def depth(polygon):
    return max(z for outline in polygon["outline"] for x, y, z in outline)

far_to_near = sorted((p for p in scene["polygons"] if p["outline"]),
                     key=lambda p: (-depth(p), p["id"]))

step(kind="sort", pieces=[str(p["id"]) for p in far_to_near],
     test="farthest corner", result="sorted", values={"z": [depth(p) for p in far_to_near]})
for polygon in far_to_near:
    step(kind="draw", pieces=[str(polygon["id"])])
`,
  'z-buffer': `# A Z-buffer, a row of pixels at a time: a nearer depth wins.
import math
width, height = scene["size"]
unit = scene["unit"]
z = [math.inf] * (width * height)

# The pixels of a convex outline whose middles lie in it, in row y.
def run(outline, y):
    middle, x = (y + 0.5) * unit, []
    for i, p in enumerate(outline):
        q = outline[(i + 1) % len(outline)]
        if (p[1] <= middle) != (q[1] <= middle):
            x.append(p[0] + ((middle - p[1]) / (q[1] - p[1])) * (q[0] - p[0]))
    if len(x) < 2:
        return 0, 0
    pixel = lambda v: min(width, max(0, math.ceil(v / unit - 0.5)))
    return pixel(min(x)), pixel(max(x))

for polygon in scene["polygons"]:
    for piece in polygon["pieces"]:
        if not piece.get("plane"):
            continue
        a, b, _, d = piece["plane"]
        painted = []
        for outline in piece["outline"]:
            for y in range(height):
                x0, x1 = run(outline, y)
                for x in range(x0, x1):
                    depth = -(a * (x + 0.5) * unit + b * (y + 0.5) * unit + d)
                    if depth >= z[y * width + x]:
                        continue
                    z[y * width + x] = depth
                    painted.append([y, x, x + 1, polygon["id"]])
        step(kind="draw", pieces=[piece["name"]], painted=painted)
`,
  'back-face': `# Draws what faces the eye, in the order of the scene: right for one convex body only.
def area(outline):  # signed, in the window: y grows downwards
    total = 0
    for i, p in enumerate(outline):
        q = outline[(i + 1) % len(outline)]
        total += p[0] * q[1] - q[0] * p[1]
    return total

for polygon in scene["polygons"]:
    total = sum(area(outline) for outline in polygon["outline"])
    step(kind="compare", pieces=[str(polygon["id"])], test="signed area",
         result="faces the eye" if total < 0 else "turned away", values={"area": total})
    if total < 0:
        step(kind="draw", pieces=[str(polygon["id"])])
`,
};
