// Every algorithm in ten to twenty lines, "line | what lights it": the tests of the steps that it
// stands for, or single answers of them ("split.none"). Answers of opposite meaning light two
// lines, or a question, which then shows its yes or no. More spaces: inside.
const painter = (key: string): string => `
for each polygon P in the window:
  compute where its corners are
  key(P) := ${key}
sort the list by key
  compare two keys at a time
    greater: the polygon counts as farther | distance.farther
    not greater: their order stays | distance.not-farther
  the list is now far to near | distance.sorted
for each polygon P, far to near:
  paint all its pixels over the picture | draw
no test asks whether the order is right`;

const tree = `
build(list of pieces):
  choose a piece; its plane makes a node | tree-node
  for each other piece:
    crosses the plane: cut it in two | split.plane
    before it: to the front list; else to the back list
  build(front list); build(back list)`;

const cellsHide = (what: string): string =>
  `pyramid-${what}.hidden pyramid-${what}.hidden-by-cells`;

const texts: Record<string, string> = {
  'back-face': `
for each polygon P:
  N := normal, from which the corners run counter-clockwise
  if lines of sight are parallel: D := N·d
  else: D := (P_E - P_i)·N
  if D > 0: P faces the eye | facing.front facing-parallel.front
  if D < 0: P looks away, leave it out | facing.back facing-parallel.back
  if D = 0: on edge, leave it out | facing.edge-on facing-parallel.edge-on
  if it faces the eye:
    draw all its pixels | draw
polygons before others are not looked for`,
  'painter-nearest': painter('distance of the nearest corner'),
  'painter-farthest': painter('distance of the farthest corner'),
  'painter-centroid': painter('distance of the centroid'),
  newell: `
sort all polygons by their farthest corners | farthest-corner.sorted
while the list has polygons:
  P := the farthest
  for each other Q, until P may precede all:
    is all of Q nearer in depth than P? | z-extents
    1: are they apart in x? | 1-x-extents
    2: are they apart in y? | 2-y-extents
    3: is P wholly behind the plane of Q? | 3-behind
    4: is Q wholly before the plane of P? | 4-before
    5: are their outlines apart? | 5-projections
    the other way round: is Q behind P? | 3'-behind
    or is P before Q? | 4'-before
      then move Q to the far end and mark it | farthest-corner.moved
    Q is marked already: a cycle | marks
    no order: cut one by the plane of the other | split.seen-plane
    neither can be cut: no order is found | split.none
  draw P | draw`,
  bsp: `${tree}
draw(node):
  eye in front: the back comes first | eye-side.front eye-side.front-parallel
  eye behind it: the front comes first | eye-side.back eye-side.back-parallel
  draw(far side)
  draw the pieces in the node's plane | draw
  draw(near side)`,
  'scan-line': `
edge table: polygons by their top lines | edge-table
for each line y, from the top:
  add polygons that begin, drop those that end
  segments := the polygons between their edges | active-edges
  sort the ends in x
  for each sample span between two ends:
    one segment: it is seen | span.one
    one is nearest at both ends: it is seen | span.one-nearest
    they cross: compare z at every pixel | span.they-cross
  draw the line | draw
  move every edge one line down`,
  'z-buffer': `
for each pixel:
  Z := farthest depth; colour := background
for each polygon P, in any order:
  for each triangle, row and pixel of P: | z-buffer.some
    z := depth of P at the pixel's centre
    if z < Z: | z.nearer z-buffer.all
      Z := z
      colour := colour of P | draw
    else: | z.not-nearer z-buffer.none
      nothing is written`,
  'ray-casting': `
for each row from the top:
  for each pixel:
    R := the ray through its centre
    for each triangle:
      does R meet it, and at which z?
    meets none: the background | ray.background
    meets one: it is seen | ray.one
    meets several: the least z is seen | ray.nearest
    keep the polygon's pixel
  draw the row | draw`,
  schumacker: `
divide(faces):
  a plane between them? two nodes | cluster.separated
  all orders without a cycle? a cluster | cluster.ranked
    number its sides: priorities for every eye
  else: cut some by the plane of one | split.plane
  divide(front); divide(back)
draw(node):
  eye in front: the back node comes first | eye-side.front eye-side.front-parallel
  eye behind: the front node comes first | eye-side.back eye-side.back-parallel
  of a cluster, sides that the eye sees, by priority | priority
    draw the face | draw`,
  warnock: `
visit(window, faces):
  drop faces that are outside
  drop faces behind one that surrounds it | window.hidden
  no face left: background | window.empty
  one face reaches in: draw it | window.one-face
  one surrounds it before all: draw it | window.surrounded
  else:
    divide the window into four | window.divided
    visit each of the four
visit(whole picture, all faces)
draw what the windows found | draw`,
  bouknight: `
edges by their top lines
for each line y, from the top:
  add edges that begin, drop those that end
  mend the order in x by exchanges | active-edges
  for each span between two crossings:
    no face over it: background
    one face: it is seen | span.one
    nearest at both ends: it is seen | span.one-nearest
    another at the right end: they pierce | span.pierce
      find the implied edge, divide there | implied-edge
  draw the line | draw`,
  watkins: `
faces by their top lines
for each line y, from the top:
  mend the order of the segments | active-edges
  left := first pixel
  while left is in the picture:
    guess the end of the span from the line above
    no segment: background | sample-span.background
    the nearest stays nearest: the guess holds | sample-span.as-guessed
    another comes before it: the span is shorter | sample-span.shorter
    left := end of the span
  draw the line | draw`,
  'weiler-atherton': `
sort all polygons by their nearest corners | nearest-corner
sort out(list):
  C := the nearest that has not clipped yet
  for each other polygon P:
    cut P by the outline of C | split.outline
    the part outside goes to the rest
    inside and behind C: hidden | inside.hidden
    inside and before C: C was no choice, sort again | inside.before
    on both sides: they pierce | inside.pierces
      keep the part before C | split.pierced
  sort out(inside); sort out(rest)
  nothing is before it: draw it | draw`,
  'a-buffer': `
for each polygon P:
  for each pixel that P touches:
    mask := its points among 32
    add a fragment: mask, depth, colour | fragments
for each pixel:
  sort its fragments near to far
  free := all 32 points
  for each fragment:
    it gets its free points; take them away | points
  colour := sum of the shares
draw the polygon with the largest share | draw`,
  'hierarchical-z': `
put all polygons into an octree of cubes
pyramid := farthest depth at each pixel and level
visit(cube):
  outside the window: return | pyramid-cube.outside
  all cells over it nearer: hidden, return | ${cellsHide('cube')}
  else it may be seen | pyramid-cube.may-be-seen
  for each polygon P of the cube:
    outside the window: next P | pyramid-polygon.outside
    all cells over it nearer: hidden, next P | ${cellsHide('polygon')}
    else P may be seen | pyramid-polygon.may-be-seen
    for each pixel of P: if z < Z: Z := z
      draw it, mend the pyramid above | draw
  visit its eight parts, near to far
visit(cube of the whole scene)`,
  quake: `${tree}
walk the tree far to near:
  eye in front: the back comes first | eye-side.front eye-side.front-parallel
  eye behind it: its front comes first | eye-side.back eye-side.back-parallel
  give every piece a key: smaller is nearer | key
for each line y, from the top:
  edges of all pieces, sorted in x | active-edges
  leading edge: put its piece on the stack by key
  trailing edge: take its piece off
  the piece on top is seen from here | surface-stack.top
  the stack is empty: background from here | surface-stack.empty
  draw the spans | draw`,
  appel: `
contour edges: between a front and a back face
for each connected set of lines:
  count the faces before a first corner
  for each line from a known corner:
    sort its crossings with contour edges
    number := that of the corner, or counted again
    a contour, in behind it: number up | contour.more
    a contour, out from behind it: number down | contour.fewer
    through a face to its back: number up | pierced.more
    through a face to its front: number down | pierced.fewer
    number 0 all along: visible | carried.visible compared.visible
    number nowhere 0: hidden | carried.hidden compared.hidden
    else: visible where it is 0 | carried.parts compared.parts
    draw the visible parts | draw`,
  roberts: `
bodies := convex solids, and single faces
for each line:
  between two back faces: leave it out
  hidden := empty
  for each body:
    boxes apart in the window: next
    clip the line by all its planes, to the eye
    add the interval that is behind | body
  visible := the rest of the line
  all of the line: nothing hides it | bodies.visible
  nothing: the line is hidden | bodies.hidden
  else: visible in parts | bodies.parts
  draw the visible parts | draw`,
  'floating-horizon': `
upper := lowest, lower := highest at every x
for each row of the grid, near to far:
  for each line of the row, and to the row before:
    project it: heights at its x
    hidden := between the two horizons
    beyond a horizon all along: visible | horizon.visible
    between the horizons all along: hidden | horizon.hidden
    else: visible in parts | horizon.parts
    draw the visible parts | draw
  upper := greater of upper and the row
  lower := smaller of lower and the row`,
};

