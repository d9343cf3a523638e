// SPDX-License-Identifier: BSD-3-Clause
// What particles can be coloured by: fields, lengths and components of vectors, components of tensors, coordinates.

const tensor = ["xx", "yy", "zz", "xy", "yz", "zx"];

/// `limit`: which of the field's limits in a frame's entry are its own. Component -1: the length of the vector.
export function scalarsOf(index, entry) {
  const out = [];
  for (const { name, unit, description } of index.fields) {
    const { components } = entry.fields[name] ?? {};
    const words = name.replaceAll("_", " ");
    const add = (component, suffix, limit) =>
      out.push({ key: name + suffix.replace(" ", "_"), field: name, component, limit, unit, description, words: words + suffix });
    if (components === 1) {
      add(0, "", 0);
    } else if (components <= 3) {
      add(-1, "", 0);
      for (let c = 0; c < components; ++c) add(c, ` ${"xyz"[c]}`, c + 1);
    } else if (components) {
      for (let c = 0; c < components; ++c) add(c, ` ${tensor[c]}`, c);
    }
  }
  entry.box[0].forEach((_, axis) => out.push({ key: "xyz"[axis], field: "position", component: axis, unit: "m",
    description: "coordinate", words: `coordinate ${"xyz"[axis]}` }));
  return out.sort((a, b) => place(a) - place(b));
}

const first = ["displacement", "accumulated_plastic_strain", "velocity", "mean_stress", "deviatoric_stress", "material"];
const last = ["id", "position"];
function place({ field }) {
  return first.includes(field) ? first.indexOf(field) : last.includes(field) ? 100 + last.indexOf(field) : 50;
}

export function limitsOf(scalar, entry) {
  if (scalar.field === "position") return [entry.box[0][scalar.component], entry.box[1][scalar.component]];
  return entry.fields[scalar.field].limits[scalar.limit];
}

/// The scalar of each particle of a frame. `centre`: what positions count from.
export async function valuesOf(scalar, source, frame, centre) {
  if (scalar.field === "position") {
    const positions = await source.positions(frame, centre);
    const shift = centre[scalar.component];
    return Float32Array.from({ length: positions.length / 3 }, (_, i) => positions[3 * i + scalar.component] + shift);
  }
  const components = await source.field(frame, scalar.field);
  if (scalar.component >= 0) return components[scalar.component];
  return components[0].map((_, i) => Math.hypot(...components.map((component) => component[i])));
}

/// What a unit is shown as: [words, factor].
export function shownUnit(unit) {
  return unit === "Pa" ? ["kPa", 1e-3] : [unit === "" || unit === "1" ? "-" : unit, 1];
}

/// Four significant digits.
export function shown(value) {
  if (!Number.isFinite(value)) return "none";
  const size = Math.abs(value);
  if (Number.isInteger(value) && size < 1e15) return String(value);
  return size !== 0 && (size < 1e-3 || size >= 1e6) ? value.toExponential(3) : String(Number(value.toPrecision(4)));
}

/// A coordinate to a thousandth of a length, or so.
export function shownPlace(value, length) {
  const decimals = Math.min(Math.max(2 - Math.floor(Math.log10(length || 1)), 0), 9);
  return String(Number(value.toFixed(decimals)));
}
