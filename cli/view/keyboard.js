// Keys for everything that is done often; the page lists them.
import { byId, html } from './dom.js';

const clamp = (value, low, high) => Math.min(high, Math.max(low, value));
const rounded = (value) => Math.round(value * 1000) / 1000; // no 0.30000000000000004 after some steps

function stepper(panel, change) {
  return () => {
    change(panel.state);
    panel.view.update();
  };
}

/** Key, what it does in words, and what it does. Two keys of a row go down and up. */
function rows(panel, home) {
  const { view, mesh } = panel;
  const slice = (by) => stepper(panel, (s) => {
    Object.assign(s.slice, { on: true, at: rounded(clamp(s.slice.at + by, 0, 1)) });
  });
  const value = (name, by, high) => stepper(panel, (s) => { s[name] = rounded(clamp(s[name] + by, 0, high)); });
  const towards = (azimuth, elevation) => () => view.look(azimuth, elevation);
  const ways = mesh.isSolid ? ['jacobian', 'layer', 'none'] : ['none'];
  return [
    [['r'], 'reset the view', home],
    [['f'], 'fit what is shown', () => view.fit()],
    [['1', '2', '3'], 'look along x, y, z', towards(0, 0), towards(-90, 0), towards(-90, 90)],
    [['x', 'y', 'z'], 'slice across x, y, z', ...['x', 'y', 'z'].map((k) => () => panel.sliceAlong(k))],
    [['v'], 'slice across the view', () => panel.sliceAlong('view')],
    [['s'], 'slice on or off', stepper(panel, (s) => { s.slice.on = !s.slice.on; })],
    [['t'], 'turn the slice around', stepper(panel, (s) => { s.slice.flip = !s.slice.flip; })],
    [['[', ']'], 'move the slice', slice(-0.02), slice(0.02)],
    [['-', '+'], 'peel fewer, more layers', value('peel', -1, mesh.about.layers - 1), value('peel', 1, mesh.about.layers - 1)],
    [['q', 'w'], 'explode less, more', value('explode', -0.1, 2), value('explode', 0.1, 2)],
    [['a', 'd'], 'shrink less, more', value('shrink', -0.05, 0.9), value('shrink', 0.05, 0.9)],
    [['c'], 'next colouring', stepper(panel, (s) => { s.colour = ways[(ways.indexOf(s.colour) + 1) % ways.length]; })],
    [['e'], 'singular edges', stepper(panel, (s) => { s.singular.interior = !s.singular.interior; })],
    [['o'], 'outline', stepper(panel, (s) => { s.outline = !s.outline; })],
    [['Escape'], 'all cells again', () => panel.select(-1)],
  ];
}

export function bindKeys(panel, home) {
  const actions = new Map();
  const list = byId('keys');
  for (const [keys, words, ...does] of rows(panel, home)) {
    keys.forEach((key, i) => actions.set(key, does[i]));
    const caps = keys.flatMap((key) => [html('kbd', {}, key === 'Escape' ? 'Esc' : key), ' ']);
    list.append(html('dt', {}, ...caps), html('dd', {}, words));
  }
  actions.set('=', actions.get('+')); // the same key without shift
  window.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.tagName === 'SELECT') return;
    const action = actions.get(event.key.length === 1 ? event.key.toLowerCase() : event.key);
    if (!action) return;
    event.preventDefault();
    action();
  });
}
