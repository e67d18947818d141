// The tree of a log: bsp and quake log a node as they make it, schumacker its planes and clusters.
import type { Step } from './log';

export interface TreeNode {
  readonly node: number;
  readonly pieces: readonly string[];
  /** Steps done when it was made. */
  readonly made: number;
  front: TreeNode | undefined;
  back: TreeNode | undefined;
}

export interface Tree {
  readonly root: TreeNode | undefined;
  readonly nodes: ReadonlyMap<number, TreeNode>;
}

const numberOf = (step: Step, name: string): number | undefined => {
  const value = step.values?.[name];
  return typeof value === 'number' ? value : undefined;
};

export function treeOf(steps: readonly Step[]): Tree {
  const nodes = new Map<number, TreeNode>();
  const links: { node: TreeNode; front: number | undefined; back: number | undefined }[] = [];
  let root: TreeNode | undefined;
  steps.forEach((step, i) => {
    if (step.test !== 'tree-node' && step.test !== 'cluster') return;
    const number = numberOf(step, 'node');
    if (number === undefined) return;
    const node: TreeNode = {
      node: number,
      pieces: step.pieces ?? [],
      made: i + 1,
      front: undefined,
      back: undefined,
    };
    nodes.set(number, node);
    const parent = nodes.get(numberOf(step, 'parent') ?? -1);
    if (parent) parent[step.result === 'front' ? 'front' : 'back'] = node;
    else root ??= node;
    if (step.test === 'cluster')
      links.push({ node, front: numberOf(step, 'front'), back: numberOf(step, 'back') });
  });
  for (const { node, front, back } of links) {
    node.front = nodes.get(front ?? -1);
    node.back = nodes.get(back ?? -1);
  }
  return { root, nodes };
}

/** By node: steps done and the eye's side, in their order. */
export type Sides = ReadonlyMap<number, readonly (readonly [number, string])[]>;

export function sidesOf(steps: readonly Step[]): Sides {
  const sides = new Map<number, [number, string][]>();
  steps.forEach((step, i) => {
    const node = numberOf(step, 'node');
    if (step.test !== 'eye-side' || node === undefined) return;
    const known = sides.get(node);
    const side = step.result.startsWith('front') ? 'front' : 'back'; // "front-parallel"
    if (known) known.push([i + 1, side]);
    else sides.set(node, [[i + 1, side]]);
  });
  return sides;
}

/** The eye's side of a node after `position` steps, if the walk has been there. */
export function sideAt(sides: Sides, node: number, position: number): string | undefined {
  return sides.get(node)?.findLast(([done]) => done <= position)?.[1];
}

export interface Placed {
  readonly node: TreeNode;
  readonly x: number;
  readonly depth: number;
  readonly parent: Placed | undefined;
}

/** Nodes in their places: back to front from left to right, at most `most`, by depth. */
export function placed(tree: Tree, most = 400): Placed[] {
  if (!tree.root) return [];
  const shown = new Set<TreeNode>();
  let level: TreeNode[] = [tree.root];
  while (level.length > 0 && shown.size + level.length <= most) {
    for (const node of level) shown.add(node);
    level = level.flatMap((node) => [node.back, node.front].filter((n) => n !== undefined));
  }
  const all: Placed[] = [];
  const byNode = new Map<TreeNode, Placed>();
  const x = new Map<TreeNode, number>();
  const depth = new Map<TreeNode, number>();
  const walk: { node: TreeNode; depth: number; open: boolean }[] = [
    { node: tree.root, depth: 0, open: true },
  ];
  for (let at = walk.pop(); at; at = walk.pop()) {
    if (!shown.has(at.node)) continue;
    if (!at.open) {
      x.set(at.node, x.size);
      depth.set(at.node, at.depth);
      continue;
    }
    if (at.node.front) walk.push({ node: at.node.front, depth: at.depth + 1, open: true });
    walk.push({ ...at, open: false });
    if (at.node.back) walk.push({ node: at.node.back, depth: at.depth + 1, open: true });
  }
  for (const node of shown) {
    const parent = all.find((p) => p.node.front === node || p.node.back === node);
    const place = { node, x: x.get(node) ?? 0, depth: depth.get(node) ?? 0, parent };
    byNode.set(node, place);
    all.push(place);
  }
  return all;
}

/** Of the nodes after `position` steps: the one with this number or such a piece, else the last. */
export function inQuestion(
  tree: Tree,
  position: number,
  number: unknown,
  pieces: ReadonlySet<string>,
): TreeNode | undefined {
  const made = [...tree.nodes.values()].filter((node) => node.made <= position);
  return (
    made.find((node) => node.node === number) ??
    made.find((node) => node.pieces.some((piece) => pieces.has(piece))) ??
    made.at(-1)
  );
}

/** The place of the node in question; if it is left out, of its parent. Without one: the root's. */
export function nearest(
  places: readonly Placed[],
  isWanted: (node: TreeNode) => boolean,
  tree: Tree,
): Placed | undefined {
  const place = places.find((p) => isWanted(p.node));
  if (place) return place;
  const byNode = new Map(places.map((p) => [p.node, p]));
  const above = new Map<TreeNode, TreeNode>();
  for (const node of tree.nodes.values())
    for (const child of [node.front, node.back]) if (child) above.set(child, node);
  let node = [...tree.nodes.values()].find(isWanted);
  while (node && !byNode.has(node)) node = above.get(node);
  return (node && byNode.get(node)) ?? places[0];
}
