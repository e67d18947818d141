// Messages in the reader's language: by the language's table of errors and the command's patterns.
import { readFileSync } from 'node:fs';
import { beforeAll, expect, it, vi } from 'vitest';

const file = process.env['GW_STEP_WORDS'] ?? '../hiddensurface/run/step_words.json';
const patterns: unknown = JSON.parse(
  readFileSync(file.replace('step_words', 'messages.ja'), 'utf8'),
);
let messageIn: (text: string, language: string) => string;
beforeAll(async () => {
  vi.stubGlobal('__GW_MESSAGES__', { ja: patterns });
  ({ messageIn } = await import('../../words/message'));
});

it.each([
  // Browsers, each by its own words.
  [
    'ReferenceError: text is not defined',
    "名前の誤りです（ReferenceError）：'text' は定義されていません",
  ],
  [
    "TypeError: Cannot read properties of undefined (reading 'none')",
    "型の誤りです（TypeError）：'undefined' には 'none' がありません",
  ],
  ["SyntaxError: Unexpected token ';'", "文法の誤りです（SyntaxError）：ここに ';' は書けません"],
  ['RangeError: more than 200000 steps', 'ステップが 200000 を超えました'],
  // What a program says itself.
  ['Error: my own words', 'エラーです（Error）：my own words'],
  ['my own words', 'my own words'],
  ['Error: my list is empty', 'エラーです（Error）：my list is empty'],
  // MicroPython.
  ["NameError: name 'a' isn't defined", "名前の誤りです（NameError）：'a' は定義されていません"],
  ['KeyError: pieces', "辞書にないキーです（KeyError）：'pieces'"],
  // The machine, of a step and of a scene.
  [
    "step:1: unknown polygon 'none'; expected one of the scene",
    "1 番目のステップ：知らないポリゴン 'none' です。必要なもの：シーンのポリゴン",
  ],
  [
    'own/text.obj:3: f has 2 corners; expected at least 3',
    "'own/text.obj' の 3 行目：'f' の頂点が 2 個です。必要なもの：3 以上",
  ],
  [
    'own/a.toml: cannot be opened: No such file or directory; expected a readable file',
    "'own/a.toml'：開けません：ファイルがありません。必要なもの：読めるファイル",
  ],
  [
    "own/a.toml:9: object 'floor': has no area and is to emit; expected a figure with an area",
    "'own/a.toml' の 9 行目：物体 'floor'：光るはずですが、面積がありません。必要なもの：面積のある図形",
  ],
  [
    "renderer 'scanline' leaves out of this scene: shadows, fog, glare",
    "描画方法 'scanline' がこのシーンで描かないもの：影、フォグ、グレア",
  ],
  [
    "own/a.toml:3: camera.fov is 'wide'; expected a number from 1 to 179",
    "'own/a.toml' の 3 行目：'camera.fov' が 'wide' です。必要なもの：1 から 179 の数",
  ],
  [
    'own/a.gltf: nodes[3].rotation has 3 elements; expected 4',
    "'own/a.gltf'：'nodes[3].rotation' の要素が 3 個です。必要なもの：4",
  ],
  [
    "own/a.obj:1: unknown statement 'fx'; the nearest known is 'f'",
    "'own/a.obj' の 1 行目：知らない語 'fx' です。最も近い語は 'f' です",
  ],
])('%s', (english, japanese) => {
  expect(messageIn(english, 'ja')).toBe(japanese);
  expect(messageIn(english, 'en')).toBe(english);
});

it('leaves long lines, and translates line by line', () => {
  expect(messageIn('no step\nno step', 'ja')).toBe('ステップがありません\nステップがありません');
  const long = 'a; expected '.repeat(10_000);
  expect(messageIn(long, 'ja')).toBe(long);
});
