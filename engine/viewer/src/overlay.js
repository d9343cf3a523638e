// SPDX-License-Identifier: BSD-3-Clause
// What lies over the picture: legend, scale bar, axes, the mark of the picked particle.
import * as THREE from "three";
import { gradient, kindColour } from "./colours.js";
import { h } from "./dom.js";
import { shown } from "./scalars.js";

/// The largest of 1, 2, 5, 10, ... that is not above a length.
function roundBelow(length) {
  const power = 10 ** Math.floor(Math.log10(length));
  return [5, 2, 1].find((step) => step * power <= length * 1.000001) * power;
}

export class Overlay {
  constructor(stage) {
    this.stage = stage;
    this.legend = h("div", { className: "legend" });
    this.bar = h("div", { className: "scale" });
    this.mark = h("div", { className: "mark", hidden: true });
    stage.host.append(this.legend, this.bar, this.mark);
    this.axes = stage.dimension === 3 ? h("div", { className: "axes", "aria-hidden": "true" }) : null;
    if (this.axes) stage.host.append(this.axes);
    this.marked = null;
  }

  /// `numbers`: {title, low, high, map}, in the unit that is shown.
  showRange({ title, low, high, map }) {
    const bar = h("div", { className: "bar" });
    bar.style.background = gradient(map);
    const ticks = [4, 3, 2, 1, 0].map((k) => h("span", {}, shown(low + (k / 4) * (high - low))));
    this.legend.replaceChildren(h("b", {}, title), h("div", { className: "range" }, bar, h("div", { className: "ticks" }, ...ticks)));
  }

  showKinds(title, names) {
    const rows = names.map((name, number) => {
      const swatch = h("i");
      swatch.style.background = kindColour(number);
      return h("div", { className: "kind" }, swatch, name);
    });
    this.legend.replaceChildren(h("b", {}, title), ...rows);
  }

  update() {
    const length = roundBelow(130 / this.stage.scale);
    this.bar.style.width = `${length * this.stage.scale}px`;
    this.bar.textContent = length < 0.1 ? `${shown(length * 1000)} mm` : `${shown(length)} m`;
    if (this.axes) this.drawAxes();
    this.mark.hidden = !this.marked;
    if (!this.marked) return;
    const place = new THREE.Vector3(...this.marked).project(this.stage.camera);
    const { clientWidth: width, clientHeight: height } = this.stage.host;
    const [x, y] = [((place.x + 1) / 2) * width, ((1 - place.y) / 2) * height];
    this.mark.hidden = x < 0 || y < 0 || x > width || y > height;
    this.mark.style.transform = `translate(${x}px, ${y}px)`;
  }

  drawAxes() {
    const turned = new THREE.Matrix3().setFromMatrix4(this.stage.camera.matrixWorldInverse);
    const arms = ["x", "y", "z"].map((name, axis) => {
      const arm = new THREE.Vector3(axis === 0, axis === 1, axis === 2).applyMatrix3(turned);
      const [x, y] = [40 + 26 * arm.x, 40 - 26 * arm.y];
      return { depth: arm.z, svg: `<line x1="40" y1="40" x2="${x}" y2="${y}"/>
        <text x="${40 + 34 * arm.x}" y="${44 - 34 * arm.y}">${name}</text>` };
    });
    arms.sort((a, b) => a.depth - b.depth);
    this.axes.innerHTML = `<svg width="80" height="80">${arms.map(({ svg }) => svg).join("")}</svg>`;
  }
}
