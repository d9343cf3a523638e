// SPDX-License-Identifier: BSD-3-Clause
// Colour maps that the colour-blind can read: 17 colours of each, of matplotlib (CC0), and between them straight lines.
import * as THREE from "three";

const maps = {
  viridis: `440154 48186a 472d7b 424086 3b528b 33638d 2c728e 26828e 21918c 1fa088 28ae80 3fbc73 5ec962 84d44b addc30 d8e219 fde725`,
  cividis: `00224e 002e6a 1a386f 32436d 434e6c 535a6d 61656f 6f7073 7d7c78 8c8878 9b9476 aba072 bcae6c cdbb63 dec958 f0d846 fee838`,
  magma: `000004 0a0822 1d1147 36106b 51127c 6a1c81 832681 9c2e7f b73779 d0416f e75263 f56b5c fc8961 fea772 fec488 fde2a3 fcfdbf`,
};
export const mapNames = Object.keys(maps);

/// Okabe and Ito's, told apart by the colour-blind and in grey: soil first.
export const kinds = ["#e69f00", "#0072b2", "#009e73", "#cc79a7", "#56b4e9", "#d55e00", "#f0e442", "#999999"];
export const kindColour = (number) => kinds[number % kinds.length];

const parts = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));

/// Colour at a share of the range, [r, g, b] of 255.
function colourAt(name, share) {
  const knots = maps[name].split(" ");
  const place = Math.min(Math.max(share, 0), 1) * (knots.length - 1);
  const below = Math.min(Math.floor(place), knots.length - 2);
  const [a, b] = [parts(`#${knots[below]}`), parts(`#${knots[below + 1]}`)];
  return a.map((value, c) => Math.round(value + (place - below) * (b[c] - value)));
}

/// 256 colours as a texture; of `count` kinds, a step for each.
export function texture(name, count) {
  const data = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; ++i) {
    const colour = count ? parts(kindColour(Math.min(Math.floor((i * count) / 256), count - 1))) : colourAt(name, i / 255);
    data.set([...colour, 255], 4 * i);
  }
  const made = new THREE.DataTexture(data, 256, 1);
  made.needsUpdate = true;
  return made;
}

export function gradient(name) {
  return `linear-gradient(to top, ${maps[name].split(" ").map((hex) => `#${hex}`).join(", ")})`;
}
