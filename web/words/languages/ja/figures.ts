// The titles of algorithms by name, the scenes, and the labels of the articles' figures, in
// Japanese.
export const title = `
back-face | 裏を向いた面の除去だけ
painter-farthest | 画家のアルゴリズム、最も遠い頂点の順
painter-nearest | 画家のアルゴリズム、最も近い頂点の順
painter-centroid | 画家のアルゴリズム、重心の順
newell | Newell、Newell、Sancha：五つの判定と分割
bsp | 視点を決める前に作る BSP 木
scan-line | 走査線法：辺、x でソートした線分、サンプルスパン
z-buffer | マシンの Zバッファ
ray-casting | レイキャスティング：すべての光線とすべてのポリゴン
schumacker | Schumacker のクラスタ：どの視点でも成り立つ優先順位 (1969)
warnock | Warnock の領域分割 (1969)
bouknight | Bouknight の走査線法：辺が面のオン・オフを切り替える (1970)
watkins | Watkins の走査線法：前の走査線から予想するスパン (1970)
weiler-atherton | Weiler、Atherton：ポリゴンによるポリゴンのクリップ (1977)
a-buffer | Aバッファ：画素ごとに 32 点のマスク (1984)
hierarchical-z | 階層的 Zバッファ：八分木と奥行きのピラミッド (1993)
quake | Quake のソートされたスパン：BSP 木によるキー (1996)
roberts | Roberts 1963：すべての線とすべての凸立体
appel | Appel 1967：不可視度
played | プログラムのステップ
floating-horizon | 浮動水平線 (Williamson 1972、Wright 1973)`;

export const scene = `
Cases of hidden surfaces | 隠面消去の例
Three polygons in a cycle: none is farthest | 三枚が循環し、最も遠いものがない
Five polygons, parallel lines of sight | 五枚のポリゴン、平行な視線
Ten polygons | 十枚のポリゴン
The order of centroids is wrong | 重心の順が誤り
Two polygons: all five tests say no | 五つの判定で決まらない二枚
Two polygons pierce each other | 貫き合う二枚
A pinwheel of four bars: one cut | 四本の棒の風車、分割は一回
Three bars, each over the next | 順に重なる三本の棒
Solids, many small faces | 立体、多数の小さな面
A ring | 輪
A ring and a ball | 輪と球
Hills over a grid, for hidden lines | 格子上の丘、隠線消去に
Passes: light, shadow, glass | パス：光、影、ガラス
Three rings without a map | 三つの輪、マップなし
Red rings with a white gloss | 白い光沢の赤い輪
Rings of few polygons | 少ないポリゴンの輪
Marble: a map for each component | 大理石：成分ごとのマップ
Fog and a glass vase | 霧とガラスの花瓶
Reflection and refraction maps | 反射と屈折のマップ
Maps that the machine draws itself | マシンが描くマップ
Three coloured lights with shadows | 三色の光と影
Soft shadows | 柔らかい影
Light around lamps | ランプのまわりの光
Lamps that light one object each | 物体ごとのランプ
Panes that intersect | 交わる板ガラス
A building with 100 lamps | 百のランプの建物
Depth of field | 被写界深度
A film: a planet turns and circles | 映像：自転し、公転する惑星
Motion blur | 動きのぼけ
Edges of every direction | あらゆる向きの辺
Little but a soft shadow | ほぼ半影だけ
A table of few polygons | 少ないポリゴンのテーブル
The Utah teapot | ユタのティーポット
Mirrors and rays | 鏡と光線
A room with ten glossy objects | 十の光沢物体がある部屋
A glass of water with a rod | 棒を入れた水のグラス
Two mirrors face to face | 向かい合う鏡
Needles thinner than a pixel | 画素より細い針
Radiosity | ラジオシティ
The Cornell box | コーネルボックス
A room | 部屋
A corridor | 廊下
A room with a mirror | 鏡のある部屋
An office, its lamps in lumen | オフィス、光源はルーメン単位
Inside a sphere | 球の内側
The Cornell box, without radiosity | コーネルボックス、ラジオシティなし
Models alone | モデルだけ
Three triangles in a cycle | 循環する三枚の三角形
Five polygons, one of them a wedge | くさびを含む五枚のポリゴン
Ten faces, large and small | 大小十枚の面
A long rectangle and two small ones | 長い長方形と小さな二枚
A concave U and a bar across its arms | 凹んだ U 字とその腕を横切る棒
Two rectangles that pierce each other | 貫き合う二枚の長方形
Four bars in a pinwheel | 風車の形の四本の棒
The Cornell box as it was measured | 実測のコーネルボックス
A tumbler with water | 水の入ったタンブラー
A corridor with a corner | 曲がった廊下`;

export const label = `
Ambient | 環境光
Diffuse | 拡散反射
Specular | 鏡面反射
The sum | 和
One pass | 一回のパス
Without shadows | 影なし
The stencil | ステンシル
With shadows | 影あり
Item buffer | アイテムバッファ
Reflection maps | 反射マップ
Second rays | 二次光線
All rays | すべて光線で
Why they differ | 違いの原因
1 shot | 1 回
20 shots | 20 回
100 shots | 100 回
200 shots | 200 回
Drawn in the order of the file | ファイルの順に描く
left end of strip 1 | 帯 1 の左端
right end of strip 1 | 帯 1 の右端
left end of strip 2 | 帯 2 の左端
right end of strip 2 | 帯 2 の右端
eye | 視点
corner a | 頂点 a
corner b | 頂点 b
corner c | 頂点 c
corner d | 頂点 d
corner e | 頂点 e
end p of the line | 線の端 p
end q of the line | 線の端 q
surface 1 | 面 1
surface 2 | 面 2
left end of wall 1 | 壁 1 の左端
right end of wall 1 | 壁 1 の右端
left end of wall 2 | 壁 2 の左端
right end of wall 2 | 壁 2 の右端
left end of wall 3 | 壁 3 の左端
right end of wall 3 | 壁 3 の右端
end p of wall 1 | 壁 1 の端 p
end q of wall 1 | 壁 1 の端 q
near plane | 手前の面
far plane | 奥の面
point | 点
pixel | 画素
light | 光源
near end of wall 2 | 壁 2 の手前の端
far end of wall 2 | 壁 2 の奥の端
left end of the mirror | 鏡の左端
right end of the mirror | 鏡の右端
scan line | 走査線
end of wall 1 | 壁 1 の端
other end of wall 1 | 壁 1 のもう一方の端
end of wall 2 | 壁 2 の端
other end of wall 2 | 壁 2 のもう一方の端`;
