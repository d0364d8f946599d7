// Colours that people with any kind of colour vision can tell apart, on a light background.

// Scaled Jacobian: from brown to light orange below zero, from light to strong blue above. Blue and orange
// differ for all common kinds of colour blindness; the step at zero says on which side a cell is.
const BELOW = [[-1, 0x8c, 0x3a, 0x04], [-0.5, 0xe0, 0x7b, 0x1a], [0, 0xfb, 0xd9, 0xa8]];
const ABOVE = [[0, 0xe8, 0xf1, 0xf7], [0.5, 0x98, 0xc4, 0xe4], [1, 0x35, 0x7d, 0xbc]];

// Layers: lightness falls from the boundary to the inside.
const DEPTH = [
  [0, 0xf3, 0xe5, 0xa1], [0.33, 0xa9, 0xc4, 0x8f], [0.67, 0x4f, 0x8f, 0x93], [1, 0x2d, 0x4a, 0x7a],
];

// Shapes, as SHAPES has them: light enough for their edges, apart for all common kinds of colour blindness.
const SHAPE_COLOURS = [[0xe6, 0x9f, 0x53], [0x9c, 0xc6, 0xe6], [0x6f, 0xb9, 0x9b], [0xd2, 0x8c, 0xb8]];

export function shapeColour(shape) {
  return SHAPE_COLOURS[shape];
}

export const PLAIN = [0xc3, 0xd0, 0xdc];

function between(stops, value) {
  let i = 1;
  while (i < stops.length - 1 && value > stops[i][0]) ++i;
  const [from, to] = [stops[i - 1], stops[i]];
  const t = Math.min(1, Math.max(0, (value - from[0]) / (to[0] - from[0])));
  return [1, 2, 3].map((k) => Math.round(from[k] + t * (to[k] - from[k])));
}

/** Zero is not valid and takes the side of the inverted ones. */
export function jacobianColour(value) {
  return between(value > 0 ? ABOVE : BELOW, value);
}

export function layerColour(layer, deepest) {
  return between(DEPTH, deepest === 0 ? 0 : layer / deepest);
}

export function css([r, g, b]) {
  return `rgb(${r} ${g} ${b})`;
}

// Valences of singular edges, after the palette of Okabe and Ito without its light colours.
const VALENCES = new Map([
  [1, 0x3c4650], [2, 0xc98a00], [3, 0xd1440c], [4, 0x00855f], [5, 0x0067a8], [6, 0xb8558f], [7, 0x3aa0dc],
]);
const MANY = 0x6a3d9a;

export function valenceColour(valence) {
  return VALENCES.get(valence) ?? MANY;
}

/** The red, green and blue of each cell, one after the other. */
export function cellColours(mesh, way) {
  const deepest = mesh.about.layers - 1;
  const colours = new Uint8Array(3 * mesh.count);
  for (let cell = 0; cell < mesh.count; ++cell) {
    let colour = PLAIN;
    if (way === 'jacobian') colour = jacobianColour(mesh.jacobians[cell]);
    else if (way === 'shape') colour = shapeColour(mesh.shapes[cell]);
    else if (way === 'layer') colour = layerColour(mesh.layers[cell], deepest);
    colours.set(colour, 3 * cell);
  }
  return colours;
}
