// Elements in one expression.

const SVG = 'http://www.w3.org/2000/svg'; // a name, not an address: nothing is fetched

function filled(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

export const byId = (id) => document.getElementById(id);

export function html(tag, attributes = {}, ...children) {
  return filled(document.createElement(tag), attributes, children);
}

export function svg(tag, attributes = {}, ...children) {
  return filled(document.createElementNS(SVG, tag), attributes, children);
}

/** -0.9309 with a true minus sign; digits stand below each other. */
export function number(value, digits) {
  const text = value.toFixed(digits);
  return Number(text) === 0 ? (0).toFixed(digits) : text.replace('-', '\u2212');
}

export const grouped = (count) => String(count).replace(/\B(?=(\d{3})+$)/g, '\u202f');
