// The page: reads the mesh, draws it, and says in attributes of <html> that it did:
// data-hexatlas is "drawn" or "failed", data-cells, data-shown and data-facets are numbers.
import { drawAxes } from './axes.js';
import { byId, html } from './dom.js';
import { bindKeys } from './keyboard.js';
import { readMesh } from './mesh.js';
import { Panel } from './panel.js';
import { View } from './scene.js';

const LEGEND_PIXELS = 260; // as wide as the panel of a picture
const CLICK_PIXELS = 4; // a pointer that moved more turned the mesh

function tell(view) {
  Object.assign(document.documentElement.dataset, {
    hexatlas: 'drawn',
    cells: view.mesh.count,
    shown: view.shownCount,
    facets: view.facets.count,
  });
}

function fail(sentence) {
  document.documentElement.dataset.hexatlas = 'failed';
  byId('stage').replaceChildren(html('p', { class: 'failure', role: 'alert' }, sentence));
}

/** A double click on a cell shows it alone, and the next one all again. */
function bindClicks(canvas, view, panel) {
  let down = [0, 0];
  canvas.addEventListener('pointerdown', (event) => { down = [event.clientX, event.clientY]; });
  canvas.addEventListener('dblclick', (event) => {
    if (Math.hypot(event.clientX - down[0], event.clientY - down[1]) > CLICK_PIXELS) return;
    panel.select(panel.state.selected >= 0 ? -1 : view.cellAt(event.clientX, event.clientY));
  });
}

function hasWebgl() {
  return document.createElement('canvas').getContext('webgl2') !== null;
}

/** The picture of --png has the size asked for, whatever the window; a legend has its own room if there is enough. */
function bindSize(stage, view, picture, home) {
  if (picture) {
    const hasLegend = view.state.colour !== 'none' || view.state.singular.interior || view.state.singular.boundary;
    const room = hasLegend && picture[0] >= 900 ? LEGEND_PIXELS : 0;
    const [width, height] = [picture[0] - room, picture[1]];
    Object.assign(stage.style, { left: `${room}px`, width: `${width}px`, height: `${height}px` });
    view.resize(width, height);
    return;
  }
  const fitted = () => {
    view.resize(Math.max(1, stage.clientWidth), Math.max(1, stage.clientHeight));
    if (view.isAtHome) home();
  };
  new ResizeObserver(fitted).observe(stage);
  fitted();
}

function start() {
  const mesh = readMesh();
  const { about } = mesh;
  document.title = `${about.name}: hexatlas`;
  document.body.classList.toggle('picture', Boolean(about.picture));
  if (!hasWebgl()) {
    fail('This page draws with WebGL 2, which this browser does not offer or has switched off.');
    return;
  }
  const canvas = byId('canvas');
  canvas.setAttribute('aria-label', `${mesh.count} cells of ${about.name} in space; drag to rotate`);
  const state = { ...structuredClone(about.state), selected: -1 };
  const ratio = about.picture ? 2 : window.devicePixelRatio;
  const view = new View(canvas, mesh, state, { ratio, keepsFrame: Boolean(about.picture) });
  const panel = new Panel(mesh, state, view);
  view.afterUpdate.push(tell);
  view.afterDraw.push(() => drawAxes(byId('axes'), view.camera));
  const home = () => {
    view.look(...about.state.camera);
    view.isAtHome = true;
  };
  bindSize(byId('stage'), view, about.picture, home);
  bindKeys(panel, home);
  bindClicks(canvas, view, panel);
  home();
  view.update();
  view.draw();
}

try {
  start();
} catch (error) {
  fail(`This page could not draw the mesh: ${error.message}`);
}
const { hexatlas, cells, shown } = document.documentElement.dataset;
console.log(`hexatlas: ${hexatlas} ${cells} ${shown}`);
