// Stories: a scene, an algorithm, and a few stages with their sentences. A stage stands at a step
// of the log: the beginning, the end, or the first with this test, or answer, after the stage
// before.
import type { Step } from '../../model/steps/log';
import type { Language } from '../../words/language';

export interface Stage {
  /** 'begin', 'end', "test" or "test.answer". */
  readonly at: string;
  readonly en: string;
  readonly ja: string;
}

export interface Story {
  readonly id: string;
  readonly scene: string;
  readonly algorithm: string;
  readonly level: string;
  readonly size: string;
  readonly title: Readonly<Record<Language, string>>;
  readonly stages: readonly Stage[];
}

export const stories: readonly Story[] = [
  {
    id: 'first',
    scene: 'hidden/cycle.toml',
    algorithm: 'newell',
    level: 'polygon',
    size: '320x240',
    title: { en: 'What is a hidden surface?', ja: '隠面とは何か' },
    stages: [
      {
        at: 'begin',
        en: 'A surface behind another one is hidden: a picture must not show it. Here are three polygons, of which each covers the next, so none can simply be painted first. Press Next: a famous algorithm of 1972 solves it before your eyes, step by step.',
        ja: 'ほかの面の後ろにある面を隠面といい、画像に描いてはいけません。ここには三枚のポリゴンがあり、順に重なって循環しているので、単純に最初に塗れるものがありません。「次へ」を押すと、1972 年の有名なアルゴリズムが一歩ずつ解いていきます。',
      },
      {
        at: 'farthest-corner.sorted',
        en: 'First it sorts the polygons by their farthest corners. The left view is the picture so far, the right one shows the scene from elsewhere. On the right margin the line of the algorithm is lit.',
        ja: 'まず、最も遠い頂点でポリゴンをソートします。左はこれまでの画像、右は別の場所から見たシーンです。右端では、いま実行している行に色が付きます。',
      },
      {
        at: 'z-extents.no',
        en: 'May the farthest be painted first? It asks about two polygons: the yellow outline and the broken blue one. Their depths overlap, so five tests follow.',
        ja: '最も遠いものを先に塗ってよいでしょうか。黄色の輪郭と青い破線の輪郭の二枚について調べます。奥行きが重なるので、五つの判定に進みます。',
      },
      {
        at: "4'-before.no",
        en: 'All tests say no, also the other way round: neither may be painted before the other. One must be cut.',
        ja: '逆の順も含め、どの判定も成り立ちません。どちらも先に塗れないので、一方を切ります。',
      },
      {
        at: 'split',
        en: 'It cuts one in two, by the plane of the other. The two new pieces have a pink outline.',
        ja: '一方を他方の平面で二つに切ります。新しい部分はピンクの輪郭です。',
      },
      {
        at: 'end',
        en: 'Done: every pixel is right. Drag the picture to move the eye, explore freely with another algorithm, or take the next story.',
        ja: '完成です。どの画素も正しく描かれました。画像をドラッグして視点を動かすか、「自由に試す」で別のアルゴリズムを選ぶか、次の話に進んでください。',
      },
    ],
  },
  {
    id: 'painter',
    scene: 'hidden/centroid_fails.toml',
    algorithm: 'painter-farthest',
    level: 'polygon',
    size: '320x240',
    title: { en: 'The painter fails', ja: '画家のアルゴリズムの失敗' },
    stages: [
      {
        at: 'begin',
        en: 'A painter begins with what is far and paints nearer things over it. The algorithm of this name sorts polygons by one distance each. Is one number enough?',
        ja: '画家は遠いものから塗り、近いものを上に重ねます。この名のアルゴリズムは、ポリゴンごとに一つの距離でソートします。数一つで足りるでしょうか。',
      },
      {
        at: 'distance.sorted',
        en: 'The order is decided, by the farthest corners alone. Nobody asks whether it is right.',
        ja: '最も遠い頂点だけで順序が決まりました。正しいかどうかは調べません。',
      },
      {
        at: 'end',
        en: 'Wrong pixels: the red card below names the steps that spoiled them. Turn the eye: from some places the same order is right.',
        ja: '誤った画素があります。下の赤い枠に、それを描いたステップがあります。視点を動かすと、同じ順序が正しい場所もあります。',
      },
    ],
  },
  {
    id: 'pinwheel',
    scene: 'hidden/pinwheel.toml',
    algorithm: 'newell',
    level: 'polygon',
    size: '320x240',
    title: { en: 'A pinwheel, one cut', ja: '風車と一回の分割' },
    stages: [
      {
        at: 'begin',
        en: 'Four bars lie over one another in a ring. How often must they be cut?',
        ja: '四本の棒が輪のように重なっています。何回切ればよいでしょうか。',
      },
      {
        at: 'marks.cycle',
        en: 'The bars were moved one after the other, until a marked one would have to move again.',
        ja: '棒を順に動かし、印の付いた棒をもう一度動かすことになりました。',
      },
      {
        at: 'split',
        en: 'One cut opens the ring. Positive numbers are distances behind the plane.',
        ja: '一回の分割で輪が解けます。正の数は平面の奥への距離です。',
      },
      {
        at: 'end',
        en: 'Five pieces, four bars, one cut.',
        ja: '四本の棒は一回の分割で五つの部分になりました。',
      },
    ],
  },
  {
    id: 'z-buffer',
    scene: 'hidden/five.toml',
    algorithm: 'z-buffer',
    level: 'polygon',
    size: '320x240',
    title: { en: 'The Z-buffer asks every pixel', ja: '画素ごとに問う Zバッファ' },
    stages: [
      {
        at: 'begin',
        en: 'The Z-buffer sorts nothing. It keeps a depth Z for every pixel, and a polygon is written where its own z is smaller.',
        ja: 'Zバッファは何もソートしません。画素ごとに奥行き Z を持ち、ポリゴンの z が小さい画素だけに書きます。',
      },
      {
        at: 'z-buffer',
        en: 'The first polygon is nearer than the empty background everywhere.',
        ja: '最初のポリゴンは、何もない背景よりどこでも手前です。',
      },
      {
        at: 'z-buffer.some',
        en: 'This one is nearer only at some of its pixels; the others stay as they are.',
        ja: 'このポリゴンは一部の画素だけで手前です。ほかの画素はそのまま残ります。',
      },
      {
        at: 'end',
        en: 'The order of the polygons did not matter. The price was memory: a number at every pixel.',
        ja: 'ポリゴンの順序は関係ありませんでした。代償は、画素ごとに数を持つ記憶でした。',
      },
    ],
  },
  {
    id: 'scan-line',
    scene: 'hidden/five.toml',
    algorithm: 'scan-line',
    level: 'span',
    size: '64x48',
    title: { en: 'Line by line', ja: '走査線ごとに' },
    stages: [
      {
        at: 'begin',
        en: 'Scan-line algorithms need only one row of the picture in memory. They know where each polygon enters and leaves the row.',
        ja: '走査線アルゴリズムは、画像の一行だけを記憶すれば済みます。各ポリゴンがその行のどこで始まり、終わるかを知っています。',
      },
      {
        at: 'edge-table',
        en: 'All polygons wait in a table, by the line in which they begin.',
        ja: 'ポリゴンはすべて、始まる走査線ごとの表で待ちます。',
      },
      {
        at: 'active-edges',
        en: 'A line crosses some of them. Between two neighbouring ends lies a sample span.',
        ja: '走査線がいくつかを横切ります。隣り合う端の間がサンプルスパンです。',
      },
      {
        at: 'span.one-nearest',
        en: 'In this span two polygons lie over each other; the nearer at both ends is seen in all of it.',
        ja: 'このサンプルスパンでは二枚が重なります。両端で手前のものが、全体で見えます。',
      },
      {
        at: 'end',
        en: 'The picture is whole, and no depth was stored.',
        ja: '画像ができました。奥行きは一つも保存していません。',
      },
    ],
  },
];

export interface StageAt {
  /** Steps done. */
  readonly at: number;
  readonly stage: Stage;
}

/** By stage the steps done; stages whose step the log does not have are left out. */
export function stagesIn(story: Story, steps: readonly Step[]): StageAt[] {
  const found: StageAt[] = [];
  let from = 0;
  for (const stage of story.stages) {
    const [test, answer] = stage.at.split('.');
    const index = steps.findIndex(
      (step, i) => i >= from && step.test === test && (!answer || step.result === answer),
    );
    if (stage.at === 'begin') found.push({ at: 0, stage });
    else if (stage.at === 'end') found.push({ at: steps.length, stage });
    else if (index >= 0) found.push({ at: (from = index + 1), stage });
  }
  return found;
}

/** The place of the stage that has been reached. */
export const stageAt = (stages: readonly StageAt[], position: number): number =>
  Math.max(
    0,
    stages.findLastIndex(({ at }) => at <= position),
  );
