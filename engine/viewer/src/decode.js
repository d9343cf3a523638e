// SPDX-License-Identifier: BSD-3-Clause
// Blocks of a picture back to numbers. engine/report/scarp_picture.py packs them and says how.

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Every number that 16 bits of floating point hold.
const halves = new Float32Array(65536).map((_, bits) => {
  const exponent = (bits >> 10) & 31;
  const fraction = bits & 1023;
  const size = exponent === 0 ? fraction * 2 ** -24
    : exponent < 31 ? (1 + fraction / 1024) * 2 ** (exponent - 15)
    : fraction ? NaN : Infinity;
  return bits & 32768 ? -size : size;
});

/// Whole numbers of `size` bytes; all first bytes lie together, then all second ones.
function joined(bytes, size) {
  const count = bytes.length / size;
  const out = new Uint8Array(bytes.length);
  for (let b = 0; b < size; ++b) {
    const plane = bytes.subarray(b * count, (b + 1) * count);
    for (let i = 0, at = b; i < count; ++i, at += size) out[at] = plane[i];
  }
  return out.buffer;
}

function perComponent(count, components, make) {
  return Array.from({ length: components }, (_, c) => make(c * count, c));
}

const readers = {
  half({ bytes, count, components, offset, scale }) {
    const numbers = new Uint16Array(joined(bytes, 2));
    return perComponent(count, components, (from) => {
      const out = new Float32Array(count);
      for (let i = 0; i < count; ++i) out[i] = halves[numbers[from + i]] * scale + offset;
      return out;
    });
  },
  steps32({ bytes, count, components }) {
    const steps = new Int32Array(joined(bytes, 4));
    return perComponent(count, components, (from) => {
      const out = new Int32Array(count);
      for (let i = 0, number = 0; i < count; ++i) out[i] = number = (number + steps[from + i]) | 0;
      return out;
    });
  },
  bytes({ bytes, count, components }) {
    return perComponent(count, components, (from) => bytes.subarray(from, from + count));
  },
  doubles({ bytes, count, components }) {
    const numbers = new Float64Array(joined(bytes, 8));
    return perComponent(count, components, (from) => numbers.subarray(from, from + count));
  },
};

/// One array for each component of a field. `how`: the field's entry in the frame.
export async function fieldFrom(block, count, how) {
  return readers[how.kind]({ ...how, bytes: await inflated(block), count });
}

/// Positions less `origin`, x y z of one particle after another; a plane scene has z = 0.
export async function positionsFrom(block, count, [low, high], origin) {
  const steps = new Uint16Array(joined(await inflated(block), 2));
  const out = new Float32Array(3 * count);
  low.forEach((start, axis) => {
    const unit = (high[axis] - start) / 65535;
    const shift = start - origin[axis];
    const from = axis * count;
    for (let i = 0, place = 0, at = axis; i < count; ++i, at += 3) {
      place = (place + steps[from + i]) & 65535;
      out[at] = shift + place * unit;
    }
  });
  return out;
}
