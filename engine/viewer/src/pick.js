// SPDX-License-Identifier: BSD-3-Clause
import * as THREE from "three";

/// Number in the frame of the particle under a point of the canvas, of several the one in front; -1: there is none.
/// `isCut(x, y, z)`: what the cuts take away.
export function particleAt(x, y, stage, particles, radius, isCut) {
  const { clientWidth: width, clientHeight: height } = stage.host;
  const { elements: m } = new THREE.Matrix4().multiplyMatrices(stage.camera.projectionMatrix, stage.camera.matrixWorldInverse);
  const { points, order } = particles;
  const reach = Math.max(radius, 5) ** 2;
  let found = -1;
  let nearest = Infinity;
  for (let k = 0; k < order.length; ++k) {
    const [px, py, pz] = [points[3 * k], points[3 * k + 1], points[3 * k + 2]];
    const dx = ((m[0] * px + m[4] * py + m[8] * pz + m[12] + 1) / 2) * width - x;
    const dy = ((1 - (m[1] * px + m[5] * py + m[9] * pz + m[13])) / 2) * height - y;
    const away = dx * dx + dy * dy;
    if (away > reach || isCut(px, py, pz)) continue;
    // In a plane scene the nearest one, in space the one in front.
    const depth = stage.dimension === 2 ? away : m[2] * px + m[6] * py + m[10] * pz + m[14];
    if (depth < nearest) [nearest, found] = [depth, order[k]];
  }
  return found;
}
