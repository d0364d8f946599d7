// The mesh of the page, as the program embedded it: base64 of little-endian arrays.
//
// A mesh has cells with `sides` facets each: hexahedra have six; of a surface, each triangle or quad
// is a cell with one facet; a hybrid mesh has cells of four shapes, each with room for eight corners
// (those beyond its own repeat its last one) and six facets. Points are relative to the centre of the box of the mesh, in units of half
// of its longest side.

// enum/cells/cube.hpp: corner x + 2y + 4z, facet 2k + s, counter-clockwise from outside.
const CUBE_FACETS = [
  [0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6],
];
const QUAD = [[0, 1, 2, 3]];

/** As meshing/view has them; a triangle repeats its last corner. */
export const SHAPES = [
  { name: 'tetrahedron', plural: 'tetrahedra', corners: 4, facets: [[1, 2, 3, 3], [0, 3, 2, 2], [0, 1, 3, 3], [0, 2, 1, 1]] },
  { name: 'hexahedron', plural: 'hexahedra', corners: 8, facets: CUBE_FACETS },
  {
    name: 'prism', plural: 'prisms', corners: 6,
    facets: [[0, 2, 1, 1], [3, 4, 5, 5], [0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]],
  },
  {
    name: 'pyramid', plural: 'pyramids', corners: 5,
    facets: [[0, 3, 2, 1], [0, 1, 4, 4], [1, 2, 4, 4], [2, 3, 4, 4], [3, 0, 4, 4]],
  },
];
const HEXAHEDRON = 1;
const FACET = { name: 'facet', plural: 'facets', corners: 4, facets: QUAD };

export const NOBODY = 0xffffffff;
export const INVERTED = 4; // a bit of the status; the others are 0 valid, 1 invalid, 2 undecided

function bytesOf(name) {
  const text = atob(document.getElementById(`data-${name}`).textContent);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

const floats = (name) => new Float32Array(bytesOf(name).buffer);
const words = (name) => new Uint32Array(bytesOf(name).buffer);

/** The mean of the corners of each cell; a triangle repeats its last corner, which counts once. */
function centresOf(points, cells, corners, shapeOf) {
  const centres = new Float32Array((3 * cells.length) / corners);
  for (let c = 0, at = 0; at < cells.length; ++c, at += corners) {
    const own = shapeOf(c).corners;
    const last = corners === 4 && cells[at + 2] === cells[at + 3] ? 3 : own;
    for (let k = 0; k < 3; ++k) {
      let sum = 0;
      for (let i = 0; i < last; ++i) sum += points[3 * cells[at + i] + k];
      centres[3 * c + k] = sum / last;
    }
  }
  return centres;
}

/** Least and greatest coordinates of the points that cells use. */
function boxOf(points, cells) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (const v of cells)
    for (let k = 0; k < 3; ++k) {
      low[k] = Math.min(low[k], points[3 * v + k]);
      high[k] = Math.max(high[k], points[3 * v + k]);
    }
  return { low, high };
}

export function readMesh() {
  const about = JSON.parse(document.getElementById('data-about').textContent);
  const isSolid = about.kind !== 'facets';
  const isHybrid = about.kind === 'hybrid';
  const hasQuality = about.kind === 'hexahedra';
  const points = floats('points');
  const cells = words('cells');
  const corners = isSolid ? 8 : 4;
  const count = cells.length / corners;
  const shapes = isHybrid ? bytesOf('shapes') : null;
  const only = isSolid ? SHAPES[HEXAHEDRON] : FACET;
  const shapeOf = shapes ? (cell) => SHAPES[shapes[cell]] : () => only;
  return {
    about,
    isSolid,
    points,
    cells,
    corners,
    count,
    sides: isSolid ? 6 : 1,
    isHybrid,
    hasQuality,
    shapes,
    shapeOf,
    neighbours: isSolid ? words('neighbours') : new Uint32Array(count).fill(NOBODY),
    layers: isSolid ? words('layers') : new Uint32Array(count),
    jacobians: hasQuality ? floats('jacobians') : null,
    status: hasQuality ? bytesOf('status') : null,
    edges: words('edges'), // a, b, valence, 1 on the boundary
    centres: centresOf(points, cells, corners, shapeOf),
    box: boxOf(points, cells),
  };
}

/** Words for the status of a hexahedron. */
export function statusWord(mesh, cell) {
  const status = mesh.status[cell];
  if (status & INVERTED) return 'inverted';
  return ['valid', 'invalid', 'undecided'][status & 3];
}
