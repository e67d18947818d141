// Pictures and numbers that commands of gw make while the page is built: the frames of a film.
// SCENES and OUT in a command are the folders of the scenes and of what it writes. Like figures.ts,
// the build reads this table too.

export interface Frame {
  /** A text names it "show/ID". */
  readonly id: string;
  readonly title: string;
  /** A PNG in OUT. */
  readonly picture: string;
  /** Its numbers: rows of a table in OUT that begin with these words, added up. */
  readonly table: string;
  readonly row: string;
}

export interface FilmFigure {
  readonly commands: readonly string[];
  readonly frames: readonly Frame[];
  /** The exhibit of the lab that has the same. */
  readonly exhibit: string;
}

const size = '--size 200x150 --quiet';
const box = 'radiosity SCENES/radiosity/cornell.toml --size 150x150 --texels 0.04 --patch 8';
const shots = '--hemicube 64 --no-ambient --gamma 2.2 --quiet';
const frame = (id: string, title: string, picture: string, table: string, row: string): Frame => ({
  id,
  title,
  picture,
  table,
  row,
});
const shot = (folder: string, count: number, title: string): Frame =>
  frame(
    `after-${count}`,
    title,
    `${folder}/shot_${String(count).padStart(6, '0')}.png`,
    `${folder}/convergence.csv`,
    String(count),
  );

export const films: Readonly<Record<string, FilmFigure>> = {
  components: {
    commands: [
      `render SCENES/rings.toml --renderer hardware -o OUT/hardware.png --counters OUT/hardware.json ${size}`,
      `render SCENES/rings.toml -o OUT/picture.png --components OUT --counters OUT/passes.json ${size}`,
    ],
    exhibit: 'passes&scene=rings.toml',
    frames: [
      frame('ambient', 'Ambient', 'ambient.png', 'passes.json', 'ambient'),
      frame('diffuse', 'Diffuse', 'diffuse.png', 'passes.json', 'diffuse'),
      frame('specular', 'Specular', 'specular.png', 'passes.json', 'specular'),
      frame('sum', 'The sum', 'picture.png', 'passes.json', ''),
      frame('one-pass', 'One pass', 'hardware.png', 'hardware.json', ''),
    ],
  },
  mask: {
    commands: [
      `render SCENES/styles.toml --shadow none -o OUT/none.png --counters OUT/none.json ${size}`,
      `render SCENES/styles.toml -o OUT/picture.png --planes OUT --counters OUT/passes.json ${size}`,
    ],
    exhibit: 'passes&scene=styles.toml',
    frames: [
      frame('unshadowed', 'Without shadows', 'none.png', 'none.json', 'diffuse window'),
      frame('stencil', 'The stencil', 'stencil.png', 'passes.json', 'shadow window'),
      frame('shadowed', 'With shadows', 'picture.png', 'passes.json', 'diffuse window'),
    ],
  },
  items: {
    commands: [
      `render SCENES/fig9.toml -o OUT/rays.png --planes OUT ${size}`,
      `render SCENES/fig9.toml -o OUT/maps.png --reflections maps ${size}`,
      `compare SCENES/fig9.toml -o OUT/compare ${size}`,
      `study passes SCENES/fig9.toml --sweep samples=1 --runs 0 -o OUT/study ${size}`,
    ],
    exhibit: 'rays&scene=fig9.toml',
    frames: [
      frame('items', 'Item buffer', 'ids.png', 'study/counts.csv', 'scene,1,1,item-buffer'),
      frame('maps', 'Reflection maps', 'maps.png', 'study/counts.csv', 'scene,1,1,maps'),
      frame('rays', 'Second rays', 'rays.png', 'study/counts.csv', 'scene,1,1,item-buffer'),
      frame(
        'all-rays',
        'All rays',
        'compare/ray_tracing.png',
        'study/counts.csv',
        'scene,1,1,ray-tracing',
      ),
      frame(
        'difference',
        'Why they differ',
        'compare/reasons.png',
        'compare/differences.csv',
        'another polygon',
      ),
    ],
  },
  box: {
    commands: [
      `${box} --shots 1 --every 1 -o OUT/first ${shots}`,
      `${box} --shots 200 --every 20 -o OUT/box ${shots}`,
    ],
    exhibit: 'radiosity',
    frames: [
      shot('first', 1, '1 shot'),
      shot('box', 20, '20 shots'),
      shot('box', 100, '100 shots'),
      shot('box', 200, '200 shots'),
    ],
  },
};
