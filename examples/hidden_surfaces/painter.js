// A painter's algorithm in JavaScript: sorts by the mean of the corners and draws far to near.
//
//     gw play scenes/hidden/cycle.toml --polygons polygons.json
//     node examples/hidden_surfaces/painter.js polygons.json > steps.jsonl
//     gw play scenes/hidden/cycle.toml steps.jsonl --steps played

const { readFileSync } = require("fs");

/** z of the mean of the corners in the window; larger is farther. */
function depth(polygon) {
  const corners = polygon.outline.flat();
  return corners.reduce((sum, [, , z]) => sum + z, 0) / corners.length;
}

const step = (members) => console.log(JSON.stringify(members));

const { polygons } = JSON.parse(readFileSync(process.argv[2], "utf8"));
const farToNear = polygons
  .filter((polygon) => polygon.outline.length > 0)
  .sort((a, b) => depth(b) - depth(a));

step({
  kind: "sort",
  test: "mean of the corners",
  result: "sorted",
  pieces: farToNear.map((polygon) => String(polygon.id)),
  values: { z: farToNear.map(depth) },
});
for (const polygon of farToNear) step({ kind: "draw", pieces: [String(polygon.id)] });