export interface CodeLine {
  readonly text: string;
  /** Spaces before it. */
  readonly indent: number;
  /** "test" or "test.result". */
  readonly lit: readonly string[];
  /** Its answers, yes and no, light the same line. */
  readonly isQuestion: boolean;
}

function lineOf(text: string): CodeLine {
  const [line = '', lit = ''] = text.split('|').map((part) => part.trim());
  return {
    text: line,
    indent: text.search(/\S/),
    lit: lit.split(' ').filter((word) => word !== ''),
    isQuestion: line.endsWith('?'),
  };
}

const parsed = new Map(
  Object.entries(texts).map(([name, text]) => [
    name,
    text
      .split('\n')
      .filter((line) => line.trim() !== '')
      .map(lineOf),
  ]),
);

export const codeNames: readonly string[] = [...parsed.keys()];

/** Of an algorithm by name; empty for one that the project does not know. */
export function pseudoCode(algorithm: string): readonly CodeLine[] {
  return parsed.get(algorithm) ?? [];
}

/** The line that a step stands for; -1: none. */
export function litLine(
  code: readonly CodeLine[],
  step: { readonly test: string; readonly result: string } | undefined,
): number {
  if (!step) return -1;
  const exact = code.findIndex((line) => line.lit.includes(`${step.test}.${step.result}`));
  return exact >= 0 ? exact : code.findIndex((line) => line.lit.includes(step.test));
}
