// SPDX-License-Identifier: BSD-3-Clause
// One picture: what is shown, and what happens when something about it changes.
import { kindColour, texture } from "./colours.js";
import { Cuts } from "./cuts.js";
import { h } from "./dom.js";
import { Overlay } from "./overlay.js";
import { Panel } from "./panel.js";
import { Particles } from "./particles.js";
import { particleAt } from "./pick.js";
import { limitsOf, scalarsOf, shown, shownUnit, valuesOf } from "./scalars.js";
import { Source } from "./source.js";
import { Stage } from "./stage.js";
import { discard, groundObject, wallObject } from "./surfaces.js";

export class Picture {
  constructor(root) {
    this.root = root;
    this.source = new Source(root);
    this.known = new Map();  // entries of frames, for the ranges of colour
    this.number = 0;         // of the frame that is shown
    this.show = { walls: true, start: false, kinds: [] };
    this.choice = { map: "viridis", range: null };
    this.wanted = 0;
  }

  async begin() {
    await this.waitForFrames();
    const frames = this.index.frames;
    this.number = frames.length - 1;
    const first = await this.entryOf(frames[0]);
    const last = await this.entryOf(frames[this.number]);
    const pad = (corner) => [...corner, 0].slice(0, 3);
    const [low, high] = [0, 1].map((end) => pad(first.box[end]).map((x, axis) =>
      Math[end ? "max" : "min"](x, pad(last.box[end])[axis]) + (axis < this.index.dimension ? (end - 0.5) * this.index.spacing : 0)));
    this.centre = low.map((x, axis) => (x + high[axis]) / 2);
    this.box = [low, high].map((corner) => corner.map((x, axis) => x - this.centre[axis]));
    this.scalars = scalarsOf(this.index, last);
    this.choice.scalar = this.scalars[0];
    const { dimension, materials } = this.index;
    const terrain = dimension === 3 && materials.some(({ model }) => model !== "linear_elastic");
    this.show.kinds = materials.map(({ model }) => (terrain && model === "linear_elastic" ? "surface" : "particles"));
    this.build();
    await this.showFrame(this.number);
    if (this.source.follows) this.follow();
  }

  async waitForFrames() {
    const waits = h("p", {}, "The run has not written a frame yet; the picture begins with the first one.");
    while (!(this.index = await this.source.index()).frames.length) {
      this.root.append(waits);
      await new Promise((resolve) => setTimeout(resolve, 1000));
    }
    waits.remove();
  }

  build() {
    const { dimension } = this.index;
    const host = h("div", { className: "host" });
    this.root.append(host);
    this.stage = new Stage(host, dimension, (share, pixels) => {
      this.particles.drawShare(share, pixels, this.index.disc, dimension);
      this.before.drawShare(share, pixels, this.index.disc, dimension);
    });
    this.cuts = new Cuts(this.box, this.centre, dimension, () => this.stage.stir(), () => this.stage.facing);
    const { uniforms } = this.cuts;
    this.particles = new Particles(uniforms, { shaded: dimension === 3, overlap: dimension === 3 ? 1.3 : 1.45 });
    this.before = new Particles(uniforms, { shaded: false, plain: true, overlap: 1.45 });  // in a plane scene, where the soil was
    this.before.object.renderOrder = -1;
    this.before.object.position.z = -1e-3 * this.index.spacing;
    this.stage.scene.add(this.particles.object, this.before.object);
    this.overlay = new Overlay(this.stage);
    this.stage.afterDrawing = () => {
      this.overlay.update();
      if (this.complete) Object.assign(this.root.dataset, { frame: this.number, ready: this.complete });
    };
    this.panel = new Panel(this);
    this.stage.fit(...this.box);
    this.listen();
  }

