// SPDX-License-Identifier: BSD-3-Clause
// Planes that take away what is beyond them: two along each axis, and one that faces the reader.
import * as THREE from "three";
import { h } from "./dom.js";
import { shownPlace } from "./scalars.js";

const steps = 1000;

export class Cuts {
  /// `box`: [low, high] from `centre`, of all that is shown.
  constructor(box, centre, dimension, onchange, facing) {
    Object.assign(this, { box, centre, dimension, onchange, facing });
    this.low = new THREE.Vector3().setScalar(-1e30);
    this.high = new THREE.Vector3().setScalar(1e30);
    this.plane = new THREE.Vector4(0, 0, 0, 1e30);
    this.uniforms = { cutLow: { value: this.low }, cutHigh: { value: this.high }, cutPlane: { value: this.plane } };
    this.clippingPlanes = Array.from({ length: 7 }, () => new THREE.Plane());
    this.controls = h("div", { className: "cuts" });
    for (let axis = 0; axis < dimension; ++axis) this.controls.append(this.axisRow(axis));
    if (dimension === 3) this.controls.append(this.facingRow());
    this.apply();
  }

  axisRow(axis) {
    const name = "xyz"[axis];
    const [from, to] = [this.box[0][axis], this.box[1][axis]];
    const said = h("output");
    const slider = (start, words) => h("input", { type: "range", min: 0, max: steps, value: start,
      "aria-label": `${name}, ${words}`, oninput: () => update() });
    const [low, high] = [slider(0, "from"), slider(steps, "to")];
    const at = (input) => from + (input.value / steps) * (to - from);
    const words = (start, end) => [start, end].map((x) => shownPlace(x + this.centre[axis], to - from)).join(" to ") + " m";
    const update = () => {
      const [start, end] = [at(low), at(high)];
      this.low.setComponent(axis, Number(low.value) === 0 ? -1e30 : start);
      this.high.setComponent(axis, Number(high.value) === steps ? 1e30 : end);
      said.textContent = words(start, end);
      this.apply();
    };
    this.resets = [...(this.resets ?? []), () => { low.value = 0; high.value = steps; update(); }];
    said.textContent = words(from, to);
    return h("div", { className: "cut" }, h("b", {}, name), low, high, said);
  }

  facingRow() {
    const normal = new THREE.Vector3();
    const slider = h("input", { type: "range", min: 0, max: steps, value: 0, "aria-label": "depth of the cut that faces you",
      oninput: () => update() });
    const reach = Math.hypot(...[0, 1, 2].map((axis) => this.box[1][axis] - this.box[0][axis])) / 2;
    const middle = new THREE.Vector3(...[0, 1, 2].map((axis) => (this.box[0][axis] + this.box[1][axis]) / 2));
    const update = () => {
      if (normal.lengthSq() === 0) normal.copy(this.facing());
      const depth = (slider.value / steps) * 2 * reach;
      this.plane.set(normal.x, normal.y, normal.z, Number(slider.value) === 0 ? 1e30 : normal.dot(middle) + reach - depth);
      this.apply();
    };
    const renew = h("button", { type: "button", title: "Turn this cut towards you",
      onclick: () => { normal.copy(this.facing()); if (Number(slider.value) === 0) slider.value = steps / 2; update(); } }, "face me");
    this.resets.push(() => { slider.value = 0; update(); normal.set(0, 0, 0); });
    return h("div", { className: "cut" }, h("b", { title: "A plane that faces you where you stand now" }, "oblique"), slider, renew);
  }

  reset() { for (const each of this.resets) each(); }

  isCut = (x, y, z) => x < this.low.x || y < this.low.y || z < this.low.z || x > this.high.x || y > this.high.y || z > this.high.z
    || x * this.plane.x + y * this.plane.y + z * this.plane.z > this.plane.w;

  apply() {
    const planes = this.clippingPlanes;
    ["x", "y", "z"].forEach((axis, k) => {
      planes[2 * k].normal.set(0, 0, 0)[axis] = 1;
      planes[2 * k].constant = -this.low[axis];
      planes[2 * k + 1].normal.set(0, 0, 0)[axis] = -1;
      planes[2 * k + 1].constant = this.high[axis];
    });
    planes[6].normal.set(-this.plane.x, -this.plane.y, -this.plane.z);
    planes[6].constant = this.plane.w;
    this.onchange();
  }
}
