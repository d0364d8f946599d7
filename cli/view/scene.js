// What is drawn: camera, facets, lines. A frame is drawn when something changed, not all the time.
import { Mesh, PerspectiveCamera, Raycaster, Scene, Vector2, Vector3, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

import { cellColours } from './colours.js';
import { Facets } from './facets.js';
import { fitted, wholeMesh } from './fit.js';
import { SingularEdges, outlineOf } from './lines.js';
import { surfaceMaterial } from './surface_material.js';
import { markShown } from './visible.js';

const FIELD_DEGREES = 28;
const EDGE_PIXELS = 0.75; // of each of the two facets at an edge
const radians = (degrees) => (degrees * Math.PI) / 180;

export class View {
  constructor(canvas, mesh, state, { ratio, keepsFrame }) {
    Object.assign(this, { canvas, mesh, state });
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: keepsFrame });
    this.renderer.setPixelRatio(ratio);
    this.camera = new PerspectiveCamera(FIELD_DEGREES, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.minDistance = 0.02;
    this.controls.maxDistance = 200;
    this.controls.addEventListener('change', () => this.redraw());
    this.controls.addEventListener('start', () => { this.isAtHome = false; });
    this.facets = new Facets(mesh);
    this.surface = new Mesh(this.facets.geometry, surfaceMaterial(EDGE_PIXELS * ratio));
    this.surface.frustumCulled = false;
    this.singular = new SingularEdges(mesh);
    this.outline = outlineOf(mesh);
    this.scene = new Scene();
    this.scene.add(this.surface, this.singular.group);
    if (this.outline) this.scene.add(this.outline);
    this.isAtHome = false; // nobody has turned the mesh yet: a new size of the window may move the camera
    this.afterDraw = [];
    this.afterUpdate = [];
    this.pending = { update: false, frame: 0 };
    this.colouring = { way: '', colours: null };
  }

  /** Makes the picture agree with the state, at the next frame. */
  update() {
    this.pending.update = true;
    this.redraw();
  }

  redraw() {
    if (this.pending.frame === 0) this.pending.frame = requestAnimationFrame(() => this.draw());
  }

  apply() {
    const { mesh, state, facets } = this;
    this.shownCount = markShown(mesh, state, facets.shown);
    const isApart = state.shrink > 0 || state.explode > 0;
    facets.choose(isApart);
    facets.place(state.shrink, state.explode);
    if (this.colouring.way !== state.colour)
      this.colouring = { way: state.colour, colours: cellColours(mesh, state.colour) };
    facets.paint(this.colouring.colours);
    this.singular.update(state.singular, state.explode);
    if (this.outline) {
      const isPart = this.shownCount < mesh.count && state.explode === 0;
      this.outline.visible = state.outline && isPart;
    }
    for (const told of this.afterUpdate) told(this);
  }

  /** Now, not at the next frame. */
  draw() {
    cancelAnimationFrame(this.pending.frame);
    this.pending.frame = 0;
    if (this.pending.update) {
      this.pending.update = false;
      this.apply();
    }
    const { camera } = this;
    const radius = 1.8 * (1 + this.state.explode);
    const distance = camera.position.length(); // the middle of the mesh is at 0
    camera.near = Math.max(0.004 * radius, distance - radius);
    camera.far = distance + radius;
    camera.updateProjectionMatrix();
    this.renderer.render(this.scene, camera);
    for (const told of this.afterDraw) told(this);
  }

  resize(width, height) {
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.redraw();
  }

  /** Looks at the middle of the whole mesh from this direction, at a distance at which it fills the picture. */
  look(azimuth, elevation) {
    const [a, e] = [radians(azimuth), radians(Math.min(89.99, Math.max(-89.99, elevation)))];
    const back = new Vector3(Math.cos(a) * Math.cos(e), Math.sin(a) * Math.cos(e), Math.sin(e));
    this.show(fitted(this.camera, back, wholeMesh(this.mesh, this.state.explode)));
  }

  /** What is shown fills the picture, seen from the direction of now. */
  fit() {
    const back = new Vector3().fromArray(this.towardsCamera());
    const { arrays, count } = this.facets;
    this.show(fitted(this.camera, back, arrays.position.subarray(0, 12 * count)));
  }

  show({ position, target }) {
    this.isAtHome = false;
    this.camera.position.copy(position);
    this.controls.target.copy(target);
    this.controls.update();
    this.redraw();
  }

  /** The direction of view, for a slice across it. */
  towardsCamera() {
    return this.camera.position.clone().sub(this.controls.target).normalize().toArray();
  }

  /** The cell drawn at a point of the page, or -1. */
  cellAt(clientX, clientY) {
    const frame = this.canvas.getBoundingClientRect();
    const x = (2 * (clientX - frame.left)) / frame.width - 1;
    const y = 1 - (2 * (clientY - frame.top)) / frame.height;
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(x, y), this.camera);
    const [hit] = ray.intersectObject(this.surface, false);
    return hit ? this.facets.cellOfTriangle(hit.faceIndex) : -1;
  }
}
