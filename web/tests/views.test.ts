import { describe, expect, it } from 'vitest';
import { fromAddress, toAddress } from '../model/address';
import { Camera, depthAt, planeThrough } from '../model/steps/camera';
import { nameAt, spread, type Label } from '../model/steps/labels';
import { pathsOf } from '../model/steps/lines';
import { parseLog, type Loop, type Step } from '../model/steps/log';
import { defaultSettings } from '../model/settings';
import { inkOn } from '../model/palette';
import { crossings, depthOfPixel, segmentsOfRow } from '../model/steps/scan_line';
import { inQuestion, nearest, placed, treeOf } from '../model/steps/tree';
import { bestView, viewsOf } from '../model/steps/views';
import { header, text } from './samples/log';

describe('Camera', () => {
  const camera = new Camera(header);
  it('measures from the eye', () => {
    expect(camera.fromWorld([1, 2, 2])).toEqual([1, 2, 3]);
  });
  it('undoes the depth plane of the perspective', () => {
    expect(camera.distance(0)).toBe(1);
    expect(camera.distance(1000)).toBeCloseTo(9, 12);
    // z = far (d - near) / (d (far - near)), at d = 3
    expect(camera.distance((1000 * 9 * 2) / (3 * 8))).toBeCloseTo(3, 12);
  });
  it('finds the place in space of a place of the window', () => {
    const z = (1000 * 9 * 2) / (3 * 8);
    const [x, y, distance] = camera.fromWindow([128, 0, z]);
    expect(x).toBeCloseTo(6, 12);
    expect(y).toBeCloseTo(3, 12);
    expect(distance).toBeCloseTo(3, 12);
  });
});

it('finds the plane through corners', () => {
  const plane = planeThrough([
    [
      [0, 0, 4],
      [1, 0, 4],
      [1, 1, 4],
      [0, 1, 4],
    ],
  ])!;
  expect(Math.abs(plane.n[2])).toBeCloseTo(1, 12);
  expect(plane.d * plane.n[2]).toBeCloseTo(4, 12);
  expect(
    planeThrough([
      [
        [0, 0, 0],
        [1, 1, 1],
        [2, 2, 2],
      ],
    ]),
  ).toBeUndefined();
});

describe('a scan line', () => {
  it('crosses outlines at pairs of x', () => {
    expect(crossings(header.polygons[0]!.outline, 4)).toEqual([0, 80]);
    expect(crossings(header.polygons[0]!.outline, 64)).toEqual([]);
  });
  it('cuts each polygon into segments with depths', () => {
    const segments = segmentsOfRow(header, 3);
    expect(segments.map((s) => [s.name, s.x0, s.x1, s.z0])).toEqual([
      ['1', 0, 80, 600],
      ['2', 48, 128, 300],
    ]);
  });
  it('has whole depths at pixels', () => {
    expect(depthOfPixel(header, 2, 10, 3)).toBe(300);
    expect(depthOfPixel(header, 9, 10, 3)).toBeUndefined();
    expect(depthAt([1, 0, 1, -10], 4, 0)).toBe(6);
  });
});

