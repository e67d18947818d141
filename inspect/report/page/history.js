// Histories of pixels. They lie in scripts of 64 x 64 pixels, loaded when one is asked for: a page that was
// opened from disk may run scripts but may not fetch files. Does not show anything: report.js does.
"use strict";

const gw_tiles = new Map();  // name of a tile -> {promise, resolve}

// Called by a tile's script. Rows: [pixel, how many, command, change], of a fragment also
// draw, primitive, polygon, fate, front, r, g, b, a, z.
function gw_history(name, tile) {
  gw_tiles.get(name).resolve(tile);
}

function tile_named(name) {
  if (gw_tiles.has(name)) return gw_tiles.get(name).promise;
  const entry = {};
  gw_tiles.set(name, entry);
  entry.promise = new Promise((resolve, reject) => {
    entry.resolve = resolve;
    const script = document.createElement("script");
    script.src = `history/${name}.js`;
    script.onerror = () => {
      gw_tiles.delete(name);
      reject(new Error(script.getAttribute("src")));
    };
    document.head.append(script);
  });
  return entry.promise;
}

// Values of all planes, those that `change` names replaced.
function changed_values(values, change) {
  if (!change) return values;
  return {
    color: change.c ?? values.color,
    depth: change.z ?? values.depth,
    stencil: change.s ?? values.stencil,
    accum: change.a ?? values.accum,
    back: change.b ?? values.back,
  };
}

function start_values(tile, pixel) {
  const zero = {color: [0, 0, 0, 0], depth: 0, stencil: 0, accum: [0, 0, 0, 0], back: [0, 0, 0, 0]};
  let first = 0;
  for (const [count, change] of tile.start) {
    if (pixel < first + count) return changed_values(zero, change);
    first += count;
  }
  return zero;
}

function fragment_of(row) {
  if (row.length === 4) return null;
  return {
    draw: row[4], primitive: row[5], polygon: row[6], fate: row[7], front: row[8] === 1,
    color: row.slice(9, 13), depth: row[13],
  };
}

// Everything that happened to a pixel, in order, as `gw pixel` prints it. Picture coordinates.
async function pixel_history(report, x, y) {
  const window_y = report.height - 1 - y, side = report.tile;
  const tile = await tile_named(`${Math.floor(x / side)}_${Math.floor(window_y / side)}`);
  const pixel = (window_y % side) * tile.width + (x % side);
  const events = [];
  let values = start_values(tile, pixel);
  for (const row of tile.rows) {
    if (pixel < row[0] || pixel >= row[0] + row[1]) continue;
    const before = values, fragment = fragment_of(row), last = events[events.length - 1];
    values = changed_values(values, row[3]);
    // A command that touches the pixel plane by plane is one event.
    if (!fragment && last && !last.fragment && last.command === row[2]) last.after = values;
    else events.push({command: row[2], fragment, before, after: values});
  }
  return events;
}
