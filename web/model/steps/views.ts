// The second views: which of them a log has data for, and which fits its algorithm best.
import type { Log } from './log';

export const views = [
  'top',
  'side',
  'row',
  'depth',
  'tree',
  'list',
  'windows',
  'edges',
  'pyramid',
] as const;
export type ViewName = (typeof views)[number];

export function viewsOf(log: Log): ViewName[] {
  const tests = new Set(log.steps.map((step) => step.test));
  const sorts = log.steps.some((step) => step.kind === 'sort');
  const found: ViewName[] = ['top', 'side'];
  if (log.header.draws === 'surfaces') found.push('row', 'depth');
  if (tests.has('tree-node') || tests.has('cluster')) found.push('tree');
  if (sorts) found.push('list');
  if (tests.has('window')) found.push('windows');
  if (tests.has('active-edges')) found.push('edges');
  if (tests.has('pyramid-cube') || tests.has('pyramid-polygon')) found.push('pyramid');
  return found;
}

const fitting: Readonly<Record<string, ViewName>> = {
  bsp: 'tree',
  quake: 'tree',
  schumacker: 'tree',
  warnock: 'windows',
  'scan-line': 'row',
  bouknight: 'row',
  watkins: 'row',
  'ray-casting': 'row',
  'z-buffer': 'depth',
  'a-buffer': 'depth',
  'hierarchical-z': 'pyramid',
  'painter-nearest': 'list',
  'painter-farthest': 'list',
  'painter-centroid': 'list',
};

export function bestView(log: Log): ViewName {
  const wanted = fitting[log.header.algorithm] ?? 'top';
  return viewsOf(log).includes(wanted) ? wanted : 'top';
}
