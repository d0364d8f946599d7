// The facets that can be seen, as the arrays of one geometry: four vertices and two triangles each.
import { BufferAttribute, BufferGeometry, Sphere, Vector3 } from 'three';

import { NOBODY } from './mesh.js';

// Distances of the corners from the sides of a quad and of a triangle: where one is zero, there is an edge.
const QUAD_SIDES = [0, 255, 0, 255, 255, 0, 0, 255, 255, 0, 255, 0, 0, 255, 255, 0];
const TRIANGLE_SIDES = [255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 0, 0, 255, 255];

function arraysFor(capacity) {
  const index = new Uint32Array(6 * capacity);
  for (let i = 0, v = 0; i < index.length; i += 6, v += 4)
    index.set([v, v + 1, v + 2, v, v + 2, v + 3], i);
  return {
    capacity,
    index,
    position: new Float32Array(12 * capacity),
    normal: new Int8Array(16 * capacity),
    colour: new Uint8Array(16 * capacity),
    sides: new Uint8Array(16 * capacity),
  };
}

function attach(geometry, arrays) {
  geometry.dispose();
  geometry.setIndex(new BufferAttribute(arrays.index, 1));
  geometry.setAttribute('position', new BufferAttribute(arrays.position, 3));
  geometry.setAttribute('normal', new BufferAttribute(arrays.normal, 4, true));
  geometry.setAttribute('colour', new BufferAttribute(arrays.colour, 4, true));
  geometry.setAttribute('sides', new BufferAttribute(arrays.sides, 4, true));
}

/** The normal of a quad, which need not be plane: that of its diagonals. At four vertices from v on. */
function writeNormal({ position: p, normal }, v) {
  const at = 3 * v;
  const ax = p[at + 6] - p[at], ay = p[at + 7] - p[at + 1], az = p[at + 8] - p[at + 2];
  const bx = p[at + 9] - p[at + 3], by = p[at + 10] - p[at + 4], bz = p[at + 11] - p[at + 5];
  const x = ay * bz - az * by, y = az * bx - ax * bz, z = ax * by - ay * bx;
  const scale = 127 / (Math.hypot(x, y, z) || 1);
  for (let i = 4 * v; i < 4 * v + 16; i += 4) {
    normal[i] = x * scale;
    normal[i + 1] = y * scale;
    normal[i + 2] = z * scale;
  }
}

export class Facets {
  constructor(mesh) {
    this.mesh = mesh;
    this.geometry = new BufferGeometry();
    this.geometry.boundingSphere = new Sphere(new Vector3(), Infinity);
    this.shown = new Uint8Array(mesh.count);
    this.list = new Uint32Array(0); // cell * sides + facet
    this.arrays = null;
    this.count = 0;
  }

  /** Lists the facets that nothing shown hides; of cells apart, all. */
  choose(isApart) {
    const { mesh, shown } = this;
    const { sides } = mesh;
    if (this.list.length === 0) this.list = new Uint32Array(mesh.count * sides);
    let count = 0;
    for (let cell = 0; cell < mesh.count; ++cell) {
      if (shown[cell] === 0) continue;
      const end = sides * cell + mesh.shapeOf(cell).facets.length;
      for (let at = sides * cell; at < end; ++at) {
        const other = mesh.neighbours[at];
        if (isApart || other === NOBODY || shown[other] === 0) this.list[count++] = at;
      }
    }
    this.count = count;
    if (this.arrays === null || count > this.arrays.capacity) {
      this.arrays = arraysFor(Math.max(count, 64, Math.min(2 * count, mesh.count * sides)));
      attach(this.geometry, this.arrays);
    }
    this.geometry.setDrawRange(0, 6 * count);
  }

  /** Places them: each cell shrunk towards its centre and moved away from that of the box. */
  place(shrink, explode) {
    const { mesh, arrays } = this;
    const { points, cells, centres, corners } = mesh;
    const { sides } = mesh;
    const kept = 1 - shrink;
    for (let i = 0; i < this.count; ++i) {
      const cell = Math.floor(this.list[i] / sides);
      const facet = mesh.shapeOf(cell).facets[this.list[i] % sides];
      const first = corners * cell;
      for (let j = 0; j < 4; ++j) {
        const v = 3 * cells[first + facet[j]];
        for (let k = 0; k < 3; ++k) {
          const centre = centres[3 * cell + k];
          arrays.position[12 * i + 3 * j + k] = centre + kept * (points[v + k] - centre) + explode * centre;
        }
      }
      writeNormal(arrays, 4 * i);
      const isTriangle = cells[first + facet[2]] === cells[first + facet[3]];
      arrays.sides.set(isTriangle ? TRIANGLE_SIDES : QUAD_SIDES, 16 * i);
    }
    for (const name of ['position', 'normal', 'sides'])
      this.geometry.getAttribute(name).needsUpdate = true;
  }

  paint(colours) {
    const { sides } = this.mesh;
    const { colour } = this.arrays;
    for (let i = 0; i < this.count; ++i) {
      const at = 3 * Math.floor(this.list[i] / sides);
      for (let j = 16 * i; j < 16 * i + 16; j += 4) {
        colour[j] = colours[at];
        colour[j + 1] = colours[at + 1];
        colour[j + 2] = colours[at + 2];
      }
    }
    this.geometry.getAttribute('colour').needsUpdate = true;
  }

  /** The cell of a triangle of the geometry. */
  cellOfTriangle(triangle) {
    return Math.floor(this.list[Math.floor(triangle / 2)] / this.mesh.sides);
  }
}
