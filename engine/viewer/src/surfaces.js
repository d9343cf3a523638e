// SPDX-License-Identifier: BSD-3-Clause
// Walls, and ground as a surface over the plan.
import * as THREE from "three";

/// Faces of walls, seen from the side of the soil alone, so that one looks into a box from anywhere; in a plane scene lines.
export function wallObject({ corners }, centre, clippingPlanes) {
  const group = new THREE.Group();
  const points = corners.map((face) => face.map((x, at) => x - centre[at % 3]));
  const edges = new THREE.BufferGeometry();
  const ends = points.flatMap((face) => (face.length === 6 ? face : [0, 1, 2, 3].flatMap((corner) =>
    [corner, (corner + 1) % 4].flatMap((at) => face.slice(3 * at, 3 * at + 3)))));
  edges.setAttribute("position", new THREE.Float32BufferAttribute(ends, 3));
  group.add(new THREE.LineSegments(edges, new THREE.LineBasicMaterial({ color: 0x555555, clippingPlanes })));
  if (points.length && points[0].length === 12) {
    const faces = new THREE.BufferGeometry();
    const halves = points.flatMap((face) => [0, 1, 2, 0, 2, 3].flatMap((at) => face.slice(3 * at, 3 * at + 3)));
    faces.setAttribute("position", new THREE.Float32BufferAttribute(halves, 3));
    faces.computeVertexNormals();
    group.add(new THREE.Mesh(faces, new THREE.MeshLambertMaterial({ color: 0xd6dade, clippingPlanes, polygonOffset: true,
      polygonOffsetFactor: 2, polygonOffsetUnits: 2 })));
  }
  return group;
}

/// The highest particle of each square of the plan, as a surface; null where there is none.
export function groundObject(positions, isPart, width, { colour, opacity = 1, clippingPlanes }) {
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  const count = positions.length / 3;
  for (let i = 0; i < count; ++i) {
    if (!isPart(i)) continue;
    for (const axis of [0, 1]) {
      low[axis] = Math.min(low[axis], positions[3 * i + axis]);
      high[axis] = Math.max(high[axis], positions[3 * i + axis]);
    }
  }
  if (!(high[0] >= low[0])) return null;
  const cells = [0, 1].map((axis) => Math.round((high[axis] - low[axis]) / width) + 1);
  if (cells[0] * cells[1] > 4e6) return null;
  const top = new Float32Array(cells[0] * cells[1]).fill(-Infinity);
  for (let i = 0; i < count; ++i) {
    if (!isPart(i)) continue;
    const [a, b] = [0, 1].map((axis) => Math.round((positions[3 * i + axis] - low[axis]) / width));
    const at = a + cells[0] * b;
    top[at] = Math.max(top[at], positions[3 * i + 2]);
  }
  const points = new Float32Array(3 * top.length);
  top.forEach((height, at) => points.set([low[0] + (at % cells[0]) * width, low[1] + Math.floor(at / cells[0]) * width,
    Number.isFinite(height) ? height + width / 2 : 0], 3 * at));  // particles end half a spacing above their middle
  const triangles = [];
  for (let b = 0; b + 1 < cells[1]; ++b) {
    for (let a = 0; a + 1 < cells[0]; ++a) {
      const at = a + cells[0] * b;
      const corners = [at, at + 1, at + 1 + cells[0], at + cells[0]];
      if (corners.every((corner) => Number.isFinite(top[corner])))
        triangles.push(corners[0], corners[1], corners[2], corners[0], corners[2], corners[3]);
    }
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(points, 3));
  geometry.setIndex(triangles);
  geometry.computeVertexNormals();
  return new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color: colour, side: THREE.DoubleSide, clippingPlanes,
    transparent: opacity < 1, opacity, depthWrite: opacity === 1 }));
}

export function discard(object) {
  object?.traverse((part) => {
    part.geometry?.dispose();
    part.material?.dispose();
  });
}
