// The titles of the project's algorithms in Japanese. The English ones come with the data.
import type { Language } from './language';

const japanese: Readonly<Record<string, string>> = {
  'back-face': '裏を向いた面の除去だけ',
  'painter-farthest': '画家のアルゴリズム、最も遠い頂点の順',
  'painter-nearest': '画家のアルゴリズム、最も近い頂点の順',
  'painter-centroid': '画家のアルゴリズム、重心の順',
  newell: 'Newell、Newell、Sancha：五つの判定と分割',
  bsp: '視点を決める前に作る BSP 木',
  'scan-line': '走査線法：辺、x でソートした線分、サンプルスパン',
  'z-buffer': 'マシンの Zバッファ',
  'ray-casting': 'レイキャスティング：すべての光線とすべてのポリゴン',
  schumacker: 'Schumacker のクラスタ：どの視点でも成り立つ優先順位 (1969)',
  warnock: 'Warnock の領域分割 (1969)',
  bouknight: 'Bouknight の走査線法：辺が面のオン・オフを切り替える (1970)',
  watkins: 'Watkins の走査線法：前の走査線から予想するスパン (1970)',
  'weiler-atherton': 'Weiler、Atherton：ポリゴンによるポリゴンのクリップ (1977)',
  'a-buffer': 'Aバッファ：画素ごとに 32 点のマスク (1984)',
  'hierarchical-z': '階層的 Zバッファ：八分木と奥行きのピラミッド (1993)',
  quake: 'Quake のソートされたスパン：BSP 木によるキー (1996)',
  roberts: 'Roberts 1963：すべての線とすべての凸立体',
  appel: 'Appel 1967：不可視度',
  played: 'プログラムのステップ',
  'floating-horizon': '浮動水平線 (Williamson 1972、Wright 1973)',
};

/**
 * A student's own algorithm keeps the title that it has. The code of a lecture's row stays away:
 * few readers have that lecture.
 */
export function titleOf(algorithm: string, title: string, language: Language): string {
  const plain = title.replace(/ \[L\d+\]$/, '');
  return language === 'ja' ? (japanese[algorithm] ?? plain) : plain;
}

export const titledAlgorithms: readonly string[] = Object.keys(japanese);
