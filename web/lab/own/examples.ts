// Programs to begin with: algorithms that speak the protocol of `gw play`.

import type { Language } from './program';
import { pythonExamples } from './python_examples';

const javascriptExamples: Readonly<Record<string, string>> = {
  painter: `// A painter's algorithm: sorts by the farthest corner, draws far to near.
const depth = (polygon) => Math.max(...polygon.outline.flat().map(([x, y, z]) => z));

const farToNear = scene.polygons
  .filter((polygon) => polygon.outline.length > 0)
  .sort((a, b) => depth(b) - depth(a));

step({ kind: "sort", pieces: farToNear.map((p) => String(p.id)),
       test: "farthest corner", result: "sorted", values: { z: farToNear.map(depth) } });
for (const polygon of farToNear) step({ kind: "draw", pieces: [String(polygon.id)] });
`,
  'z-buffer': `// A Z-buffer, a row of pixels at a time: a nearer depth wins.
const { size: [width, height], unit } = scene;
const z = new Float64Array(width * height).fill(Infinity);

// The pixels of a convex outline whose middles lie in it, in row y.
function run(outline, y) {
  const middle = (y + 0.5) * unit, x = [];
  outline.forEach((p, i) => {
    const q = outline[(i + 1) % outline.length];
    if (p[1] <= middle !== q[1] <= middle)
      x.push(p[0] + ((middle - p[1]) / (q[1] - p[1])) * (q[0] - p[0]));
  });
  if (x.length < 2) return [0, 0];
  const pixel = (v) => Math.min(width, Math.max(0, Math.ceil(v / unit - 0.5)));
  return [pixel(Math.min(...x)), pixel(Math.max(...x))];
}

for (const polygon of scene.polygons)
  for (const piece of polygon.pieces) {
    if (!piece.plane) continue;
    const [a, b, , d] = piece.plane, painted = [];
    for (const outline of piece.outline)
      for (let y = 0; y < height; ++y) {
        const [x0, x1] = run(outline, y);
        for (let x = x0; x < x1; ++x) {
          const depth = -(a * (x + 0.5) * unit + b * (y + 0.5) * unit + d);
          if (depth >= z[y * width + x]) continue;
          z[y * width + x] = depth;
          painted.push([y, x, x + 1, polygon.id]);
        }
      }
    step({ kind: "draw", pieces: [piece.name], painted });
  }
`,
  'back-face': `// Draws what faces the eye, in the order of the scene: right for one convex body only.
function area(outline) {  // signed, in the window: y grows downwards
  let sum = 0;
  outline.forEach((p, i) => {
    const q = outline[(i + 1) % outline.length];
    sum += p[0] * q[1] - q[0] * p[1];
  });
  return sum;
}

for (const polygon of scene.polygons) {
  const sum = polygon.outline.reduce((s, outline) => s + area(outline), 0);
  step({ kind: "compare", pieces: [String(polygon.id)], test: "signed area",
         result: sum < 0 ? "faces the eye" : "turned away", values: { area: sum } });
  if (sum < 0) step({ kind: "draw", pieces: [String(polygon.id)] });
}
`,
};

export const examples: Readonly<Record<Language, Readonly<Record<string, string>>>> = {
  javascript: javascriptExamples,
  python: pythonExamples,
};