describe('a tree', () => {
  const node = (number: number, result: string, parent?: number): Step => ({
    step: number + 1,
    level: 'polygon',
    kind: 'decide',
    test: 'tree-node',
    result,
    pieces: [String(number)],
    values: parent === undefined ? { node: number } : { node: number, parent },
  });
  const steps = [node(0, 'root'), node(1, 'front', 0), node(2, 'back', 0), node(3, 'back', 1)];
  it('hangs nodes on their parents', () => {
    const { root, nodes } = treeOf(steps);
    expect(nodes.size).toBe(4);
    expect(root?.front?.node).toBe(1);
    expect(root?.back?.node).toBe(2);
    expect(root?.front?.back?.node).toBe(3);
  });
  it('places them back to front', () => {
    const places = placed(treeOf(steps));
    const order = [...places].sort((a, b) => a.x - b.x).map((p) => p.node.node);
    expect(order).toEqual([2, 0, 3, 1]);
    expect(places.find((p) => p.node.node === 3)?.depth).toBe(2);
    expect(places.find((p) => p.node.node === 3)?.parent?.node.node).toBe(1);
  });
  it('asks for no node that is not made', () => {
    const at = (position: number, number?: number, ...pieces: string[]) =>
      inQuestion(treeOf(steps), position, number, new Set(pieces))?.node;
    expect([at(0), at(2), at(4)]).toEqual([undefined, 1, 3]);
    expect([at(4, 2), at(2, 2), at(2, undefined, '3'), at(4, undefined, '3')]).toEqual([
      2, 1, 1, 3,
    ]);
  });
  it('leaves out deep levels', () => {
    expect(placed(treeOf(steps), 3)).toHaveLength(3);
  });
  it('stands chains of 50,000 nodes', () => {
    const chain = Array.from({ length: 50_000 }, (_, i) =>
      i === 0 ? node(0, 'root') : node(i, 'front', i - 1),
    );
    expect(placed(treeOf(chain))).toHaveLength(400);
    const tree = treeOf(chain);
    const last = [...tree.nodes.values()].at(-1)!;
    const shown = nearest(placed(tree), (node) => node === last, tree)!;
    expect(shown.depth).toBe(399);
    expect(nearest(placed(tree), () => false, tree)!.depth).toBe(0);
  });
});

it('names a small outline from outside, a large one from inside', () => {
  const square = (x: number, y: number, side: number): Loop[] => [
    [
      [x, y, 0],
      [x + side, y, 0],
      [x + side, y + side, 0],
      [x, y + side, 0],
    ],
  ];
  expect(nameAt(square(100, 100, 40), '12', 10)).toEqual([120, 120]);
  expect(nameAt(square(100, 100, 10), '12', 10)).toEqual([105, 91]);
  expect(nameAt(square(100, 0, 10), '12', 10)).toEqual([105, 19]);
  expect(nameAt([], '12', 10)).toBeUndefined();
});

it('places names apart', () => {
  const labels: Label[] = Array.from({ length: 5 }, (_, i) => ({
    text: String(i),
    x: 10,
    y: 10,
    important: i === 3,
  }));
  const found = spread(labels, 10);
  expect(found[0]?.text).toBe('3');
  for (const a of found)
    for (const b of found)
      if (a !== b) expect(Math.abs(a.x - b.x) > 5 || Math.abs(a.y - b.y) > 10).toBe(true);
});

it('names an outline that is seen from its edge', () => {
  const edge: Loop[] = [
    [
      [10, 50, 0],
      [10, 90, 0],
      [10, 70, 0],
    ],
  ];
  expect(nameAt(edge, '1', 10)).toEqual([10, 41]);
  expect(nameAt([], '1', 10)).toBeUndefined();
});

it('divides a line into what is seen and what is hidden', () => {
  const line = { from: [0, 0, 0], to: [10, 0, 0], visible: [[0.2, 0.5]] } as const;
  expect(pathsOf(line)).toEqual({ visible: 'M2 0L5 0', hidden: 'M0 0L2 0M5 0L10 0' });
});

it('offers the views that the log has data for', () => {
  const log = parseLog(text());
  expect(viewsOf(log)).toEqual(['top', 'side', 'row', 'depth', 'list']);
  expect(bestView(log)).toBe('top');
});

it('keeps the page in the address', () => {
  const defaults = defaultSettings('en-GB', false);
  const state = fromAddress(
    '#step=12,3&view=tree,top&pixel=4,5&lang=ja&theme=dark&projector=1',
    defaults,
  );
  expect(state.steps).toEqual([12, 3]);
  expect(state.pixel).toEqual([4, 5]);
  expect(fromAddress(toAddress(state, defaults), defaults)).toEqual(state);
  expect(fromAddress('#step=x&pixel=1&lang=fr', defaults)).toMatchObject({
    steps: [],
    pixel: undefined,
    language: 'en',
  });
});

it('writes black on light colours and white on dark ones', () => {
  expect(inkOn('#ffff00')).toBe('#000000');
  expect(inkOn('#000080')).toBe('#ffffff');
});
