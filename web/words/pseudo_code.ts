// Every algorithm in ten to twenty lines, "English | 日本語 | what lights it": the tests of
// the steps that it stands for, or single answers of them ("split.none"). Answers of opposite
// meaning light two lines, or a question, which then shows its yes or no. More spaces: inside.
const painter = (en: string, ja: string): string => `
for each polygon P in the window: | 画面に入る各ポリゴン P について: |
  compute where its corners are | 頂点の位置を求める |
  key(P) := ${en} | キー(P) := ${ja} |
sort the list by key | リストをキーでソートする |
  compare two keys at a time | 二つのキーを比べる |
    greater: the polygon counts as farther | 大きいほうを遠いとみなす | distance.farther
    not greater: their order stays | 大きくなければ順序はそのまま | distance.not-farther
  the list is now far to near | リストは遠い順になる | distance.sorted
for each polygon P, far to near: | 遠い順に各ポリゴン P について: |
  paint all its pixels over the picture | その画素をすべて上から塗る | draw
no test asks whether the order is right | 順序が正しいかは調べない |`;

const tree = `
build(list of pieces): | 構築(部分のリスト): |
  choose a piece; its plane makes a node | 一つを選び、その平面を節とする | tree-node
  for each other piece: | ほかの各部分について: |
    crosses the plane: cut it in two | 平面をまたぐなら二つに切る | split.plane
    before it: to the front list; else to the back list | 表側なら表のリスト、でなければ裏のリストへ |
  build(front list); build(back list) | 構築(表のリスト); 構築(裏のリスト) |`;

const cellsHide = (what: string): string =>
  `pyramid-${what}.hidden pyramid-${what}.hidden-by-cells`;

