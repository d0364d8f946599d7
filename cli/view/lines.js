// Lines of constant width: singular edges, and the outline of the whole mesh where a part is hidden.
import { BufferAttribute, BufferGeometry, Color, EdgesGeometry, Group } from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

import { valenceColour } from './colours.js';
import { NOBODY } from './mesh.js';

const SHARP_DEGREES = 25;
const MOST_OUTLINED = 60000; // facets; above, the outline would take seconds

/** The singular edges that are wanted: a list of places in mesh.edges. */
function wanted(mesh, isInterior, isBoundary) {
  const list = [];
  for (let at = 0; at < mesh.edges.length; at += 4)
    if (mesh.edges[at + 3] ? isBoundary : isInterior) list.push(at);
  return list;
}

/** For each point, the mean of the centres of the cells that have it. */
function meansAround({ points, cells, corners, centres, shapeOf }) {
  const sums = new Float32Array(points.length);
  const counts = new Uint32Array(points.length / 3);
  cells.forEach((v, at) => {
    const cell = Math.floor(at / corners);
    if (at % corners >= shapeOf(cell).corners) return;
    for (let k = 0; k < 3; ++k) sums[3 * v + k] += centres[3 * cell + k];
    ++counts[v];
  });
  return sums.map((sum, i) => sum / Math.max(1, counts[Math.floor(i / 3)]));
}

function segmentsGeometry(mesh, list, points) {
  const positions = new Float32Array(6 * list.length);
  const colours = new Float32Array(6 * list.length);
  const colour = new Color();
  list.forEach((at, i) => {
    colour.setHex(valenceColour(mesh.edges[at + 2]));
    for (let end = 0; end < 2; ++end) {
      const v = 3 * mesh.edges[at + end];
      positions.set(points.subarray(v, v + 3), 6 * i + 3 * end);
      colour.toArray(colours, 6 * i + 3 * end);
    }
  });
  return new LineSegmentsGeometry().setPositions(positions).setColors(colours);
}

function lines(geometry, options, order) {
  const made = new LineSegments2(geometry, new LineMaterial({ transparent: true, ...options }));
  made.frustumCulled = false;
  made.renderOrder = order;
  return made;
}

/** Drawn twice: faintly through everything, and in full where nothing is in front. */
export class SingularEdges {
  constructor(mesh) {
    this.mesh = mesh;
    this.group = new Group();
    this.key = '';
  }

  update({ interior, boundary }, explode) {
    const key = `${interior} ${boundary} ${explode}`;
    if (key !== this.key) {
      this.key = key;
      for (const child of this.group.children) child.material.dispose();
      this.group.children[0]?.geometry.dispose();
      this.group.clear();
      const list = wanted(this.mesh, interior, boundary);
      if (list.length > 0) {
        const geometry = segmentsGeometry(this.mesh, list, this.placed(explode));
        const look = { vertexColors: true, linewidth: 3.5 };
        this.group.add(lines(geometry, { ...look, opacity: 0.3, depthTest: false, depthWrite: false }, 2));
        this.group.add(lines(geometry, { ...look, polygonOffset: true, polygonOffsetFactor: -2 }, 3));
      }
    }
  }

  /** The points, each moved as the cells around it are in the mean: into the gap between them. */
  placed(explode) {
    if (explode === 0) return this.mesh.points;
    this.means ??= meansAround(this.mesh);
    return this.mesh.points.map((x, i) => x + explode * this.means[i]);
  }
}

/** Free facets as triangles, for the search of their sharp edges. */
function freeFacets(mesh) {
  const { sides } = mesh;
  const index = [];
  for (let at = 0; at < mesh.neighbours.length; ++at) {
    if (mesh.neighbours[at] !== NOBODY) continue;
    if (index.length >= 6 * MOST_OUTLINED) return null;
    const cell = Math.floor(at / sides);
    const first = mesh.corners * cell;
    const [a, b, c, d] = mesh.shapeOf(cell).facets[at % sides].map((corner) => mesh.cells[first + corner]);
    index.push(a, b, c);
    if (c !== d) index.push(a, c, d);
  }
  return index;
}

/** The sharp edges of the boundary, or nothing if it is too large or has none. */
export function outlineOf(mesh) {
  const index = freeFacets(mesh);
  if (index === null || index.length === 0) return null;
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(mesh.points, 3));
  geometry.setIndex(index);
  const edges = new EdgesGeometry(geometry, SHARP_DEGREES);
  if (edges.getAttribute('position').count === 0) return null;
  const segments = new LineSegmentsGeometry().fromEdgesGeometry(edges);
  return lines(segments, { color: 0x8a95a3, linewidth: 1, opacity: 0.6 }, 1);
}
