// Which cells are shown, as the slice, the peeling and the selection say.

const AXES = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

/** The normal of the slice: what lies beyond, in its direction, is hidden. */
export function sliceNormal(slice) {
  const normal = slice.axis === 'view' ? slice.normal : AXES[slice.axis];
  return slice.flip ? normal.map((x) => -x) : normal;
}

/** The offset of the plane along its normal, from a fraction of the box. A flip keeps the plane. */
export function sliceOffset(slice, box) {
  const normal = sliceNormal(slice);
  let low = 0;
  let high = 0;
  for (let k = 0; k < 3; ++k) {
    low += Math.min(normal[k] * box.low[k], normal[k] * box.high[k]);
    high += Math.max(normal[k] * box.low[k], normal[k] * box.high[k]);
  }
  const at = slice.flip ? 1 - slice.at : slice.at;
  return low + at * (high - low);
}

/** 1 for each cell that is shown, into `shown`; returns their number. */
export function markShown(mesh, state, shown) {
  if (state.selected >= 0) {
    shown.fill(0);
    shown[state.selected] = 1;
    return 1;
  }
  const normal = sliceNormal(state.slice);
  const offset = state.slice.on ? sliceOffset(state.slice, mesh.box) : Infinity;
  const { centres, layers } = mesh;
  let count = 0;
  for (let cell = 0, at = 0; cell < mesh.count; ++cell, at += 3) {
    const height = normal[0] * centres[at] + normal[1] * centres[at + 1] + normal[2] * centres[at + 2];
    const isShown = height <= offset && layers[cell] >= state.peel ? 1 : 0;
    shown[cell] = isShown;
    count += isShown;
  }
  return count;
}
