// What the colours mean: a histogram of scaled Jacobians above its colours, the layers, the valences.
import { css, jacobianColour, layerColour, shapeColour, valenceColour } from './colours.js';
import { grouped, html, number, svg } from './dom.js';
import { SHAPES } from './mesh.js';

const WIDTH = 264;
const HEIGHT = 56;
const BAR = 10;
const BINS = 44;

/** [-1, 1], or [0, 1] if all are above zero. */
function rangeOf(mesh) {
  const least = mesh.jacobians.reduce((a, b) => Math.min(a, b), 1);
  return least > 0 ? [0, 1] : [-1, 1];
}

function countsIn(mesh, [low, high]) {
  const counts = new Uint32Array(BINS);
  for (const value of mesh.jacobians) {
    const bin = Math.min(BINS - 1, Math.max(0, Math.floor(((value - low) / (high - low)) * BINS)));
    // Zero has the colour of what is below.
    ++counts[value === 0 && low < 0 ? BINS / 2 - 1 : bin];
  }
  return counts;
}

function jacobianLegend(mesh) {
  const range = rangeOf(mesh);
  const [low, high] = range;
  const counts = countsIn(mesh, range);
  const most = Math.max(...counts);
  const step = WIDTH / BINS;
  const marks = [];
  counts.forEach((count, i) => {
    const colour = css(jacobianColour(low + ((i + 0.5) / BINS) * (high - low)));
    const height = count === 0 ? 0 : Math.max(2, (count / most) * HEIGHT);
    const bar = svg('rect', { x: i * step, y: HEIGHT - height, width: step - 1, height, class: 'bar' });
    bar.append(svg('title', {}, `${grouped(count)} from ${number(low + (i / BINS) * (high - low), 2)}`));
    marks.push(bar, svg('rect', { x: i * step, y: HEIGHT + 3, width: step + 0.3, height: BAR, fill: colour }));
  });
  for (let i = 0; i <= 4; ++i) {
    const value = low + (i / 4) * (high - low);
    const anchor = ['start', 'middle', 'middle', 'middle', 'end'][i];
    marks.push(
      svg('line', { x1: (i / 4) * WIDTH, x2: (i / 4) * WIDTH, y1: HEIGHT + 3 + BAR, y2: HEIGHT + 6 + BAR, class: 'tick' }),
      svg('text', { x: (i / 4) * WIDTH, y: HEIGHT + 18 + BAR, 'text-anchor': anchor }, number(value, low < 0 ? 1 : 2)),
    );
  }
  const mean = mesh.about.meanScaledJacobian;
  const least = mesh.about.minScaledJacobian;
  const words = `least ${number(least, 4)}, mean ${number(mean, 4)}`;
  const label = `Histogram of scaled Jacobians: ${words}, at most ${most} hexahedra in one of ${BINS} bins`;
  return [
    html('p', { class: 'legend-title' }, 'Scaled Jacobian'),
    svg('svg', { viewBox: `-1 0 ${WIDTH + 2} ${HEIGHT + BAR + 22}`, role: 'img', 'aria-label': label }, ...marks),
    html('p', { class: 'note' }, words),
  ];
}

function swatch(colour, ...words) {
  return html('li', {}, html('span', { class: 'swatch', style: `background:${colour}` }), ...words);
}

function layerLegend(mesh) {
  const sizes = new Map();
  for (const layer of mesh.layers) sizes.set(layer, (sizes.get(layer) ?? 0) + 1);
  const deepest = mesh.about.layers - 1;
  const step = Math.max(1, Math.ceil((deepest + 1) / 8));
  const rows = [];
  for (let layer = 0; layer <= deepest; layer += step)
    rows.push(swatch(css(layerColour(layer, deepest)), `${layer}`, html('span', {}, grouped(sizes.get(layer) ?? 0))));
  return [
    html('p', { class: 'legend-title' }, mesh.isHybrid ? 'Layer, and its cells' : 'Layer, and its hexahedra'),
    html('ul', { class: 'swatches' }, ...rows),
  ];
}

function shapeLegend({ about }) {
  const rows = SHAPES.map(({ plural }, shape) => [plural, shape]).filter(([plural]) => about.counts[plural] > 0)
    .map(([plural, shape]) => swatch(css(shapeColour(shape)), plural, html('span', {}, grouped(about.counts[plural]))));
  return [html('p', { class: 'legend-title' }, 'Shape'), html('ul', { class: 'swatches' }, ...rows)];
}

export function colourLegend(mesh, way) {
  if (way === 'shape') return shapeLegend(mesh);
  if (way === 'jacobian') return jacobianLegend(mesh);
  return way === 'layer' ? layerLegend(mesh) : [];
}

/** One row for each valence and kind of edge that is shown. */
export function valenceLegend(mesh, { interior, boundary }) {
  const counts = new Map();
  for (let at = 0; at < mesh.edges.length; at += 4) {
    if (!(mesh.edges[at + 3] ? boundary : interior)) continue;
    const key = 2 * mesh.edges[at + 2] + mesh.edges[at + 3];
    counts.set(key, (counts.get(key) ?? 0) + 1);
  }
  const rows = [...counts].sort(([a], [b]) => a - b).map(([key, count]) => {
    const valence = key >> 1;
    const colour = `#${valenceColour(valence).toString(16).padStart(6, '0')}`;
    const kind = key & 1 ? 'boundary' : 'interior';
    return swatch(colour, mesh.isSolid ? `valence ${valence}, ${kind}` : `in ${valence}`, html('span', {}, grouped(count)));
  });
  return rows.length === 0 ? [] : [html('ul', { class: 'swatches' }, ...rows)];
}
