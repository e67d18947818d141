// Planes (R9.6) as columns of a table.
import type { Words } from '../../words/en';
import type { PlaneFacts } from './protocol';

const cells = (p: PlaneFacts): string[] => [
  p.name,
  ...[p.a0, p.x0, p.y0, p.gx, p.gy, p.sum, p.value].map(String),
];

/** Side by side: their integers are long. */
export function planeRows(planes: readonly PlaneFacts[], words: Words): string[][] {
  const head = ['', 'a0', 'X0', 'Y0', 'Gx', 'Gy', words.lab_sum_16, 'V'];
  const columns = planes.map(cells);
  return head.map((name, i) => [name, ...columns.map((column) => column[i]!)]);
}
