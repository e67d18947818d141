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
const shot = (count: number, title: string): Frame => ({
  id: `after-${count}`,
  title,
  picture: `box/shot_${String(count).padStart(6, '0')}.png`,
  table: 'box/convergence.csv',
  row: String(count),
});

export const films: Readonly<Record<string, FilmFigure>> = {
  components: {
    commands: [
      `render SCENES/rings.toml --renderer hardware -o OUT/hardware.png --counters OUT/hardware.json ${size}`,
      `render SCENES/rings.toml -o OUT/picture.png --components OUT --counters OUT/passes.json ${size}`,
    ],
    exhibit: 'passes&scene=rings.toml',
    frames: [
      {
        id: 'ambient',
        title: 'Ambient',
        picture: 'ambient.png',
        table: 'passes.json',
        row: 'ambient',
      },
      {
        id: 'diffuse',
        title: 'Diffuse',
        picture: 'diffuse.png',
        table: 'passes.json',
        row: 'diffuse',
      },
      {
        id: 'specular',
        title: 'Specular',
        picture: 'specular.png',
        table: 'passes.json',
        row: 'specular',
      },
      {
        id: 'sum',
        title: 'The sum',
        picture: 'picture.png',
        table: 'passes.json',
        row: '',
      },
      {
        id: 'one-pass',
        title: 'One pass',
        picture: 'hardware.png',
        table: 'hardware.json',
        row: '',
      },
    ],
  },
  mask: {
    commands: [
      `render SCENES/styles.toml --shadow none -o OUT/none.png --counters OUT/none.json ${size}`,
      `render SCENES/styles.toml -o OUT/picture.png --planes OUT --counters OUT/passes.json ${size}`,
    ],
    exhibit: 'passes&scene=styles.toml',
    frames: [
      {
        id: 'unshadowed',
        title: 'Without shadows',
        picture: 'none.png',
        table: 'none.json',
        row: 'diffuse window',
      },
      {
        id: 'stencil',
        title: 'The stencil',
        picture: 'stencil.png',
        table: 'passes.json',
        row: 'shadow window',
      },
      {
        id: 'shadowed',
        title: 'With shadows',
        picture: 'picture.png',
        table: 'passes.json',
        row: 'diffuse window',
      },
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
      {
        id: 'items',
        title: 'Item buffer',
        picture: 'ids.png',
        table: 'study/counts.csv',
        row: 'scene,1,1,item-buffer',
      },
      {
        id: 'maps',
        title: 'Reflection maps',
        picture: 'maps.png',
        table: 'study/counts.csv',
        row: 'scene,1,1,maps',
      },
      {
        id: 'rays',
        title: 'Second rays',
        picture: 'rays.png',
        table: 'study/counts.csv',
        row: 'scene,1,1,item-buffer',
      },
      {
        id: 'all-rays',
        title: 'All rays',
        picture: 'compare/ray_tracing.png',
        table: 'study/counts.csv',
        row: 'scene,1,1,ray-tracing',
      },
      {
        id: 'difference',
        title: 'Why they differ',
        picture: 'compare/reasons.png',
        table: 'compare/differences.csv',
        row: 'another polygon',
      },
    ],
  },
  box: {
    commands: [
      `${box} --shots 1 --every 1 -o OUT/first ${shots}`,
      `${box} --shots 200 --every 20 -o OUT/box ${shots}`,
    ],
    exhibit: 'radiosity',
    frames: [
      {
        ...shot(1, '1 shot'),
        picture: 'first/shot_000001.png',
        table: 'first/convergence.csv',
      },
      shot(20, '20 shots'),
      shot(100, '100 shots'),
      shot(200, '200 shots'),
    ],
  },
};
