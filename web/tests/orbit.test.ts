import { expect, it } from 'vitest';
import { minus, dot } from '../model/point';
import { dolly, orbit, type Eye } from '../model/orbit';

const start: Eye = { eye: [0, 0, 5], at: [0, 0, 0], up: [0, 1, 0] };
const distance = (e: Eye) => Math.sqrt(dot(minus(e.eye, e.at), minus(e.eye, e.at)));

it('keeps its distance', () => {
  expect(distance(orbit(start, 0.7, 0.4))).toBeCloseTo(5, 4);
});

it('goes round to the same place', () => {
  const half = orbit(start, Math.PI, 0);
  expect(half.eye[2]).toBeCloseTo(-5, 4);
  expect(orbit(half, Math.PI, 0).eye[2]).toBeCloseTo(5, 4);
});

it('rises upwards and stops before the pole', () => {
  expect(orbit(start, 0, 0.5).eye[1]).toBeCloseTo(5 * Math.sin(0.5), 4);
  expect(orbit(start, 0, 9).eye[1]).toBeCloseTo(5 * Math.sin((85 * Math.PI) / 180), 4);
});

it('comes nearer', () => {
  expect(dolly(start, 0.5).eye).toEqual([0, 0, 2.5]);
});
