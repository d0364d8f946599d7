// The hexahedra of the least scaled Jacobian, each a button that shows it alone.
import { byId, html, number } from './dom.js';
import { statusWord } from './mesh.js';

const SHOWN = 12;

/** The k cells of least value, the least first; equal ones by their numbers. Linear but for the k. */
export function worstCells(values, k) {
  const list = [];
  for (let cell = 0; cell < values.length; ++cell) {
    if (list.length === k && !(values[cell] < values[list[k - 1]])) continue;
    let at = list.length;
    while (at > 0 && values[cell] < values[list[at - 1]]) --at;
    list.splice(at, 0, cell);
    if (list.length > k) list.pop();
  }
  return list;
}

export function fillWorst(mesh, select) {
  const rows = worstCells(mesh.jacobians, SHOWN).map((cell) => {
    const button = html('button', { type: 'button', 'data-cell': cell },
      html('span', {}, `No. ${cell}`),
      html('span', { class: 'value' }, number(mesh.jacobians[cell], 4)),
      html('span', { class: 'status' }, statusWord(mesh, cell)));
    button.addEventListener('click', () => select(cell));
    return html('li', {}, button);
  });
  byId('worst-list').replaceChildren(...rows);
}

export function markSelected(cell) {
  for (const button of document.querySelectorAll('#worst-list button'))
    button.setAttribute('aria-pressed', String(Number(button.dataset.cell) === cell));
}
