// The lines of the algorithms in Japanese: "English | 日本語", a line once for all that have it.
export const code = `
for each polygon P: | 各ポリゴン P について:
N := normal, from which the corners run counter-clockwise | N := 法線(頂点が左回りに見える側)
if lines of sight are parallel: D := N·d | 視線が平行なら D := N·d
else: D := (P_E - P_i)·N | でなければ D := (P_E - P_i)·N
if D > 0: P faces the eye | D > 0 なら視点を向く
if D < 0: P looks away, leave it out | D < 0 なら裏面なので除く
if D = 0: on edge, leave it out | D = 0 なら真横なので除く
if it faces the eye: | 視点を向くなら:
draw all its pixels | その画素をすべて描く
polygons before others are not looked for | 手前のポリゴンは調べない
for each polygon P in the window: | 画面に入る各ポリゴン P について:
compute where its corners are | 頂点の位置を求める
key(P) := distance of the nearest corner | キー(P) := 最も近い頂点の距離
sort the list by key | リストをキーでソートする
compare two keys at a time | 二つのキーを比べる
greater: the polygon counts as farther | 大きいほうを遠いとみなす
not greater: their order stays | 大きくなければ順序はそのまま
the list is now far to near | リストは遠い順になる
for each polygon P, far to near: | 遠い順に各ポリゴン P について:
paint all its pixels over the picture | その画素をすべて上から塗る
no test asks whether the order is right | 順序が正しいかは調べない
key(P) := distance of the farthest corner | キー(P) := 最も遠い頂点の距離
key(P) := distance of the centroid | キー(P) := 重心の距離
sort all polygons by their farthest corners | 最も遠い頂点でソートする
while the list has polygons: | リストが空になるまで:
P := the farthest | P := 最も遠いポリゴン
for each other Q, until P may precede all: | P を先に描けるまで、ほかの各 Q について:
is all of Q nearer in depth than P? | 奥行きでは Q 全体が P より手前か
1: are they apart in x? | 1: x の範囲が離れているか
2: are they apart in y? | 2: y の範囲が離れているか
3: is P wholly behind the plane of Q? | 3: P 全体が Q の平面の奥か
4: is Q wholly before the plane of P? | 4: Q 全体が P の平面の手前か
5: are their outlines apart? | 5: 投影が離れているか
the other way round: is Q behind P? | 逆の順: Q は P の平面の奥か
or is P before Q? | P は Q の平面の手前か
then move Q to the far end and mark it | Q を最も遠い端へ移し印を付ける
Q is marked already: a cycle | Q に印があれば循環
no order: cut one by the plane of the other | 順序がなければ一方を他方の平面で切る
neither can be cut: no order is found | どちらも切れなければ順序は決まらない
draw P | P を描く
build(list of pieces): | 構築(部分のリスト):
choose a piece; its plane makes a node | 一つを選び、その平面を節とする
for each other piece: | ほかの各部分について:
crosses the plane: cut it in two | 平面をまたぐなら二つに切る
before it: to the front list; else to the back list | 表側なら表のリスト、でなければ裏のリストへ
build(front list); build(back list) | 構築(表のリスト); 構築(裏のリスト)
draw(node): | 描画(節):
eye in front: the back comes first | 視点が表側なら裏側が先
eye behind it: the front comes first | 視点が裏側なら表側が先
draw(far side) | 描画(遠い側)
draw the pieces in the node's plane | 節の平面にある部分を描く
draw(near side) | 描画(近い側)
edge table: polygons by their top lines | 辺の表: ポリゴンを最上の走査線ごとに
for each line y, from the top: | 上から各走査線 y について:
add polygons that begin, drop those that end | 始まるものを加え、終わるものを除く
segments := the polygons between their edges | 線分 := 各ポリゴンの左右の辺の間
sort the ends in x | 端を x でソートする
for each sample span between two ends: | 隣り合う端の間の各サンプルスパン:
one segment: it is seen | 線分が一つならそれが見える
one is nearest at both ends: it is seen | 両端で手前ならそれが見える
they cross: compare z at every pixel | 交差するなら画素ごとに z を比べる
draw the line | 走査線を描く
move every edge one line down | 各辺を一つ下の走査線へ進める
for each pixel: | 各画素について:
Z := farthest depth; colour := background | Z := 最も遠い値; 色 := 背景
for each polygon P, in any order: | どの順でも、各ポリゴン P について:
for each triangle, row and pixel of P: | P の三角形、行、画素ごとに:
z := depth of P at the pixel's centre | z := 画素の中心での P の奥行き
if z < Z: | z < Z なら:
Z := z | Z := z
colour := colour of P | 色 := P の色
else: | でなければ:
nothing is written | 何も書かない
for each row from the top: | 上から各行について:
R := the ray through its centre | R := 中心を通る光線
for each triangle: | 各三角形について:
does R meet it, and at which z? | R と交わるか、z はいくつか
meets none: the background | 一つもなければ背景
meets one: it is seen | 一つならそれが見える
meets several: the least z is seen | 複数なら z が最小のもの
keep the polygon's pixel | その画素を覚える
draw the row | 行を描く
divide(faces): | 分割(面):
a plane between them? two nodes | 間に平面があれば二つの節
all orders without a cycle? a cluster | 順序に循環がなければクラスタ
number its sides: priorities for every eye | 面に番号を付ける: 視点によらない優先順位
else: cut some by the plane of one | でなければ一つの平面で切る
divide(front); divide(back) | 分割(表側); 分割(裏側)
eye in front: the back node comes first | 視点が表側なら裏側の節が先
eye behind: the front node comes first | 視点が裏側なら表側の節が先
of a cluster, sides that the eye sees, by priority | クラスタでは見える側を優先順位で
draw the face | 面を描く
visit(window, faces): | 訪問(ウィンドウ, 面):
drop faces that are outside | 外の面を除く
drop faces behind one that surrounds it | 囲む面より奥の面を除く
no face left: background | 面がなければ背景
one face reaches in: draw it | 面が一つならそれを描く
one surrounds it before all: draw it | すべての手前で囲む面があれば描く
divide the window into four | ウィンドウを四つに分ける
visit each of the four | 四つをそれぞれ訪問
visit(whole picture, all faces) | 訪問(画面全体, すべての面)
draw what the windows found | ウィンドウの結果を描く
edges by their top lines | 辺を最上の走査線ごとに
add edges that begin, drop those that end | 始まる辺を加え、終わる辺を除く
mend the order in x by exchanges | x の順序を交換で直す
for each span between two crossings: | 隣り合う交点の間の各スパン:
no face over it: background | 面がなければ背景
one face: it is seen | 面が一つならそれが見える
nearest at both ends: it is seen | 両端で手前ならそれが見える
another at the right end: they pierce | 右端で別の面なら貫き合う
find the implied edge, divide there | 陰の辺を求めて分ける
faces by their top lines | 面を最上の走査線ごとに
mend the order of the segments | 線分の順序を直す
left := first pixel | 左 := 最初の画素
while left is in the picture: | 左が画面内にある間:
guess the end of the span from the line above | 上の走査線から終わりを予想
no segment: background | 線分がなければ背景
the nearest stays nearest: the guess holds | 手前のまま: 予想どおり
another comes before it: the span is shorter | 別の面が前に出る: 短くする
left := end of the span | 左 := サンプルスパンの終わり
sort all polygons by their nearest corners | 最も近い頂点でソートする
sort out(list): | 整理(リスト):
C := the nearest that has not clipped yet | C := まだ使っていない最も近いもの
for each other polygon P: | ほかの各ポリゴン P について:
cut P by the outline of C | P を C の輪郭で切る
the part outside goes to the rest | 外側は残りへ
inside and behind C: hidden | 内側で C の奥なら隠れる
inside and before C: C was no choice, sort again | 内側で C の手前なら先に整理
on both sides: they pierce | 両側にあるなら貫き合う
keep the part before C | C の手前の部分を残す
sort out(inside); sort out(rest) | 整理(内側); 整理(残り)
nothing is before it: draw it | 手前に何もなければ描く
for each pixel that P touches: | P が触れる各画素について:
mask := its points among 32 | マスク := 32 点のうち P が覆う点
add a fragment: mask, depth, colour | フラグメントを加える: マスク、奥行き、色
sort its fragments near to far | フラグメントを手前からソートする
free := all 32 points | 残り := 32 点すべて
for each fragment: | 各フラグメントについて:
it gets its free points; take them away | 残りの点を取り、残りから除く
colour := sum of the shares | 色 := 割合の和
draw the polygon with the largest share | 割合が最大のポリゴンを描く
put all polygons into an octree of cubes | ポリゴンを八分木の立方体に入れる
pyramid := farthest depth at each pixel and level | ピラミッド := 各段の最も遠い奥行き
visit(cube): | 訪問(立方体):
outside the window: return | 画面の外なら戻る
all cells over it nearer: hidden, return | 覆うセルがすべて手前なら隠れる
else it may be seen | でなければ見える可能性がある
for each polygon P of the cube: | 立方体の各ポリゴン P について:
outside the window: next P | 画面の外なら次の P へ
all cells over it nearer: hidden, next P | 覆うセルがすべて手前なら隠れる
else P may be seen | でなければ P は見える可能性がある
for each pixel of P: if z < Z: Z := z | P の各画素: z < Z なら Z := z
draw it, mend the pyramid above | 描き、上の段を直す
visit its eight parts, near to far | 八つの部分を手前から訪問
visit(cube of the whole scene) | 訪問(全体の立方体)
walk the tree far to near: | 木を遠い順にたどる:
eye behind it: its front comes first | 視点が裏側なら表側が先
give every piece a key: smaller is nearer | 各部分にキー: 小さいほど手前
edges of all pieces, sorted in x | すべての辺を x でソートする
leading edge: put its piece on the stack by key | 左の辺: 部分をキーの順にスタックへ
trailing edge: take its piece off | 右の辺: 部分をスタックから除く
the piece on top is seen from here | ここから一番上の部分が見える
the stack is empty: background from here | スタックが空ならここから背景
draw the spans | スパンを描く
contour edges: between a front and a back face | 輪郭線: 表と裏の面の間の辺
for each connected set of lines: | つながった線の組ごとに:
count the faces before a first corner | 最初の頂点で手前の面を数える
for each line from a known corner: | 数の分かった頂点から各線について:
sort its crossings with contour edges | 輪郭線との交点をソートする
number := that of the corner, or counted again | 数 := 頂点の数、または数え直した数
a contour, in behind it: number up | 輪郭線の後ろに入ると数が増える
a contour, out from behind it: number down | 輪郭線の後ろから出ると数が減る
through a face to its back: number up | 面を貫いて裏へ出ると数が増える
through a face to its front: number down | 面を貫いて表へ出ると数が減る
number 0 all along: visible | どこでも 0 なら見える
number nowhere 0: hidden | 0 の部分がなければ隠れる
else: visible where it is 0 | でなければ 0 の部分が見える
draw the visible parts | 見える部分を描く
bodies := convex solids, and single faces | 物体 := 凸な立体と一枚の面
for each line: | 各線について:
between two back faces: leave it out | 二つの裏面の間なら除く
hidden := empty | 隠れた部分 := 空
for each body: | 各物体について:
boxes apart in the window: next | 画面上で離れていれば次へ
clip the line by all its planes, to the eye | 視線方向の全平面で線を切る
add the interval that is behind | 奥になる部分を加える
visible := the rest of the line | 見える部分 := 残り
all of the line: nothing hides it | 線の全体なら何も隠さない
nothing: the line is hidden | 残りがなければ線は隠れる
else: visible in parts | でなければ一部が見える
upper := lowest, lower := highest at every x | 各 x で 上 := 最低、下 := 最高
for each row of the grid, near to far: | 格子の各列を手前から:
for each line of the row, and to the row before: | 列の線と前の列への線について:
project it: heights at its x | 投影して高さを求める
hidden := between the two horizons | 隠れる部分 := 二つの水平線の間
beyond a horizon all along: visible | 全体が水平線の外なら見える
between the horizons all along: hidden | 全体が水平線の間なら隠れる
upper := greater of upper and the row | 上 := 上と列の大きいほう
lower := smaller of lower and the row | 下 := 下と列の小さいほう`;
