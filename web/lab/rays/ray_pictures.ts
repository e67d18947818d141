// Pictures that the page makes of what the machine says by pixel. Four bytes a pixel, as the
// machine gives pictures.
import { channels } from '../../model/palette';

/** The pixels that are traced in their colours, all others dark grey. */
export function tracedOnly(picture: Uint8Array, mask: Uint8Array): Uint8Array {
  const out = picture.slice();
  mask.forEach((one, i) => {
    if (one) return;
    const at = i * 4;
    const grey = (picture[at]! + picture[at + 1]! + picture[at + 2]!) / 12;
    out.fill(grey, at, at + 3);
  });
  return out;
}

/** In the order of the machine's reasons: same, polygon, shadow, rounding, fog, lighting. */
export const reasonColors = ['#000000', '#e62828', '#f0dc32', '#505050', '#3c6ef0', '#3cbe50'];

export function withReasons(reason: Uint8Array): Uint8Array {
  const colors = reasonColors.map(channels);
  const out = new Uint8Array(reason.length * 4).fill(255);
  reason.forEach((one, i) => out.set(colors[one] ?? [255, 255, 255], i * 4));
  return out;
}