  listen() {
    const { canvas } = this.stage;
    let pressed = null;
    canvas.addEventListener("pointerdown", (event) => { pressed = [event.clientX, event.clientY]; });
    canvas.addEventListener("pointerup", (event) => {
      if (pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) < 4) this.pick(event.offsetX, event.offsetY);
      pressed = null;
    });
    canvas.addEventListener("webglcontextlost", () => this.panel.say("The browser took the graphics away. Load the page again."));
  }

  async entryOf(frame) {
    const entry = await this.source.entry(frame);
    this.known.set(frame.key ?? frame.number, entry);
    return entry;
  }

  /// Shows a moment; of several that are asked for at once the last.
  async showFrame(number) {
    const ticket = ++this.wanted;
    const frame = this.index.frames[number];
    const { scalar } = this.choice;
    const entry = await this.entryOf(frame);
    const [positions, values] = await Promise.all([this.source.positions(frame, this.centre),
      valuesOf(scalar, this.source, frame, this.centre)]);
    const kinds = entry.fields.material && this.show.kinds.some((how) => how !== "particles")
      ? (await this.source.field(frame, "material"))[0] : null;
    if (ticket !== this.wanted) return;
    this.number = number;
    this.particles.place(positions, kinds ? (i) => (this.show.kinds[kinds[i]] ?? "particles") === "particles" : () => true);
    this.particles.colour(values);
    this.showSurfaces(entry, positions, kinds);
    this.showColours();
    await this.showPicked();
    this.panel.update(entry);
    this.complete = ticket;
    this.stage.redraw();
  }

  again() { return this.showFrame(this.number); }

  showSurfaces(entry, positions, kinds) {
    for (const object of this.surfaces ?? []) {
      this.stage.scene.remove(object);
      discard(object);
    }
    const { clippingPlanes } = this.cuts;
    const walls = this.index.walls[entry.walls] ?? entry.faces;
    this.surfaces = [
      walls && this.show.walls ? wallObject(walls, this.centre, clippingPlanes) : null,
      ...(kinds ? this.show.kinds.map((how, kind) => (how !== "surface" ? null : groundObject(positions, (i) => kinds[i] === kind,
        this.index.disc, { colour: this.kindColour(kind), clippingPlanes }))) : []),
      this.start && this.show.start && this.index.dimension === 3 ? groundObject(this.start, () => true, this.index.disc,
        { colour: 0x3366aa, opacity: 0.35, clippingPlanes }) : null,
    ].filter(Boolean);
    this.surfaces.forEach((object) => this.stage.scene.add(object));
    this.before.object.visible = this.show.start && this.index.dimension === 2;
  }

  /// A material that is a surface is paler than its particles are.
  kindColour(kind) {
    return `#${[1, 3, 5].map((at) => Math.round(150 + 0.3 * parseInt(kindColour(kind).slice(at, at + 2), 16)).toString(16)).join("")}`;
  }

  async showStart(wanted) {
    this.show.start = wanted;
    if (wanted && !this.start) {
      this.start = await this.source.positions(this.index.frames[0], this.centre);
      this.before.place(this.start, () => true);
      this.before.colour(new Float32Array(this.start.length / 3));
    }
    return this.again();
  }

  /// The range of the scalar over all moments that are known, in SI.
  get ownRange() {
    const all = [...this.known.values(), ...(this.source.follows ? [] : this.index.frames)];
    const limits = all.map((entry) => limitsOf(this.choice.scalar, entry));
    return [Math.min(...limits.map(([low]) => low)), Math.max(...limits.map(([, high]) => high))];
  }

  get isKind() { return this.choice.scalar.field === "material" && this.index.materials.length > 0; }

  showColours() {
    const { map, scalar, range } = this.choice;
    const { uniforms } = this.particles;
    const count = this.isKind ? this.index.materials.length : 0;
    const [low, high] = count ? [-0.5, count - 0.5] : range ?? this.ownRange;
    uniforms.low.value = low;
    uniforms.high.value = high > low ? high : low + Math.max(Math.abs(low) * 1e-6, 1e-30);
    const look = `${map} ${count}`;
    if (this.look !== look) {
      uniforms.colours.value?.dispose();
      uniforms.colours.value = texture(map, count);
      this.look = look;
    }
    const [unit, factor] = shownUnit(scalar.unit);
    if (count) this.overlay.showKinds("material", this.index.materials.map(({ name }) => name));
    else this.overlay.showRange({ title: `${scalar.words} [${unit}]`, low: low * factor, high: high * factor, map });
    this.stage.redraw();
  }

  setRange(range) {
    this.choice.range = range;
    this.showColours();
    this.panel.showRange();
  }

  async setScalar(key) {
    this.choice.scalar = this.scalars.find((scalar) => scalar.key === key);
    this.choice.range = null;
    await this.again();
  }

  async pick(x, y) {
    const radius = (this.stage.scale * this.index.disc) / 2;
    const at = particleAt(x, y, this.stage, this.particles, radius, this.cuts.isCut);
    const frame = this.index.frames[this.number];
    this.picked = at < 0 ? null : (await this.source.field(frame, "id"))[0][at];
    await this.showPicked();
    this.stage.redraw();
  }

  /// The mark and the numbers of the picked particle at this moment.
  async showPicked() {
    const frame = this.index.frames[this.number];
    this.overlay.marked = null;
    if (this.picked === null || this.picked === undefined) return this.panel.showPicked(null);
    const ids = (await this.source.field(frame, "id"))[0];
    const at = ids.indexOf(this.picked);
    if (at < 0) return this.panel.showPicked({ id: this.picked, rows: [["at this moment", "outside the picture"]] });
    const positions = await this.source.positions(frame, this.centre);
    this.overlay.marked = Array.from(positions.subarray(3 * at, 3 * at + 3));
    const rows = [];
    for (const scalar of this.scalars) {
      if (scalar.field === "id") continue;
      const value = (await valuesOf(scalar, this.source, frame, this.centre))[at];
      const [unit, factor] = shownUnit(scalar.unit);
      const kind = scalar.field === "material" ? this.index.materials[value]?.name : undefined;
      rows.push([scalar.words, kind ?? `${shown(value * factor)}${unit === "-" ? "" : ` ${unit}`}`]);
    }
    this.panel.showPicked({ id: this.picked, rows });
  }

  /// Looks for new frames of a run that goes on; stays at the newest one if that is shown.
  async follow() {
    for (;;) {
      await new Promise((resolve) => setTimeout(resolve, 1000));
      try {
        const fresh = await this.source.index();
        const same = fresh.frames.length === this.index.frames.length
          && fresh.frames.every(({ key }, k) => key === this.index.frames[k].key);
        this.panel.say(fresh.notes.join(" "));
        if (same || !fresh.frames.length) continue;
        const atEnd = this.number >= this.index.frames.length - 1;
        const begunAnew = fresh.frames[0].key !== this.index.frames[0].key;
        this.index = fresh;
        if (begunAnew) {
          [this.start, this.picked] = [null, null];
          this.known.clear();
        }
        await this.showFrame(atEnd || begunAnew ? fresh.frames.length - 1 : Math.min(this.number, fresh.frames.length - 1));
      } catch (error) {
        this.panel.say(`The run cannot be followed: ${error.message}. Is scarp watch still there?`);
      }
    }
  }
}
