// Where the camera must be so that points fill the picture.
import { Vector3 } from 'three';

const MARGIN = 0.9; // of the picture that the points may take
const ROUNDS = 3;
const USUAL = 6; // distance of the camera, in the units of the page

/** The corners of all cells, as they are placed when the mesh is exploded. */
export function wholeMesh({ points, cells, corners, centres }, explode) {
  const placed = new Float32Array(3 * cells.length);
  for (let at = 0; at < cells.length; ++at) {
    const centre = 3 * Math.floor(at / corners);
    for (let k = 0; k < 3; ++k) placed[3 * at + k] = points[3 * cells[at] + k] + explode * centres[centre + k];
  }
  return placed;
}

const along = (axis, points, i) => axis.x * points[i] + axis.y * points[i + 1] + axis.z * points[i + 2];

/** The least and greatest coordinate along an axis. */
function extent(points, axis) {
  let [low, high] = [Infinity, -Infinity];
  for (let i = 0; i < points.length; i += 3) {
    const at = along(axis, points, i);
    if (at < low) low = at;
    if (at > high) high = at;
  }
  return [low, high];
}

/** The distance that the points need, and how far their picture is from the middle, to the right and up. */
function needed(points, target, [right, up, back], tangents) {
  const [x0, y0, z0] = [right.dot(target), up.dot(target), back.dot(target)];
  let distance = 0.01;
  let [left, most, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let i = 0; i < points.length; i += 3) {
    const x = along(right, points, i) - x0;
    const y = along(up, points, i) - y0;
    const z = along(back, points, i) - z0;
    distance = Math.max(distance, Math.abs(x) / tangents[0] + z, Math.abs(y) / tangents[1] + z);
    const nearness = USUAL / Math.max(0.1, USUAL - z);
    left = Math.min(left, x * nearness);
    most = Math.max(most, x * nearness);
    low = Math.min(low, y * nearness);
    high = Math.max(high, y * nearness);
  }
  return { distance, aside: (left + most) / 2, above: (low + high) / 2 };
}

/** Position and target of a camera that looks against `back`, with up as it has. */
export function fitted(camera, back, points) {
  const right = new Vector3().crossVectors(camera.up, back).normalize();
  const axes = [right, new Vector3().crossVectors(back, right), back];
  const tangent = Math.tan((camera.fov * Math.PI) / 360) * MARGIN;
  const tangents = [tangent * camera.aspect, tangent];
  const target = new Vector3();
  if (points.length === 0) return { position: back.clone().multiplyScalar(5), target };
  for (const axis of axes) {
    const [low, high] = extent(points, axis);
    target.addScaledVector(axis, (low + high) / 2);
  }
  let found = needed(points, target, axes, tangents);
  for (let round = 1; round < ROUNDS; ++round) {
    target.addScaledVector(axes[0], found.aside).addScaledVector(axes[1], found.above);
    found = needed(points, target, axes, tangents);
  }
  return { position: target.clone().addScaledVector(back, found.distance), target };
}
