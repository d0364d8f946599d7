// The controls beside the picture. Each one changes the state and asks for a new picture; `show` writes the
// state back into the controls, so that keys and buttons need not know of them.
import { byId, grouped, html, number } from './dom.js';
import { colourLegend, valenceLegend } from './legend.js';
import { statusWord } from './mesh.js';
import { sliceNormal, sliceOffset } from './visible.js';
import { fillWorst, markSelected } from './worst.js';

function countRows({ kind, counts }) {
  const rows = kind === 'hexahedra'
    ? [['Hexahedra', counts.hexahedra], ['Vertices', counts.vertices], ['of them interior', counts.interior],
      ['Proven valid', counts.valid], ['Inverted', counts.inverted]]
    : kind === 'hybrid'
      ? [['Tetrahedra', counts.tetrahedra], ['Hexahedra', counts.hexahedra], ['Prisms', counts.prisms],
        ['Pyramids', counts.pyramids], ['Vertices', counts.vertices], ['of them interior', counts.interior]]
      : [['Quads', counts.quads], ['Triangles', counts.triangles], ['Vertices', counts.vertices]];
  if (counts.undecided > 0) rows.push(['Undecided', counts.undecided]);
  return rows.flatMap(([word, count]) => [html('dt', {}, word), html('dd', {}, grouped(count))]);
}

/** What the program knows of a cell. */
function cellWords(mesh, cell) {
  const first = mesh.corners * cell;
  const vertices = [...new Set(mesh.cells.subarray(first, first + mesh.corners))];
  const { name } = mesh.shapeOf(cell);
  const words = `${name[0].toUpperCase()}${name.slice(1)} ${cell}`;
  if (mesh.isHybrid) return `${words}, layer ${mesh.layers[cell]}; vertices ${vertices.join(' ')}`;
  if (!mesh.isSolid) return `${words}; vertices ${vertices.join(' ')}`;
  const jacobian = number(mesh.jacobians[cell], 4);
  return `${words}: ${statusWord(mesh, cell)}, scaled Jacobian ${jacobian}, layer ${mesh.layers[cell]}; ` +
    `vertices ${vertices.join(' ')}`;
}

/** The place of the slice in the coordinates of the file. */
function sliceWords(mesh, slice) {
  const percent = `${Math.round(100 * slice.at)}\u202f%`;
  if (slice.axis === 'view') return percent;
  const axis = 'xyz'.indexOf(slice.axis);
  const offset = sliceOffset(slice, mesh.box) * sliceNormal(slice)[axis];
  const value = mesh.about.centre[axis] + mesh.about.scale * offset;
  return `${percent}, ${slice.axis} = ${Number(value.toPrecision(4))}`.replace('-', '\u2212');
}

export class Panel {
  constructor(mesh, state, view) {
    Object.assign(this, { mesh, state, view, legendKey: '' });
    byId('name').textContent = mesh.about.name;
    byId('counts').replaceChildren(...countRows(mesh.about));
    this.hideWhatDoesNotApply();
    this.bind();
    if (mesh.hasQuality) fillWorst(mesh, (cell) => this.select(cell === state.selected ? -1 : cell));
    view.afterUpdate.push(() => this.show());
  }

  hideWhatDoesNotApply() {
    const { mesh } = this;
    for (const element of document.querySelectorAll('.solid-only')) element.hidden = !mesh.isSolid;
    for (const element of document.querySelectorAll('.quality-only')) element.hidden = !mesh.hasQuality;
    for (const element of document.querySelectorAll('.hybrid-only')) element.hidden = !mesh.isHybrid;
    for (const element of document.querySelectorAll('.not-hybrid')) element.hidden = mesh.isHybrid;
    byId('peel').max = mesh.about.layers - 1;
    byId('peel').disabled = mesh.about.layers < 2;
    byId('singular-title').textContent = mesh.isSolid ? 'Singular edges' : 'Edges not in two facets';
    if (mesh.edges.length === 0) byId('singular-note').textContent = 'There are none.';
  }

  /** `change` sets the state from the control. */
  on(id, event, change) {
    byId(id).addEventListener(event, ({ target }) => {
      change(target);
      this.view.update();
    });
  }

  bind() {
    const { state } = this;
    this.on('colour', 'change', ({ value }) => { state.colour = value; });
    this.on('slice-on', 'change', ({ checked }) => { state.slice.on = checked; });
    this.on('slice-axis', 'change', ({ value }) => this.sliceAlong(value));
    this.on('slice-at', 'input', ({ value }) => { Object.assign(state.slice, { on: true, at: Number(value) }); });
    this.on('slice-flip', 'change', ({ checked }) => { state.slice.flip = checked; });
    this.on('peel', 'input', ({ value }) => { state.peel = Number(value); });
    this.on('explode', 'input', ({ value }) => { state.explode = Number(value); });
    this.on('shrink', 'input', ({ value }) => { state.shrink = Number(value); });
    this.on('singular-interior', 'change', ({ checked }) => { state.singular.interior = checked; });
    this.on('singular-boundary', 'change', ({ checked }) => { state.singular.boundary = checked; });
    this.on('outline', 'change', ({ checked }) => { state.outline = checked; });
    byId('all').addEventListener('click', () => this.select(-1));
  }

  /** Along the view: the direction is that of the camera now. */
  sliceAlong(axis) {
    Object.assign(this.state.slice, { on: true, axis });
    if (axis === 'view') this.state.slice.normal = this.view.towardsCamera();
    this.view.update();
  }

  select(cell) {
    this.state.selected = cell;
    this.view.update();
  }

  show() {
    const { state, mesh } = this;
    byId('colour').value = state.colour;
    byId('slice-on').checked = state.slice.on;
    byId('slice-axis').value = state.slice.axis;
    byId('slice-at').value = state.slice.at;
    byId('slice-flip').checked = state.slice.flip;
    byId('slice-out').textContent = state.slice.on ? sliceWords(mesh, state.slice) : 'off';
    byId('peel').value = state.peel;
    byId('peel-out').textContent = `${state.peel} of ${mesh.about.layers}`;
    byId('explode').value = state.explode;
    byId('explode-out').textContent = number(state.explode, 2);
    byId('shrink').value = state.shrink;
    byId('shrink-out').textContent = number(state.shrink, 2);
    byId('singular-interior').checked = state.singular.interior;
    byId('singular-boundary').checked = state.singular.boundary;
    byId('outline').checked = state.outline;
    const unit = mesh.isHybrid ? 'cells' : mesh.shapeOf(0).plural;
    byId('shown').textContent = `${grouped(this.view.shownCount)} of ${grouped(mesh.count)} ${unit} shown`;
    byId('all').hidden = state.selected < 0;
    byId('cell').textContent = state.selected < 0 ? '' : cellWords(mesh, state.selected);
    markSelected(state.selected);
    this.showLegends();
  }

  showLegends() {
    const { colour, singular } = this.state;
    const key = `${colour} ${singular.interior} ${singular.boundary}`;
    if (key === this.legendKey) return;
    this.legendKey = key;
    byId('colour-legend').replaceChildren(...colourLegend(this.mesh, colour));
    byId('valence-legend').replaceChildren(...valenceLegend(this.mesh, singular));
  }
}
