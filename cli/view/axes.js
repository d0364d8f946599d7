// The directions of x, y and z, in a corner of the picture.
import { svg } from './dom.js';

const AXES = [['x', 0xb5452c], ['y', 0x2f7d4f], ['z', 0x2b5fa8]];
const LENGTH = 26;

export function drawAxes(element, camera) {
  const turn = camera.matrixWorldInverse.elements;
  const ends = AXES.map(([name, colour], k) => ({
    name,
    colour: `#${colour.toString(16)}`,
    x: turn[4 * k] * LENGTH,
    y: -turn[4 * k + 1] * LENGTH,
    depth: turn[4 * k + 2],
  }));
  ends.sort((a, b) => a.depth - b.depth); // the nearest is drawn last
  element.replaceChildren(
    ...ends.flatMap(({ name, colour, x, y }) => [
      svg('line', { x1: 0, y1: 0, x2: x, y2: y, stroke: colour, 'stroke-width': 2, 'stroke-linecap': 'round' }),
      svg('text', { x: x * 1.36, y: y * 1.36, fill: colour }, name),
    ]),
  );
}
