// Converts the window's grid and the world to the camera's space: x to the right, y upwards, z away
// from the eye, in world units. Serves the views from above and from the side. Does not draw.
import { cross, dot, minus, unit, type Point } from '../point';
import type { Header, Loop, Plane } from './log';

export class Camera {
  private readonly right: Point;
  private readonly up: Point;
  private readonly forward: Point;
  /** Half of the window's width and height at distance 1; if orthographic, anywhere. */
  readonly slope: readonly [number, number];
  readonly orthographic: boolean;

  constructor(private readonly header: Header) {
    const { eye, at, up, fov, ortho_height } = header.view;
    const [width, height] = header.size;
    this.forward = unit(minus(at, eye));
    this.right = unit(cross(this.forward, up));
    this.up = cross(this.right, this.forward);
    this.orthographic = ortho_height > 0;
    const vertical = this.orthographic ? ortho_height / 2 : Math.tan((fov * Math.PI) / 360);
    this.slope = [(vertical * width) / height, vertical];
  }

  fromWorld(p: Point): Point {
    const d = minus(p, this.header.view.eye);
    return [dot(d, this.right), dot(d, this.up), dot(d, this.forward)];
  }

  /** The distance from the eye's plane of a value of the depth plane. */
  distance(z: number): number {
    const { near, far } = this.header.view;
    const part = z / this.header.depth;
    return this.orthographic
      ? near + part * (far - near)
      : (near * far) / (far - part * (far - near));
  }

  fromWindow(p: Point): Point {
    const [width, height] = this.header.size;
    const z = this.distance(p[2]);
    const scale = this.orthographic ? 1 : z;
    const across = (2 * p[0]) / (width * this.header.unit) - 1;
    const upwards = 1 - (2 * p[1]) / (height * this.header.unit);
    return [across * this.slope[0] * scale, upwards * this.slope[1] * scale, z];
  }

  loopsFromWindow(loops: readonly Loop[]): Loop[] {
    return loops.map((loop) => loop.map((p) => this.fromWindow(p)));
  }
}

/** A plane in the camera's space: n p = d. None if the corners are on one line. */
export function planeThrough(loops: readonly Loop[]): { n: Point; d: number } | undefined {
  const points = loops.flat();
  const normal: [number, number, number] = [0, 0, 0];
  for (let i = 2; i < points.length; ++i) {
    const n = cross(minus(points[i - 1]!, points[0]!), minus(points[i]!, points[0]!));
    const sign = dot(n, normal) < 0 ? -1 : 1;
    for (const axis of [0, 1, 2] as const) normal[axis] += sign * n[axis];
  }
  if (dot(normal, normal) === 0) return undefined;
  const n = unit(normal);
  return { n, d: dot(n, points[0]!) };
}

/** The depth of a plane of the header at a place of the window's grid. */
export function depthAt(plane: Plane, x: number, y: number): number {
  return -(plane[0] * x + plane[1] * y + plane[3]) / plane[2];
}
