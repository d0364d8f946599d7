// How a facet looks: its colour, a light beside the camera, and its edges, drawn where a side is near. So edges
// need no geometry of their own, have the same width everywhere, and fade where cells are small.
import { DoubleSide, ShaderMaterial } from 'three';

const VERTEX = `
  attribute vec4 colour;
  attribute vec4 sides;
  varying vec3 v_colour;
  varying vec4 v_sides;
  varying vec3 v_normal;
  void main() {
    v_colour = colour.rgb;
    v_sides = sides;
    v_normal = normalMatrix * normal;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  }`;

const FRAGMENT = `
  uniform float edgeWidth;
  varying vec3 v_colour;
  varying vec4 v_sides;
  varying vec3 v_normal;
  const vec3 kInk = vec3(0.10, 0.14, 0.19);
  void main() {
    float light = abs(dot(normalize(v_normal + vec3(0.0, 0.0, 1e-5)), normalize(vec3(0.25, 0.45, 1.0))));
    vec3 colour = v_colour * (0.71 + 0.31 * light);
    vec4 perPixel = max(fwidth(v_sides), vec4(1e-6));
    vec4 pixels = v_sides / perPixel;
    float nearest = min(min(pixels.x, pixels.y), min(pixels.z, pixels.w));
    float edge = 1.0 - smoothstep(edgeWidth - 0.7, edgeWidth + 0.7, nearest);
    float across = 1.0 / max(max(perPixel.x, perPixel.y), max(perPixel.z, perPixel.w));
    edge *= 0.9 * smoothstep(1.5, 14.0 * edgeWidth, across);
    gl_FragColor = vec4(mix(colour, kInk, edge), 1.0);
  }`;

export function surfaceMaterial(edgeWidth) {
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: { edgeWidth: { value: edgeWidth } },
    side: DoubleSide,
  });
}
