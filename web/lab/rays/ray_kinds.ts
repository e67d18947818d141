// The kinds of rays, as they are drawn and named.
import type { Words } from '../../words/en';
import type { FollowedRay } from './protocol';

export type RayKind = 'eye' | FollowedRay['kind'] | 'blocked';

export const kindOf = (ray: FollowedRay): RayKind =>
  ray.kind === 'shadow' && !ray.arrives ? 'blocked' : ray.kind;

export const kindWords = (words: Words): Record<RayKind, string> => ({
  eye: words.lab_ray_eye,
  reflected: words.lab_ray_reflected,
  transmitted: words.lab_ray_transmitted,
  shadow: words.lab_ray_shadow,
  blocked: words.lab_ray_blocked,
});
