// SPDX-License-Identifier: BSD-3-Clause
// Particles as discs, in space shaded like spheres; cut and coloured by the graphics processor.
import * as THREE from "three";

const vertex = `
attribute float value;
uniform vec3 cutLow, cutHigh;
uniform vec4 cutPlane;
uniform float size;
varying float shownValue;
void main() {
  bool cut = any(lessThan(position, cutLow)) || any(greaterThan(position, cutHigh)) || dot(position, cutPlane.xyz) > cutPlane.w;
  shownValue = value;
  gl_PointSize = size;
  gl_Position = cut ? vec4(2.0, 2.0, 2.0, 1.0) : projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const fragment = `
uniform sampler2D colours;
uniform float low, high, size;
uniform bool shaded, plain;
varying float shownValue;
void main() {
  vec2 place = 2.0 * gl_PointCoord - 1.0;
  float outwards = dot(place, place);
  if (size > 2.5 && outwards > 1.0) discard;
  vec3 colour = vec3(0.72);
  if (!plain && shownValue == shownValue) {  // a number
    float share = clamp((shownValue - low) / (high - low), 0.0, 1.0);
    colour = texture2D(colours, vec2((0.5 + 255.0 * share) / 256.0, 0.5)).rgb;
  }
  if (shaded && size > 2.5) {
    vec3 normal = vec3(place.x, -place.y, sqrt(max(1.0 - outwards, 0.0)));
    colour *= 0.5 + 0.5 * max(dot(normal, vec3(-0.37, 0.56, 0.74)), 0.0);
  }
  gl_FragColor = vec4(colour, 1.0);
}`;

/// A step with which i -> i step mod count goes through all numbers in an order of which any beginning is spread evenly.
function spreadingStep(count) {
  const divisor = (a, b) => (b ? divisor(b, a % b) : a);
  let step = Math.max(Math.round(0.6180339887 * count), 1);
  while (divisor(step, count) !== 1) ++step;
  return step;
}

export class Particles {
  constructor(shared, { shaded, plain = false, overlap }) {
    this.overlap = overlap;
    this.geometry = new THREE.BufferGeometry();
    this.uniforms = { ...shared, size: { value: 4 }, low: { value: 0 }, high: { value: 1 }, colours: { value: null },
      shaded: { value: shaded }, plain: { value: plain } };
    const material = new THREE.ShaderMaterial({ vertexShader: vertex, fragmentShader: fragment, uniforms: this.uniforms });
    this.object = new THREE.Points(this.geometry, material);
    this.object.frustumCulled = false;
    this.order = new Uint32Array(0);
  }

  /// Shows the particles of which `isShown(i)` holds, in an order of which any first part is spread over all of them.
  place(positions, isShown) {
    const count = positions.length / 3;
    const step = spreadingStep(count);
    const order = new Uint32Array(count);
    let shown = 0;
    for (let k = 0, i = 0; k < count; ++k, i = (i + step) % count) if (isShown(i)) order[shown++] = i;
    this.order = order.subarray(0, shown);
    const points = new Float32Array(3 * shown);
    for (let k = 0; k < shown; ++k) {
      const from = 3 * this.order[k];
      points[3 * k] = positions[from];
      points[3 * k + 1] = positions[from + 1];
      points[3 * k + 2] = positions[from + 2];
    }
    this.points = points;
    this.attribute("position", points, 3);
  }

  colour(values) {
    this.attribute("value", Float32Array.from(this.order, (i) => values[i]), 1);
  }

  attribute(name, array, size) {
    const old = this.geometry.getAttribute(name);
    if (old && old.array.length === array.length) {
      old.array.set(array);
      old.needsUpdate = true;
      return;
    }
    if (old) {  // buffers on the graphics processor keep their size
      const others = Object.entries(this.geometry.attributes).filter(([other]) => other !== name);
      this.geometry.dispose();
      this.geometry = this.object.geometry = new THREE.BufferGeometry();
      for (const [other, kept] of others) if (kept.count === array.length / size) this.geometry.setAttribute(other, kept);
    }
    const fresh = new THREE.BufferAttribute(array, size);
    fresh.setUsage(THREE.DynamicDrawUsage);
    this.geometry.setAttribute(name, fresh);
  }

  /// Draws the first part of the particles, with discs that fill the gaps.
  drawShare(share, pixelsPerMetre, disc, dimension) {
    const count = Math.max(Math.ceil(share * this.order.length), Math.min(this.order.length, 1));
    this.geometry.setDrawRange(0, count);
    this.uniforms.size.value = Math.max(pixelsPerMetre * disc * this.overlap * share ** (-1 / dimension), 1.5);
  }
}
