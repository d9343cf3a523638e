// SPDX-License-Identifier: BSD-3-Clause
// Where the index and the blocks come from: the page itself, or the server of `scarp watch`.
import { fieldFrom, positionsFrom } from "./decode.js";

class Embedded {
  constructor(root) {
    this.blocks = new Map();
    for (const script of root.querySelectorAll("script[data-block]")) this.blocks.set(script.dataset.block, script);
    this.head = JSON.parse(root.querySelector("script[data-index]").textContent);
  }
  async index() { return this.head; }
  async entry(frame) { return frame; }
  async block(frame, name) {
    const text = this.blocks.get(`${this.head.frames.indexOf(frame)}/${name}`).textContent;
    return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  }
}

class Served {
  async index() { return (await this.get("index.json")).json(); }
  async entry(frame) { return { ...(await (await this.get(`frames/${frame.key}/entry.json`)).json()), ...frame }; }
  async block(frame, name) { return new Uint8Array(await (await this.get(`frames/${frame.key}/${name}`)).arrayBuffer()); }
  async get(path) {
    const answer = await fetch(path, { cache: "no-store" });
    if (!answer.ok) throw new Error(`${path}: ${await answer.text() || answer.status}`);
    return answer;
  }
}

const MOST_KEPT = 600e6;  // bytes of decoded frames

/// Frames decoded when they are asked for, and kept as long as there is room.
export class Source {
  constructor(root) {
    this.origin = root.dataset.served === undefined ? new Embedded(root) : new Served();
    this.follows = this.origin instanceof Served;
    this.kept = new Map();
    this.bytes = 0;
  }

  index() { return this.origin.index(); }

  async entry(frame) { return (await this.remember(frame, "", async () => [await this.origin.entry(frame)]))[0]; }

  /// Positions less `centre`, as one array.
  async positions(frame, centre) {
    const { count, box } = await this.entry(frame);
    return (await this.remember(frame, "position", async () =>
      [await positionsFrom(await this.origin.block(frame, "position"), count, box, centre)]))[0];
  }

  /// An array for each component.
  async field(frame, name) {
    const { count, fields } = await this.entry(frame);
    return this.remember(frame, name, async () => fieldFrom(await this.origin.block(frame, name), count, fields[name]));
  }

  remember(frame, name, make) {
    const key = `${frame.key ?? frame.number}/${name}`;
    let wanted = this.kept.get(key);
    if (wanted) {
      this.kept.delete(key);  // and in again, as the newest
    } else {
      wanted = make();
      wanted.then((arrays) => {
        wanted.bytes = arrays.reduce((sum, array) => sum + (array.byteLength ?? 0), 0);
        this.bytes += wanted.bytes;
        this.makeRoom(key);
      }, () => this.kept.delete(key));
    }
    this.kept.set(key, wanted);
    return wanted;
  }

  makeRoom(newest) {
    for (const [key, arrays] of this.kept) {
      if (this.bytes <= MOST_KEPT) return;
      if (key === newest || !arrays.bytes) continue;
      this.bytes -= arrays.bytes;
      this.kept.delete(key);
    }
  }
}
