// The scenes of the lab in groups, a line each: "file | line".
import type { Language } from './language';
import { nameOf } from './names';

const text = `
# Cases of hidden surfaces
hidden/cycle.toml | Three polygons in a cycle: none is farthest
hidden/five.toml | Five polygons, parallel lines of sight
hidden/ten.toml | Ten polygons
hidden/centroid_fails.toml | The order of centroids is wrong
hidden/two_undecidable.toml | Two polygons: all five tests say no
hidden/pierce.toml | Two polygons pierce each other
hidden/pinwheel.toml | A pinwheel of four bars: one cut
hidden/three_bars.toml | Three bars, each over the next
hidden/solids.toml | Solids, many small faces
hidden/ring.toml | A ring
hidden/ring_and_ball.toml | A ring and a ball
hidden/hills.toml | Hills over a grid, for hidden lines
# Passes: light, shadow, glass
rings_plain.toml | Three rings without a map
rings.toml | Red rings with a white gloss
coarse_rings.toml | Rings of few polygons
marble.toml | Marble: a map for each component
fog.toml | Fog and a glass vase
crystal.toml | Reflection and refraction maps
mirrors.toml | Maps that the machine draws itself
columns.toml | Three coloured lights with shadows
soft.toml | Soft shadows
glare.toml | Light around lamps
selective.toml | Lamps that light one object each
panes.toml | Panes that intersect
lamps.toml | A building with 100 lamps
focus.toml | Depth of field
planets.toml | A film: a planet turns and circles
motion.toml | Motion blur
edges.toml | Edges of every direction
penumbra.toml | Little but a soft shadow
styles.toml | A table of few polygons
teapot.toml | The Utah teapot
# Mirrors and rays
fig9.toml | A room with ten glossy objects
water.toml | A glass of water with a rod
facing_mirrors.toml | Two mirrors face to face
needles.toml | Needles thinner than a pixel
# Radiosity
radiosity/cornell.toml | The Cornell box
radiosity/room.toml | A room
radiosity/corridor.toml | A corridor
radiosity/mirror.toml | A room with a mirror
radiosity/office.toml | An office, its lamps in lumen
radiosity/sphere.toml | Inside a sphere
cornell.toml | The Cornell box, without radiosity
# Models alone
hidden/cycle.obj | Three triangles in a cycle
hidden/five.obj | Five polygons, one of them a wedge
hidden/ten.obj | Ten faces, large and small
hidden/centroid_fails.obj | A long rectangle and two small ones
hidden/two_undecidable.obj | A concave U and a bar across its arms
hidden/pierce.obj | Two rectangles that pierce each other
hidden/pinwheel.obj | Four bars in a pinwheel
hidden/three_bars.obj | Three bars, each over the next
models/cornell.obj | The Cornell box as it was measured
models/tumbler.obj | A tumbler with water
radiosity/corridor.obj | A corridor with a corner
`;

export interface NamedScenes {
  readonly title: string;
  readonly scenes: readonly { readonly name: string; readonly line: string }[];
}

const groups = text
  .trim()
  .split('# ')
  .slice(1)
  .map((group): NamedScenes => {
    const [title, ...lines] = group.trim().split('\n');
    const scenes = lines.map((line) => line.split(' | ') as [string, string]);
    return { title: title!, scenes: scenes.map(([name, line]) => ({ name, line })) };
  });

/** The scenes that are there, by group; those without a line come last, under `rest`. */
export function grouped(names: readonly string[], language: Language, rest: string): NamedScenes[] {
  const there = new Set(names);
  const found = groups.map(({ title, scenes }) => ({
    title: nameOf('scene', title, language),
    scenes: scenes
      .filter(({ name }) => there.has(name))
      .map(({ name, line }) => ({ name, line: nameOf('scene', line, language) })),
  }));
  const known = new Set(groups.flatMap(({ scenes }) => scenes.map(({ name }) => name)));
  // The model of a scene that is there is not another scene.
  const isModel = (name: string): boolean =>
    name.endsWith('.obj') && there.has(name.replace(/obj$/, 'toml'));
  const others = names
    .filter((name) => !known.has(name) && !isModel(name))
    .map((name) => ({ name, line: '' }));
  return [...found, { title: rest, scenes: others }].filter(({ scenes }) => scenes.length > 0);
}

/** What a language translates. */
export const sceneLines: readonly string[] = groups.flatMap(({ title, scenes }) => [
  title,
  ...scenes.map(({ line }) => line),
]);
