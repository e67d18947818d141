// How messages read in Japanese: of JavaScript in browsers, of MicroPython, and of files of scenes;
// those of steps are in hiddensurface/run/messages.ja.json. A value is translated too, unless it
// stands between quotation marks.
export const error = `
SyntaxError: {0} | 文法の誤りです（SyntaxError）：{0}
ReferenceError: {0} | 名前の誤りです（ReferenceError）：{0}
TypeError: {0} | 型の誤りです（TypeError）：{0}
RangeError: {0} | 範囲の誤りです（RangeError）：{0}
Error: {0} | エラーです（Error）：{0}
NameError: {0} | 名前の誤りです（NameError）：{0}
AttributeError: {0} | 属性の誤りです（AttributeError）：{0}
IndexError: {0} | 添字の誤りです（IndexError）：{0}
KeyError: {0} | 辞書にないキーです（KeyError）：'{0}'
ValueError: {0} | 値の誤りです（ValueError）：{0}
ZeroDivisionError: {0} | 0 での割り算です（ZeroDivisionError）：{0}
IndentationError: {0} | 字下げの誤りです（IndentationError）：{0}
ImportError: {0} | 読み込みの誤りです（ImportError）：{0}
MemoryError: {0} | メモリが足りません（MemoryError）：{0}
RuntimeError: {0} | 実行時の誤りです（RuntimeError）：{0}
AssertionError: {0} | assert が成り立ちません（AssertionError）：{0}
{0} is not defined | '{0}' は定義されていません
Can't find variable: {0} | '{0}' は定義されていません
name '{0}' isn't defined | '{0}' は定義されていません
local variable referenced before assignment | 値を入れる前の変数です
Cannot access '{0}' before initialization | '{0}' は宣言の前には使えません
Identifier '{0}' has already been declared | '{0}' は二度宣言されています
Assignment to constant variable. | const の変数には代入できません
Missing initializer in const declaration | const の宣言に値がありません
Cannot read properties of {0} (reading '{1}') | '{0}' には '{1}' がありません
Cannot set properties of {0} (setting '{1}') | '{0}' の '{1}' には代入できません
{0} is not a function | '{0}' は関数ではありません
{0} is not iterable | '{0}' は繰り返せません
{0} is undefined | '{0}' は undefined です
Unexpected token '{0}' | ここに '{0}' は書けません
Unexpected identifier '{0}' | ここに名前 '{0}' は書けません
Unexpected number | ここに数は書けません
Unexpected string | ここに文字列は書けません
Unexpected end of input | プログラムが途中で終わっています
Invalid or unexpected token | 正しくない文字があります
missing ) after argument list | 引数の後に ) がありません
Invalid left-hand side in assignment | 代入の左辺が正しくありません
Illegal return statement | return は関数の中だけに書けます
Maximum call stack size exceeded | 関数の呼び出しが深すぎます
Invalid array length | 配列の長さが正しくありません
{0} is disallowed as a lexically bound name | '{0}' は変数の名前にできません
invalid syntax | 正しくない文です
unexpected indent | 字下げが多すぎます
unindent doesn't match any outer indent level | 字下げが、外側のどれとも合いません
'{0}' object has no attribute '{1}' | '{0}' に属性 '{1}' はありません
'{0}' object isn't callable | '{0}' は呼び出せません
'{0}' object isn't subscriptable | '{0}' に添字は使えません
'{0}' object isn't iterable | '{0}' は繰り返せません
unsupported types for {0}: '{1}', '{2}' | '{1}' と '{2}' に演算 '{0}' は使えません
{0} index out of range | '{0}' の添字が範囲の外です
divide by zero | 0 では割れません
no module named '{0}' | モジュール '{0}' はありません
can't convert '{0}' object to {1} implicitly | '{0}' は '{1}' になりません
function takes {0} positional arguments but {1} were given | 引数は {0} 個ですが、{1} 個あります
function missing {0} required positional arguments | 引数が {0} 個足りません
maximum recursion depth exceeded | 関数の呼び出しが深すぎます
memory allocation failed, allocating {0} bytes | {0} バイトを確保できません
line {0}: {1} | {0} 行目：{1}
not a header | ヘッダーではありません
not a step | ステップではありません
version {0}; this page reads version 1 | 版が {0} です。このページが読むのは版 1 です
a file that gw hidden --steps wrote | gw hidden --steps が書いたファイル
"step" and "kind" | "step" と "kind"
{0}.obj: {1} | '{0}.obj'：{1}
{0}.mtl: {1} | '{0}.mtl'：{1}
{0}.toml: {1} | '{0}.toml'：{1}
{0}.gltf: {1} | '{0}.gltf'：{1}
{0}.glb: {1} | '{0}.glb'：{1}
{0}.png: {1} | '{0}.png'：{1}
{0}.jpg: {1} | '{0}.jpg'：{1}
{0}.obj:{1}: {2} | '{0}.obj' の {1} 行目：{2}
{0}.mtl:{1}: {2} | '{0}.mtl' の {1} 行目：{2}
{0}.toml:{1}: {2} | '{0}.toml' の {1} 行目：{2}
cannot be opened: {0} | 開けません：{0}
No such file or directory | ファイルがありません
cannot be read to its end | 最後まで読めません
the browser cannot read it | ブラウザーが読めません
a readable file | 読めるファイル
a PNG or JPEG picture | PNG か JPEG の画像
{0} is not here | '{0}' がありません
it beside the scene | シーンと同じフォルダーにあること
the scene has nothing to draw; expected an object | シーンに描くものがありません。必要なもの：物体
has nothing to draw | 描くものがありません
f, l or p statements | f、l、p の文
an [[object]] that is visible | 見える [[object]]
a scene with a node that has a mesh | メッシュのあるノードを持つシーン
is UTF-16 | UTF-16 です
is neither UTF-8 nor Shift-JIS | UTF-8 でも Shift-JIS でもありません
UTF-8 text | UTF-8 の文章
has more than {0} MB | {0} MB を超えています
less | より小さいもの
has the extension '{0}' | 拡張子が '{0}' です
'{0}' is not a corner | '{0}' は頂点ではありません
unknown {0} '{1}' in {2}; the nearest known is '{3}' | '{2}' に知らない語 '{1}' があります。最も近い語は '{3}' です
unknown {0} '{1}'; the nearest known is '{2}' | 知らない語 '{1}' です。最も近い語は '{2}' です
unknown {0} '{1}'; none is known | 知らない語 '{1}' です
{0} has {1} numbers | '{0}' の数が {1} 個です
{0} has {1} number | '{0}' の数が {1} 個です
{0} has {1} corners | '{0}' の頂点が {1} 個です
{0} has {1} corner | '{0}' の頂点が {1} 個です
at least {0} | {0} 以上
at most {0} | {0} 以下
mtllib '{0}' {1} | mtllib の '{0}' は{1}
file '{0}' {1} | file の '{0}' は{1}
does not exist | ありません
an MTL file | MTL ファイル
an OBJ or glTF file | OBJ か glTF のファイル
{0} is missing | '{0}' がありません
{0} is '{1}' | '{0}' が '{1}' です
a number | 数
a string | 文字列
an array | 配列
a table | テーブル
a boolean | true か false
about {0} tests | 判定は約 {0} 回です
at most {0}: a smaller picture, fewer shapes, or another method | {0} 以下（小さい画像、少ない形、または別の方法）
{0}: {1} polygons would take about {2} | '{0}'：ポリゴン {1} 個には約 {2} かかります
fewer polygons, or another algorithm | 少ないポリゴン、または別のアルゴリズム
the list has no pass | リストにパスがありません`;
