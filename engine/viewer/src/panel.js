// SPDX-License-Identifier: BSD-3-Clause
// Controls below the picture, and the keyboard.
import { mapNames } from "./colours.js";
import { choice, h } from "./dom.js";
import { shown, shownUnit } from "./scalars.js";

const keys = [
  ["space", "play or stop"], ["← →", "moment before, after"], ["Home End", "first, last moment"],
  ["Shift + arrows", "turn (3D)"], ["+ −", "closer, farther"], ["f", "show all"], ["Esc", "no particle picked"],
];

export class Panel {
  constructor(picture) {
    this.picture = picture;
    this.speed = 10;
    const { index, stage } = picture;
    this.play = h("button", { type: "button", className: "play", onclick: () => this.toggle() }, "▶");
    this.slider = h("input", { type: "range", min: 0, "aria-label": "moment", oninput: () => picture.showFrame(Number(this.slider.value)) });
    this.moment = h("output", { className: "moment" });
    const speed = choice("speed", [2, 5, 10, 20].map((n) => [n, `${n} pictures/s`]), (value) => { this.speed = Number(value); });
    speed.select.value = this.speed;
    const time = h("div", { className: "row time" }, this.play, this.slider, this.moment, speed.label);

    const colour = choice("colour by", picture.scalars.map(({ key, words }) => [key, words]), (key) => picture.setScalar(key));
    this.colour = colour.select;
    const number = (words) => h("input", { type: "number", step: "any", "aria-label": words, onchange: () => this.takeRange() });
    [this.low, this.high] = [number("lowest value of the colours"), number("highest value of the colours")];
    this.unit = h("span");
    this.own = h("button", { type: "button", title: "The range of all moments, without the 0.2 % most extreme values",
      onclick: () => picture.setRange(null) }, "whole range");
    const map = choice("colours", mapNames.map((name) => [name, name]), (name) => { picture.choice.map = name; picture.showColours(); });
    this.range = h("span", { className: "group" }, "from ", this.low, " to ", this.high, " ", this.unit, this.own, map.label);
    this.meaning = h("span", { className: "meaning" });
    const colours = h("div", { className: "row" }, colour.label, this.range, this.meaning);

    const shows = h("div", { className: "row" });
    const tick = (words, checked, onchange) => h("label", {}, h("input", { type: "checkbox", checked, onchange() { onchange(this.checked); } }), words);
    if (index.walls.length || picture.source.follows) shows.append(tick("walls", true, (on) => { picture.show.walls = on; picture.again(); }));
    shows.append(tick(index.dimension === 2 ? "where the soil was at the start (grey)" : "ground at the start (blue)", false,
      (on) => picture.showStart(on)));
    if (index.dimension === 3 || index.materials.length > 1) {
      index.materials.forEach(({ name }, kind) => {
        const ways = [["particles", "particles"], ...(index.dimension === 3 ? [["surface", "surface"]] : []), ["hidden", "hidden"]];
        const how = choice(`${name}:`, ways, (value) => { picture.show.kinds[kind] = value; picture.again(); });
        how.select.value = picture.show.kinds[kind];
        shows.append(how.label);
      });
    }
    const fit = h("button", { type: "button", onclick: () => this.showAll() }, "show all");
    const full = h("button", { type: "button", onclick: () => (document.fullscreenElement ? document.exitFullscreen()
      : picture.root.requestFullscreen()) }, "full screen");
    if (!document.fullscreenEnabled) full.hidden = true;
    shows.append(fit, full);

    const cuts = h("details", {}, h("summary", {}, "cut"), picture.cuts.controls,
      h("button", { type: "button", onclick: () => picture.cuts.reset() }, "no cut"));
    const help = h("details", {}, h("summary", {}, "keys and mouse"), h("p", {}, index.dimension === 3
      ? "Drag to turn, drag with the right button (or two fingers) to shift, wheel to come closer. Click a particle to read it."
      : "Drag to shift, wheel to come closer. Click a particle to read it."),
    h("table", {}, ...keys.map(([key, words]) => h("tr", {}, h("td", {}, h("kbd", {}, key)), h("td", {}, words)))));
    this.picked = h("div", { className: "picked", hidden: true });
    stage.host.append(this.picked);
    this.notes = h("p", { className: "notes" }, "");
    this.outside = h("p", { className: "notes" }, "");
    picture.root.append(time, colours, shows, cuts, help, this.notes, this.outside);
    this.say(index.notes.join(" "));
    picture.root.tabIndex = 0;
    picture.root.addEventListener("keydown", (event) => this.key(event));
    stage.canvas.addEventListener("pointerdown", () => picture.root.focus({ preventScroll: true }));
    // Within a longer page the wheel scrolls until the picture has been clicked.
    const inPage = !picture.root.classList.contains("alone");
    stage.controls.enableZoom = !inPage;
    picture.root.addEventListener("focusin", () => { stage.controls.enableZoom = true; });
    picture.root.addEventListener("focusout", ({ relatedTarget }) => {
      stage.controls.enableZoom = !inPage || picture.root.contains(relatedTarget);
    });
  }

