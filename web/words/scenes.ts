// The scenes of the lab in groups, a line each: "file | English | 日本語".
import type { Language } from './language';

const text = `
# Cases of hidden surfaces | 隠面消去の例
hidden/cycle.toml | Three polygons in a cycle: none is farthest | 三枚が循環し、最も遠いものがない
hidden/five.toml | Five polygons, parallel lines of sight | 五枚のポリゴン、平行な視線
hidden/ten.toml | Ten polygons | 十枚のポリゴン
hidden/centroid_fails.toml | The order of centroids is wrong | 重心の順が誤り
hidden/two_undecidable.toml | Two polygons: all five tests say no | 五つの判定で決まらない二枚
hidden/pierce.toml | Two polygons pierce each other | 貫き合う二枚
hidden/pinwheel.toml | A pinwheel of four bars: one cut | 四本の棒の風車、分割は一回
hidden/three_bars.toml | Three bars, each over the next | 順に重なる三本の棒
hidden/solids.toml | Solids, many small faces | 立体、多数の小さな面
hidden/ring.toml | A ring | 輪
hidden/ring_and_ball.toml | A ring and a ball | 輪と球
hidden/hills.toml | Hills over a grid, for hidden lines | 格子上の丘、隠線消去に
# Passes: light, shadow, glass | パス：光、影、ガラス
rings_plain.toml | Three rings without a map | 三つの輪、マップなし
rings.toml | Red rings with a white gloss | 白い光沢の赤い輪
coarse_rings.toml | Rings of few polygons | 少ないポリゴンの輪
marble.toml | Marble: a map for each component | 大理石：成分ごとのマップ
fog.toml | Fog and a glass vase | 霧とガラスの花瓶
crystal.toml | Reflection and refraction maps | 反射と屈折のマップ
mirrors.toml | Maps that the machine draws itself | マシンが描くマップ
columns.toml | Three coloured lights with shadows | 三色の光と影
soft.toml | Soft shadows | 柔らかい影
glare.toml | Light around lamps | ランプのまわりの光
selective.toml | Lamps that light one object each | 物体ごとのランプ
panes.toml | Panes that intersect | 交わる板ガラス
lamps.toml | A building with 100 lamps | 百のランプの建物
focus.toml | Depth of field | 被写界深度
planets.toml | A film: a planet turns and circles | 映像：自転し、公転する惑星
motion.toml | Motion blur | 動きのぼけ
edges.toml | Edges of every direction | あらゆる向きの辺
penumbra.toml | Little but a soft shadow | ほぼ半影だけ
styles.toml | A table of few polygons | 少ないポリゴンのテーブル
teapot.toml | The Utah teapot | ユタのティーポット
# Mirrors and rays | 鏡と光線
fig9.toml | A room with ten glossy objects | 十の光沢物体がある部屋
water.toml | A glass of water with a rod | 棒を入れた水のグラス
facing_mirrors.toml | Two mirrors face to face | 向かい合う鏡
needles.toml | Needles thinner than a pixel | 画素より細い針
# Radiosity | ラジオシティ
radiosity/cornell.toml | The Cornell box | コーネルボックス
radiosity/room.toml | A room | 部屋
radiosity/corridor.toml | A corridor | 廊下
radiosity/mirror.toml | A room with a mirror | 鏡のある部屋
radiosity/office.toml | An office, its lamps in lumen | オフィス、光源はルーメン単位
radiosity/sphere.toml | Inside a sphere | 球の内側
cornell.toml | The Cornell box, without radiosity | コーネルボックス、ラジオシティなし
# Models alone | モデルだけ
hidden/cycle.obj | Three triangles in a cycle | 循環する三枚の三角形
hidden/five.obj | Five polygons, one of them a wedge | くさびを含む五枚のポリゴン
hidden/ten.obj | Ten faces, large and small | 大小十枚の面
hidden/centroid_fails.obj | A long rectangle and two small ones | 長い長方形と小さな二枚
hidden/two_undecidable.obj | A concave U and a bar across its arms | 凹んだ U 字とその腕を横切る棒
hidden/pierce.obj | Two rectangles that pierce each other | 貫き合う二枚の長方形
hidden/pinwheel.obj | Four bars in a pinwheel | 風車の形の四本の棒
hidden/three_bars.obj | Three bars, each over the next | 順に重なる三本の棒
models/cornell.obj | The Cornell box as it was measured | 実測のコーネルボックス
models/tumbler.obj | A tumbler with water | 水の入ったタンブラー
radiosity/corridor.obj | A corridor with a corner | 曲がった廊下
`;

interface Bilingual {
  readonly en: string;
  readonly ja: string;
}
interface SceneGroup {
  readonly title: Bilingual;
  readonly scenes: { readonly name: string; readonly line: Bilingual }[];
}

const groups: SceneGroup[] = [];
for (const line of text.trim().split('\n')) {
  const parts = line.replace(/^# /, '').split(' | ');
  if (line.startsWith('#')) groups.push({ title: { en: parts[0]!, ja: parts[1]! }, scenes: [] });
  else groups.at(-1)!.scenes.push({ name: parts[0]!, line: { en: parts[1]!, ja: parts[2]! } });
}

export interface NamedScenes {
  readonly title: string;
  readonly scenes: readonly { readonly name: string; readonly line: string }[];
}

/** The scenes that are there, by group; those without a line come last, under `rest`. */
export function grouped(names: readonly string[], language: Language, rest: string): NamedScenes[] {
  const there = new Set(names);
  const found = groups.map(({ title, scenes }) => ({
    title: title[language],
    scenes: scenes
      .filter(({ name }) => there.has(name))
      .map(({ name, line }) => ({ name, line: line[language] })),
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
