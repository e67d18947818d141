// The Japanese of names that logs, counters, passes and tables of the machine have in English:
// "name | 日本語", under what it is a name of. A value's name may depend on its test.
export const names = {
  count: `
polygons | ポリゴン
facings | 表裏の判定
keys | キーの比較
extents | 範囲の比較
planes | 平面との判定
overlaps | 重なりの判定
crossings | 交点の比較
depths | 奥行きの比較
rays | 光線との判定
sorts | ソート
swaps | 移動
splits | 分割
undecided | 順序の未定
rejected | 全体の棄却
nodes | 節
spans | スパン
peak_bytes | 最大のバイト数
fragments | フラグメント
passed | 書いた画素
pixels | 見える画素
overdraw | 重ね塗り
ties | 同じ奥行き
edges | 辺の上の違い
snapped | 丸めによる違い
wrong | 誤った画素
lines | 線
faces | 面
starts | 数え始め
parts | 見える部分
missing | 足りない画素
extra | 余分な画素`,
  machine: `
draws | 描画
vertices | 頂点
primitives | プリミティブ
rejected | 棄却
clipped | クリップ
degenerate | 縮退
culled | 裏面の除去
drawn | 描いたプリミティブ
fragments | フラグメント
alpha_killed | アルファテストで棄却
stencil_killed | ステンシルテストで棄却
depth_killed | デプステストで棄却
written | 書き込み
texels | テクセル
pixels | 画素
accum_overflows | アキュムレーションの桁あふれ
bytes | バイト`,
  value: `
fragments | フラグメント
spans | スパン
passed | z < Z の画素
tested | 調べた数
nearest | 最も手前
nearest_right | 右端で最も手前
farthest | 最も奥
pyramid | ピラミッド
level | 段
cells | セル
pixels | 画素
invisibility | 不可視度
changes | 変化の位置
change | 変化
at | 位置
visible | 見える部分
hidden | 隠れる部分
window.hidden | 隠れる面
z_hidden | 隠れる面の z
distances | 距離
node | 節
parent | 親の節
plane | 平面
planes | 平面
in_front | 表側の数
tree-node.behind | 裏側の数
behind | 奥への距離
front | 表側
back | 裏側
bodies.back | 裏面の間
heights | 高さ
upper | 上の水平線
lower | 下の水平線
first_key | 一つ目のキー
second_key | 二つ目のキー
keys | キー
key | キー
z_left | 左端の z
z_right | 右端の z
z_nearest | 最も近い z
z_farthest | 最も遠い z
x0 | 最初の画素
x1 | 最後の画素
guessed | 予想した終わり
end | 終わり
priority | 優先順位
marked | 印
first_reach | 一つ目の範囲
second_reach | 二つ目の範囲
tolerance | 許容誤差
points | 点
masks | マスク
body | 物体
rows | 走査線
surrounding | 囲む面
inside | 入る面
distance | 距離`,
  pass: `
count winners | 勝者を数える
count pixels | 画素を数える
count layers | 層を数える
clear undrawn rows | 描かない行を消す
clear sum | 和を消す
add mean | 平均を加える
read mean | 平均を読む
end layers | 層の終わり
layer Z | 層 Z
layer | 層
background | 背景
surroundings of | 周囲のマップ：
ambient | 環境光
diffuse | 拡散反射
specular | 鏡面反射
emission | 自己発光
reflection | 反射
refraction | 屈折
shadow | 影
depth | 奥行き
light Z | 光源の Z
light | 光源`,
  history: `
pass | パス
command | コマンド
draw | 描画
primitive | プリミティブ
polygon | ポリゴン
outcome | 結果
fragment's colour | フラグメントの色
its Z | その Z
colour | 色
stencil | ステンシル
back colour | バックの色
accumulation | アキュムレーション
coverage | 被覆率
sample | サンプル
compared depths | 比べた奥行き
call | 呼び出し`,
  key: `
name | 名前
Map | マップ
depth | Z
stencil | ステンシル
blend | ブレンド
lights | 光源
objects | 物体
fog | 霧
color | カラー
clear | 消去
action | 動作`,
  word: `
none | なし
nearest | 最近傍
linear | 線形
modulate | 変調
replace | 置換
decal | デカール
blend | ブレンド
add | 加算
over | 上に重ねる
written | 書き込み
alpha test | アルファテストで棄却
stencil test | ステンシルテストで棄却
depth test | デプステストで棄却
killed: alpha test | アルファテストで棄却
killed: stencil test | ステンシルテストで棄却
killed: depth test | デプステストで棄却
Clear | 消去
Read | 読み出し
Copy | 複写
Accumulate | 累積
SwapBuffers | バッファの交換
geometry | 幾何
pixels | 画素
processor | プロセッサ
no light of this scene casts a shadow volume | このシーンにシャドウボリュームを作る光源はありません
IRIS 4D/340 VGX with the MultiBuffer option (ten span processors) | \
MultiBuffer 付き IRIS 4D/340 VGX（スパンプロセッサ 10 個）`,
};