const texts: Record<string, string> = {
  'back-face': `
for each polygon P: | 各ポリゴン P について: |
  N := normal, from which the corners run counter-clockwise | N := 法線(頂点が左回りに見える側) |
  if lines of sight are parallel: D := N·d | 視線が平行なら D := N·d |
  else: D := (P_E - P_i)·N | でなければ D := (P_E - P_i)·N |
  if D > 0: P faces the eye | D > 0 なら視点を向く | facing.front facing-parallel.front
  if D < 0: P looks away, leave it out | D < 0 なら裏面なので除く | facing.back facing-parallel.back
  if D = 0: on edge, leave it out | D = 0 なら真横なので除く | facing.edge-on facing-parallel.edge-on
  if it faces the eye: | 視点を向くなら: |
    draw all its pixels | その画素をすべて描く | draw
polygons before others are not looked for | 手前のポリゴンは調べない |`,
  'painter-nearest': painter('distance of the nearest corner', '最も近い頂点の距離'),
  'painter-farthest': painter('distance of the farthest corner', '最も遠い頂点の距離'),
  'painter-centroid': painter('distance of the centroid', '重心の距離'),
  newell: `
sort all polygons by their farthest corners | 最も遠い頂点でソートする | farthest-corner.sorted
while the list has polygons: | リストが空になるまで: |
  P := the farthest | P := 最も遠いポリゴン |
  for each other Q, until P may precede all: | P を先に描けるまで、ほかの各 Q について: |
    is all of Q nearer in depth than P? | 奥行きでは Q 全体が P より手前か | z-extents
    1: are they apart in x? | 1: x の範囲が離れているか | 1-x-extents
    2: are they apart in y? | 2: y の範囲が離れているか | 2-y-extents
    3: is P wholly behind the plane of Q? | 3: P 全体が Q の平面の奥か | 3-behind
    4: is Q wholly before the plane of P? | 4: Q 全体が P の平面の手前か | 4-before
    5: are their outlines apart? | 5: 投影が離れているか | 5-projections
    the other way round: is Q behind P? | 逆の順: Q は P の平面の奥か | 3'-behind
    or is P before Q? | P は Q の平面の手前か | 4'-before
      then move Q to the far end and mark it | Q を最も遠い端へ移し印を付ける | farthest-corner.moved
    Q is marked already: a cycle | Q に印があれば循環 | marks
    no order: cut one by the plane of the other | 順序がなければ一方を他方の平面で切る | split.seen-plane
    neither can be cut: no order is found | どちらも切れなければ順序は決まらない | split.none
  draw P | P を描く | draw`,
  bsp: `${tree}
draw(node): | 描画(節): |
  eye in front: the back comes first | 視点が表側なら裏側が先 | eye-side.front eye-side.front-parallel
  eye behind it: the front comes first | 視点が裏側なら表側が先 | eye-side.back eye-side.back-parallel
  draw(far side) | 描画(遠い側) |
  draw the pieces in the node's plane | 節の平面にある部分を描く | draw
  draw(near side) | 描画(近い側) |`,
  'scan-line': `
edge table: polygons by their top lines | 辺の表: ポリゴンを最上の走査線ごとに | edge-table
for each line y, from the top: | 上から各走査線 y について: |
  add polygons that begin, drop those that end | 始まるものを加え、終わるものを除く |
  segments := the polygons between their edges | 線分 := 各ポリゴンの左右の辺の間 | active-edges
  sort the ends in x | 端を x でソートする |
  for each sample span between two ends: | 隣り合う端の間の各サンプルスパン: |
    one segment: it is seen | 線分が一つならそれが見える | span.one
    one is nearest at both ends: it is seen | 両端で手前ならそれが見える | span.one-nearest
    they cross: compare z at every pixel | 交差するなら画素ごとに z を比べる | span.they-cross
  draw the line | 走査線を描く | draw
  move every edge one line down | 各辺を一つ下の走査線へ進める |`,
  'z-buffer': `
for each pixel: | 各画素について: |
  Z := farthest depth; colour := background | Z := 最も遠い値; 色 := 背景 |
for each polygon P, in any order: | どの順でも、各ポリゴン P について: |
  for each triangle, row and pixel of P: | P の三角形、行、画素ごとに: | z-buffer.some
    z := depth of P at the pixel's centre | z := 画素の中心での P の奥行き |
    if z < Z: | z < Z なら: | z.nearer z-buffer.all
      Z := z | Z := z |
      colour := colour of P | 色 := P の色 | draw
    else: | でなければ: | z.not-nearer z-buffer.none
      nothing is written | 何も書かない |`,
  'ray-casting': `
for each row from the top: | 上から各行について: |
  for each pixel: | 各画素について: |
    R := the ray through its centre | R := 中心を通る光線 |
    for each triangle: | 各三角形について: |
      does R meet it, and at which z? | R と交わるか、z はいくつか |
    meets none: the background | 一つもなければ背景 | ray.background
    meets one: it is seen | 一つならそれが見える | ray.one
    meets several: the least z is seen | 複数なら z が最小のもの | ray.nearest
    keep the polygon's pixel | その画素を覚える |
  draw the row | 行を描く | draw`,
  schumacker: `
divide(faces): | 分割(面): |
  a plane between them? two nodes | 間に平面があれば二つの節 | cluster.separated
  all orders without a cycle? a cluster | 順序に循環がなければクラスタ | cluster.ranked
    number its sides: priorities for every eye | 面に番号を付ける: 視点によらない優先順位 |
  else: cut some by the plane of one | でなければ一つの平面で切る | split.plane
  divide(front); divide(back) | 分割(表側); 分割(裏側) |
draw(node): | 描画(節): |
  eye in front: the back node comes first | 視点が表側なら裏側の節が先 | eye-side.front eye-side.front-parallel
  eye behind: the front node comes first | 視点が裏側なら表側の節が先 | eye-side.back eye-side.back-parallel
  of a cluster, sides that the eye sees, by priority | クラスタでは見える側を優先順位で | priority
    draw the face | 面を描く | draw`,
  warnock: `
visit(window, faces): | 訪問(ウィンドウ, 面): |
  drop faces that are outside | 外の面を除く |
  drop faces behind one that surrounds it | 囲む面より奥の面を除く | window.hidden
  no face left: background | 面がなければ背景 | window.empty
  one face reaches in: draw it | 面が一つならそれを描く | window.one-face
  one surrounds it before all: draw it | すべての手前で囲む面があれば描く | window.surrounded
  else: | でなければ: |
    divide the window into four | ウィンドウを四つに分ける | window.divided
    visit each of the four | 四つをそれぞれ訪問 |
visit(whole picture, all faces) | 訪問(画面全体, すべての面) |
draw what the windows found | ウィンドウの結果を描く | draw`,
  bouknight: `
edges by their top lines | 辺を最上の走査線ごとに |
for each line y, from the top: | 上から各走査線 y について: |
  add edges that begin, drop those that end | 始まる辺を加え、終わる辺を除く |
  mend the order in x by exchanges | x の順序を交換で直す | active-edges
  for each span between two crossings: | 隣り合う交点の間の各スパン: |
    no face over it: background | 面がなければ背景 |
    one face: it is seen | 面が一つならそれが見える | span.one
    nearest at both ends: it is seen | 両端で手前ならそれが見える | span.one-nearest
    another at the right end: they pierce | 右端で別の面なら貫き合う | span.pierce
      find the implied edge, divide there | 陰の辺を求めて分ける | implied-edge
  draw the line | 走査線を描く | draw`,
  watkins: `
faces by their top lines | 面を最上の走査線ごとに |
for each line y, from the top: | 上から各走査線 y について: |
  mend the order of the segments | 線分の順序を直す | active-edges
  left := first pixel | 左 := 最初の画素 |
  while left is in the picture: | 左が画面内にある間: |
    guess the end of the span from the line above | 上の走査線から終わりを予想 |
    no segment: background | 線分がなければ背景 | sample-span.background
    the nearest stays nearest: the guess holds | 手前のまま: 予想どおり | sample-span.as-guessed
    another comes before it: the span is shorter | 別の面が前に出る: 短くする | sample-span.shorter
    left := end of the span | 左 := サンプルスパンの終わり |
  draw the line | 走査線を描く | draw`,
  'weiler-atherton': `
sort all polygons by their nearest corners | 最も近い頂点でソートする | nearest-corner
sort out(list): | 整理(リスト): |
  C := the nearest that has not clipped yet | C := まだ使っていない最も近いもの |
  for each other polygon P: | ほかの各ポリゴン P について: |
    cut P by the outline of C | P を C の輪郭で切る | split.outline
    the part outside goes to the rest | 外側は残りへ |
    inside and behind C: hidden | 内側で C の奥なら隠れる | inside.hidden
    inside and before C: C was no choice, sort again | 内側で C の手前なら先に整理 | inside.before
    on both sides: they pierce | 両側にあるなら貫き合う | inside.pierces
      keep the part before C | C の手前の部分を残す | split.pierced
  sort out(inside); sort out(rest) | 整理(内側); 整理(残り) |
  nothing is before it: draw it | 手前に何もなければ描く | draw`,
  'a-buffer': `
for each polygon P: | 各ポリゴン P について: |
  for each pixel that P touches: | P が触れる各画素について: |
    mask := its points among 32 | マスク := 32 点のうち P が覆う点 |
    add a fragment: mask, depth, colour | フラグメントを加える: マスク、奥行き、色 | fragments
for each pixel: | 各画素について: |
  sort its fragments near to far | フラグメントを手前からソートする |
  free := all 32 points | 残り := 32 点すべて |
  for each fragment: | 各フラグメントについて: |
    it gets its free points; take them away | 残りの点を取り、残りから除く | points
  colour := sum of the shares | 色 := 割合の和 |
draw the polygon with the largest share | 割合が最大のポリゴンを描く | draw`,
  'hierarchical-z': `
put all polygons into an octree of cubes | ポリゴンを八分木の立方体に入れる |
pyramid := farthest depth at each pixel and level | ピラミッド := 各段の最も遠い奥行き |
visit(cube): | 訪問(立方体): |
  outside the window: return | 画面の外なら戻る | pyramid-cube.outside
  all cells over it nearer: hidden, return | 覆うセルがすべて手前なら隠れる | ${cellsHide('cube')}
  else it may be seen | でなければ見える可能性がある | pyramid-cube.may-be-seen
  for each polygon P of the cube: | 立方体の各ポリゴン P について: |
    outside the window: next P | 画面の外なら次の P へ | pyramid-polygon.outside
    all cells over it nearer: hidden, next P | 覆うセルがすべて手前なら隠れる | ${cellsHide('polygon')}
    else P may be seen | でなければ P は見える可能性がある | pyramid-polygon.may-be-seen
    for each pixel of P: if z < Z: Z := z | P の各画素: z < Z なら Z := z |
      draw it, mend the pyramid above | 描き、上の段を直す | draw
  visit its eight parts, near to far | 八つの部分を手前から訪問 |
visit(cube of the whole scene) | 訪問(全体の立方体) |`,
  quake: `${tree}
walk the tree far to near: | 木を遠い順にたどる: |
  eye in front: the back comes first | 視点が表側なら裏側が先 | eye-side.front eye-side.front-parallel
  eye behind it: its front comes first | 視点が裏側なら表側が先 | eye-side.back eye-side.back-parallel
  give every piece a key: smaller is nearer | 各部分にキー: 小さいほど手前 | key
for each line y, from the top: | 上から各走査線 y について: |
  edges of all pieces, sorted in x | すべての辺を x でソートする | active-edges
  leading edge: put its piece on the stack by key | 左の辺: 部分をキーの順にスタックへ |
  trailing edge: take its piece off | 右の辺: 部分をスタックから除く |
  the piece on top is seen from here | ここから一番上の部分が見える | surface-stack.top
  the stack is empty: background from here | スタックが空ならここから背景 | surface-stack.empty
  draw the spans | スパンを描く | draw`,
  appel: `
contour edges: between a front and a back face | 輪郭線: 表と裏の面の間の辺 |
for each connected set of lines: | つながった線の組ごとに: |
  count the faces before a first corner | 最初の頂点で手前の面を数える |
  for each line from a known corner: | 数の分かった頂点から各線について: |
    sort its crossings with contour edges | 輪郭線との交点をソートする |
    number := that of the corner, or counted again | 数 := 頂点の数、または数え直した数 |
    a contour, in behind it: number up | 輪郭線の後ろに入ると数が増える | contour.more
    a contour, out from behind it: number down | 輪郭線の後ろから出ると数が減る | contour.fewer
    through a face to its back: number up | 面を貫いて裏へ出ると数が増える | pierced.more
    through a face to its front: number down | 面を貫いて表へ出ると数が減る | pierced.fewer
    number 0 all along: visible | どこでも 0 なら見える | carried.visible compared.visible
    number nowhere 0: hidden | 0 の部分がなければ隠れる | carried.hidden compared.hidden
    else: visible where it is 0 | でなければ 0 の部分が見える | carried.parts compared.parts
    draw the visible parts | 見える部分を描く | draw`,
  roberts: `
bodies := convex solids, and single faces | 物体 := 凸な立体と一枚の面 |
for each line: | 各線について: |
  between two back faces: leave it out | 二つの裏面の間なら除く |
  hidden := empty | 隠れた部分 := 空 |
  for each body: | 各物体について: |
    boxes apart in the window: next | 画面上で離れていれば次へ |
    clip the line by all its planes, to the eye | 視線方向の全平面で線を切る |
    add the interval that is behind | 奥になる部分を加える | body
  visible := the rest of the line | 見える部分 := 残り |
  all of the line: nothing hides it | 線の全体なら何も隠さない | bodies.visible
  nothing: the line is hidden | 残りがなければ線は隠れる | bodies.hidden
  else: visible in parts | でなければ一部が見える | bodies.parts
  draw the visible parts | 見える部分を描く | draw`,
  'floating-horizon': `
upper := lowest, lower := highest at every x | 各 x で 上 := 最低、下 := 最高 |
for each row of the grid, near to far: | 格子の各列を手前から: |
  for each line of the row, and to the row before: | 列の線と前の列への線について: |
    project it: heights at its x | 投影して高さを求める |
    hidden := between the two horizons | 隠れる部分 := 二つの水平線の間 |
    beyond a horizon all along: visible | 全体が水平線の外なら見える | horizon.visible
    between the horizons all along: hidden | 全体が水平線の間なら隠れる | horizon.hidden
    else: visible in parts | でなければ一部が見える | horizon.parts
    draw the visible parts | 見える部分を描く | draw
  upper := greater of upper and the row | 上 := 上と列の大きいほう |
  lower := smaller of lower and the row | 下 := 下と列の小さいほう |`,
};

export interface CodeLine {
  readonly en: string;
  readonly ja: string;
  /** Spaces before it. */
  readonly indent: number;
  /** "test" or "test.result". */
  readonly lit: readonly string[];
  /** Its answers, yes and no, light the same line. */
  readonly isQuestion: boolean;
}

function lineOf(text: string): CodeLine {
  const [en = '', ja = '', lit = ''] = text.split('|').map((part) => part.trim());
  return {
    en,
    ja,
    indent: text.search(/\S/),
    lit: lit.split(' ').filter((word) => word !== ''),
    isQuestion: en.endsWith('?'),
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