  say(words) {
    this.notes.textContent = words;
    this.notes.hidden = !words;
  }

  update(entry) {
    const { index, number } = this.picture;
    this.slider.max = index.frames.length - 1;
    this.slider.value = number;
    this.slider.disabled = this.play.disabled = index.frames.length < 2;
    const stage = entry.stage ? `, stage “${entry.stage}”` : "";
    this.moment.textContent = `t = ${shown(entry.time)} s${stage} (${number + 1} of ${index.frames.length})`;
    this.outside.textContent = entry.outside ?? "";
    this.outside.hidden = !entry.outside;
    this.colour.value = this.picture.choice.scalar.key;
    const { description, field } = this.picture.choice.scalar;
    this.meaning.textContent = description === field ? "" : description;
    this.showRange();
  }

  showRange() {
    const { choice: { scalar, range }, isKind, ownRange } = this.picture;
    const [unit, factor] = shownUnit(scalar.unit);
    this.range.hidden = isKind;
    const [low, high] = range ?? ownRange;
    [this.low.value, this.high.value] = [shown(low * factor), shown(high * factor)];
    this.unit.textContent = unit === "-" ? "" : unit;
    this.own.disabled = range === null;
  }

  takeRange() {
    const [, factor] = shownUnit(this.picture.choice.scalar.unit);
    const [low, high] = [this.low, this.high].map((input) => input.valueAsNumber / factor);
    if (low < high) this.picture.setRange([low, high]);
    this.high.setCustomValidity(low < high ? "" : "The range has to end above where it begins.");
    this.high.reportValidity();
  }

  showPicked(particle) {
    this.picked.hidden = !particle;
    if (!particle) return;
    this.picked.replaceChildren(h("b", {}, `particle ${particle.id}`),
      h("button", { type: "button", "aria-label": "close", onclick: () => this.leave() }, "×"),
      h("table", {}, ...particle.rows.map(([words, value]) => h("tr", {}, h("td", {}, words), h("td", {}, value)))));
  }

  leave() {
    this.picture.picked = null;
    this.picture.showPicked();
    this.picture.stage.redraw();
  }

  showAll() { this.picture.stage.fit(...this.picture.box); }

  async toggle() {
    this.plays = !this.plays;
    this.play.textContent = this.plays ? "❚❚" : "▶";
    this.play.setAttribute("aria-label", this.plays ? "stop" : "play");
    const { picture } = this;
    if (this.plays && picture.number >= picture.index.frames.length - 1) await picture.showFrame(0);
    while (this.plays && picture.number < picture.index.frames.length - 1) {
      const next = performance.now() + 1000 / this.speed;
      await picture.showFrame(picture.number + 1);
      await new Promise((resolve) => setTimeout(resolve, Math.max(next - performance.now(), 0)));
    }
    if (this.plays) this.toggle();
  }

  key(event) {
    if (["INPUT", "SELECT"].includes(event.target.tagName) && event.target.type !== "checkbox" && event.key !== "Escape") return;
    const { picture } = this;
    const { stage, index, number } = picture;
    const last = index.frames.length - 1;
    const go = (frame) => picture.showFrame(Math.min(Math.max(frame, 0), last));
    const turns = event.shiftKey && index.dimension === 3;
    const actions = {
      " ": () => this.toggle(), Home: () => go(0), End: () => go(last), f: () => this.showAll(), Escape: () => this.leave(),
      "+": () => stage.zoom(1.25), "=": () => stage.zoom(1.25), "-": () => stage.zoom(0.8),
      ArrowLeft: () => (turns ? stage.turn(-10, 0) : go(number - 1)), ArrowRight: () => (turns ? stage.turn(10, 0) : go(number + 1)),
      ...(turns ? { ArrowUp: () => stage.turn(0, 10), ArrowDown: () => stage.turn(0, -10) } : {}),
    };
    if (!(event.key in actions) || event.ctrlKey || event.altKey || event.metaKey || event.target.tagName === "BUTTON" && event.key === " ") return;
    event.preventDefault();
    actions[event.key]();
  }
}
