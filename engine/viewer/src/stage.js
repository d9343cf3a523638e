// SPDX-License-Identifier: BSD-3-Clause
// Canvas, camera and light. Parallel projection, so that a length on the screen is the same everywhere. Draws when asked to.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

THREE.ColorManagement.enabled = false;  // colours of a map are shown as they are

const slow = 50;     // ms a picture while something is turned: beyond, fewer particles are drawn
const quiet = 150;   // ms without a change after which all of them are drawn

export class Stage {
  constructor(host, dimension, drawParticles) {
    this.host = host;
    this.dimension = dimension;
    this.drawParticles = drawParticles;
    this.renderer = new THREE.WebGLRenderer({ antialias: dimension === 2 || undefined, powerPreference: "high-performance" });
    this.renderer.setClearColor(0xffffff);
    this.renderer.localClippingEnabled = true;
    this.renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    host.append(this.renderer.domElement);
    this.canvas = this.renderer.domElement;
    this.scene = new THREE.Scene();
    this.camera = new THREE.OrthographicCamera();
    this.camera.up.set(0, dimension === 2 ? 1 : 0, dimension === 2 ? 0 : 1);
    const sun = new THREE.DirectionalLight(0xffffff, 1.3);
    this.camera.add(sun, sun.target);
    sun.position.set(-0.5, 0.8, 1);
    this.scene.add(this.camera, new THREE.AmbientLight(0xffffff, 2.0));
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    if (dimension === 2) {
      this.controls.enableRotate = false;
      this.controls.mouseButtons.LEFT = THREE.MOUSE.PAN;
      this.controls.touches.ONE = THREE.TOUCH.PAN;
    }
    this.share = 1;       // of the particles, while something moves
    this.restless = 0;    // when something last moved
    this.pictures = 0;
    this.controls.addEventListener("change", () => this.stir());
    this.controls.addEventListener("start", () => { this.fitted = null; });
    new ResizeObserver(() => this.resize()).observe(host);
    this.resize();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (!width || !height) return;
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(width, height);
    const half = (this.camera.top = 1);
    this.camera.bottom = -half;
    this.camera.left = -(width / height);
    this.camera.right = width / height;
    if (this.fitted) this.look();
    this.camera.updateProjectionMatrix();
    this.redraw();
  }

  /// Looks at a box from outside, all of it in sight, also in another size of the canvas until somebody turns it.
  fit(low, high) {
    this.fitted = [low, high];
    this.resize();
  }

  look(azimuth = -58, elevation = 24) {
    const [low, high] = this.fitted;
    const box = new THREE.Box3(new THREE.Vector3(...low), new THREE.Vector3(...high));
    const middle = box.getCenter(new THREE.Vector3());
    this.radius = Math.max(box.getSize(new THREE.Vector3()).length() / 2, 1e-9);
    const [a, e] = [azimuth, elevation].map(THREE.MathUtils.degToRad);
    const direction = this.dimension === 2 ? new THREE.Vector3(0, 0, 1)
      : new THREE.Vector3(Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e));
    this.camera.position.copy(middle).addScaledVector(direction, 4 * this.radius);
    this.controls.target.copy(middle);
    this.camera.near = -40 * this.radius;
    this.camera.far = 60 * this.radius;
    this.camera.lookAt(middle);
    this.camera.updateMatrixWorld();
    let [wide, tall] = [0, 0];
    for (const x of [low[0], high[0]]) for (const y of [low[1], high[1]]) for (const z of [low[2], high[2]]) {
      const corner = new THREE.Vector3(x, y, z).applyMatrix4(this.camera.matrixWorldInverse);
      wide = Math.max(wide, Math.abs(corner.x));
      tall = Math.max(tall, Math.abs(corner.y));
    }
    this.camera.zoom = 1 / Math.max(1.12 * tall, (1.08 * wide) / this.camera.right, 1e-9);
    this.controls.update();
  }

  /// Turns by degrees: to the left, and up.
  turn(left, up) {
    this.fitted = null;
    const offset = this.camera.position.clone().sub(this.controls.target);
    const radius = offset.length();
    const azimuth = Math.atan2(offset.y, offset.x) - THREE.MathUtils.degToRad(left);
    const elevation = Math.min(Math.max(Math.asin(offset.z / radius) + THREE.MathUtils.degToRad(up), -1.55), 1.55);
    offset.set(Math.cos(elevation) * Math.cos(azimuth), Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation));
    this.camera.position.copy(this.controls.target).addScaledVector(offset, radius);
    this.controls.update();
    this.stir();
  }

  zoom(factor) {
    this.fitted = null;
    this.camera.zoom *= factor;
    this.camera.updateProjectionMatrix();
    this.stir();
  }

  /// Pixels of the page to a metre.
  get scale() { return (this.camera.zoom * this.host.clientHeight) / 2; }

  /// Towards the reader.
  get facing() { return this.camera.getWorldDirection(new THREE.Vector3()).negate(); }

  stir() {
    this.restless = performance.now();
    this.stirred = true;
    this.redraw();
  }

  /// The next picture is one at rest, of all particles.
  rest() {
    this.restless = -Infinity;
    this.stirred = false;
  }

  redraw() {
    if (this.waits) return;
    this.waits = true;
    requestAnimationFrame((now) => this.draw(now));
  }

  draw(now) {
    this.waits = false;
    const moves = this.stirred || performance.now() - this.restless < quiet;  // one picture may take longer than that
    this.stirred = false;
    if (moves && this.drawn) {
      const took = now - this.drawn;
      if (took > 1.2 * slow) this.share = Math.max(this.share * Math.max(slow / took, 0.1), 0.01);
      else if (took < 0.5 * slow) this.share = Math.min(this.share * 1.1, 1);
    }
    this.drawn = moves ? now : 0;
    this.drawParticles(moves ? this.share : 1, this.scale * this.renderer.getPixelRatio());
    this.renderer.render(this.scene, this.camera);
    ++this.pictures;
    this.afterDrawing?.();
    if (moves) this.redraw();  // without a pause, so that the time between pictures is what one takes
  }
}
