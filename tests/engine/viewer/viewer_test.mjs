// SPDX-License-Identifier: BSD-3-Clause
// The pictures of pages in a browser, by their pixels: they change as they must when turned, coloured, played, cut and picked.
// usage: viewer_test.mjs REPORT_SCRIPTS BUILD_OF_THE_VIEWER CHROMIUM
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { copyFileSync, existsSync, mkdtempSync, renameSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";

const [scripts, build, executablePath] = process.argv.slice(2);
if (!existsSync(join(build, "node_modules"))) {
  console.log("skipped: npm could not fetch what the moving picture and its test need");
  process.exit(77);
}
const { chromium } = createRequire(`${build}/`)("playwright-core");
const environment = { ...process.env, SCARP_VIEWER: join(build, "scarp_viewer.js") };
const folder = mkdtempSync(join(tmpdir(), "scarp_viewer_"));
const patience = { timeout: 60_000 };
let browser;

before(async () => {
  execFileSync("/usr/bin/python3", [fileURLToPath(new URL("make_pages.py", import.meta.url)), scripts, folder], { env: environment });
  // Pictures are drawn by the processor, so that they are the same on every machine.
  browser = await chromium.launch({ executablePath,
    args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"] });
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

/// A page that has drawn its picture. Whatever it asks of a network, and whatever it complains of, fails the test.
async function opened(t, address, viewport = { width: 900, height: 900 }) {
  const context = await browser.newContext({ viewport });
  t.after(() => context.close());
  const page = await context.newPage();
  const here = address.includes("://") ? new URL(address).origin : "file://";
  const complaints = [];
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("console", (message) => { if (["error", "warning"].includes(message.type())) complaints.push(message.text()); });
  page.on("request", (request) => { if (!request.url().startsWith(here)) complaints.push(`asked for ${request.url().slice(0, 80)}`); });
  t.after(() => assert.deepEqual(complaints.filter((words) => !/GPU stall|ReadPixels|favicon/.test(words)), []));
  await page.goto(address.includes("://") ? address : `file://${join(folder, address)}`);
  await page.waitForFunction(() => document.querySelector(".scarp-picture").dataset.ready, null, patience);
  await page.evaluate(() => {
    const root = document.querySelector(".scarp-picture");
    /// The canvas as it is at rest: [r, g, b, a, ...].
    window.pixels = () => {
      const { stage } = root.picture;
      stage.rest();
      stage.draw(performance.now());
      const { width, height } = stage.canvas;
      const copy = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d");
      copy.drawImage(stage.canvas, 0, 0);
      return copy.getImageData(0, 0, width, height);
    };
    window.covered = () => {  // share of the canvas that is not white
      const { data } = window.pixels();
      let count = 0;
      for (let at = 0; at < data.length; at += 4) if (data[at] + data[at + 1] + data[at + 2] < 760) ++count;
      return (4 * count) / data.length;
    };
    window.keep = () => { window.kept = window.pixels().data; };
    window.changed = () => {  // share of the canvas that is not what was kept
      const { data } = window.pixels();
      let count = 0;
      for (let at = 0; at < data.length; at += 4)
        if ([0, 1, 2].some((c) => Math.abs(data[at + c] - window.kept[at + c]) > 8)) ++count;
      return (4 * count) / data.length;
    };
    /// Where a place of the scene [m] is on the canvas, in pixels.
    window.onCanvas = (place) => {
      const { stage, centre } = root.picture;
      const { x, y } = stage.camera.position.clone().set(...place.map((value, axis) => value - centre[axis])).project(stage.camera);
      return [((x + 1) / 2) * stage.canvas.width, ((1 - y) / 2) * stage.canvas.height];
    };
    window.colourAt = (place) => {
      const { data, width } = window.pixels();
      const [x, y] = window.onCanvas(place).map(Math.floor);
      return Array.from(data.slice(4 * (x + width * y), 4 * (x + width * y) + 3));
    };
  });
  return page;
}

const ready = (page) => page.evaluate(() => Number(document.querySelector(".scarp-picture").dataset.ready));

/// Does something after which the picture is made anew, and waits until it is drawn.
async function redrawn(page, action) {
  const was = await ready(page);
  await action();
  await page.waitForFunction((before) => Number(document.querySelector(".scarp-picture").dataset.ready) > before, was, patience);
}

/// The canvas takes its new size in the frame after the panel beside it has opened.
async function laidOut(page) {
  await page.evaluate(() => new Promise((done) => {
    let frames = 4;
    const wait = () => (--frames > 0 ? requestAnimationFrame(wait) : done());
    requestAnimationFrame(wait);
  }));
}

const near = (found, wanted, words) =>
  assert.ok(found.every((value, c) => Math.abs(value - wanted[c]) <= 6), `${words}: ${found} is not near ${wanted}`);
const viridis = { low: [0x44, 0x01, 0x54], middle: [0x21, 0x91, 0x8c], high: [0xfd, 0xe7, 0x25] };
const cividis = { low: [0x00, 0x22, 0x4e], high: [0xfe, 0xe8, 0x38] };

// The last frame of "plane" is sheared: x has moved by 0.2 y.
const sheared = (x, y) => [x + 0.2 * y, y, 0];
const [left, middle, right] = [sheared(0.125, 2.625), sheared(5.0, 2.625), sheared(9.875, 2.625)];

test("a plane scene is coloured by its field, from the low end of the map to the high one", async (t) => {
  const page = await opened(t, "plane.html");
  near(await page.evaluate((at) => window.colourAt(at), left), viridis.low, "left");
  near(await page.evaluate((at) => window.colourAt(at), middle), viridis.middle, "middle");
  near(await page.evaluate((at) => window.colourAt(at), right), viridis.high, "right");
  near(await page.evaluate((at) => window.colourAt(at), [0.5, 4.9, 0]), [255, 255, 255], "beside the soil");
});

test("another map, another range and another field change the colours", async (t) => {
  const page = await opened(t, "plane.html");
  await page.getByLabel("colours", { exact: true }).selectOption("cividis");
  near(await page.evaluate((at) => window.colourAt(at), left), cividis.low, "cividis");
  await page.getByLabel("highest value of the colours").fill("0.4");
  await page.getByLabel("highest value of the colours").press("Enter");
  near(await page.evaluate((at) => window.colourAt(at), middle), cividis.high, "beyond the range");
  assert.match(await page.locator(".legend").innerText(), /displacement \[m\][\s\S]*0\.4[\s\S]*0\.2[\s\S]*0/);
  await redrawn(page, () => page.getByLabel("colour by").selectOption("material"));
  near(await page.evaluate((at) => window.colourAt(at), sheared(5, 0.625)), [0xe6, 0x9f, 0x00], "rock");
  near(await page.evaluate((at) => window.colourAt(at), sheared(5, 4.625)), [0x00, 0x72, 0xb2], "clay");
  assert.match(await page.locator(".legend").innerText(), /material\s+rock\s+clay/);
});

test("playing goes through the moments to the last one, and the picture follows", async (t) => {
  const page = await opened(t, "plane.html");
  assert.match(await page.locator(".moment").innerText(), /t = 2 s, stage “fail” \(2 of 2\)/);
  await page.evaluate(() => window.keep());
  await redrawn(page, () => page.locator(".scarp-picture").press("Home"));
  assert.match(await page.locator(".moment").innerText(), /t = 0 s.*\(1 of 2\)/);
  assert.ok(await page.evaluate(() => window.changed()) > 0.02, "the shear is seen");
  await redrawn(page, () => page.locator(".scarp-picture").press(" "));
  await page.waitForFunction(() => document.querySelector(".play").textContent === "▶", null, patience);
  assert.ok(await page.evaluate(() => window.changed()) < 0.002, "the last moment is as it was");
});

test("where the soil was at the start is shown in grey", async (t) => {
  const page = await opened(t, "plane.html");
  near(await page.evaluate((at) => window.colourAt(at), [0.4, 4.8, 0]), [255, 255, 255], "before");
  await redrawn(page, () => page.getByLabel("where the soil was at the start").check());
  near(await page.evaluate((at) => window.colourAt(at), [0.4, 4.8, 0]), [184, 184, 184], "after");
});

test("a wall is a line, and goes when it is not wanted", async (t) => {
  const page = await opened(t, "plane.html");
  await page.evaluate(() => window.keep());
  await redrawn(page, () => page.getByLabel("walls").uncheck());
  const gone = await page.evaluate(() => window.changed());
  assert.ok(gone > 0.0001 && gone < 0.01, `share of the line: ${gone}`);
});

test("a click reads a particle, and its mark follows it", async (t) => {
  const page = await opened(t, "plane.html");
  const [x, y] = await page.evaluate((at) => window.onCanvas(at), sheared(0.125 + 7 * 0.25, 0.125 + 3 * 0.25));
  await page.locator("canvas").click({ position: { x, y } });
  const said = page.locator(".picked");
  await said.waitFor(patience);
  const text = (await said.innerText()).replaceAll(/\s+/g, " ");
  assert.match(text, new RegExp(`particle ${7 * 20 + 3} `));
  assert.match(text, /displacement 0\.17\d+ m/);  // 7 of 39
  assert.match(text, /material rock/);
  assert.match(text, /stress xy 0\.004 kPa/);
  assert.match(text, /coordinate y 0\.87\d* m/);
  const place = () => page.locator(".mark").evaluate((mark) => mark.style.transform);
  const was = await place();
  await redrawn(page, () => page.locator(".scarp-picture").press("Home"));
  assert.notEqual(await place(), was);
  await page.locator(".scarp-picture").press("Escape");
  await said.waitFor({ state: "hidden", ...patience });
});

test("a scene in space turns with the mouse and with the keyboard, and comes closer", async (t) => {
  const page = await opened(t, "space.html");
  await page.evaluate(() => window.keep());
  await page.mouse.move(450, 300);
  await page.mouse.down();
  await page.mouse.move(600, 340, { steps: 5 });
  await page.mouse.up();
  const turned = await page.evaluate(() => window.changed());
  assert.ok(turned > 0.1, `turned by the mouse: ${turned}`);
  await page.evaluate(() => window.keep());
  await page.locator(".scarp-picture").press("Shift+ArrowLeft");
  assert.ok(await page.evaluate(() => window.changed()) > 0.05, "turned by keys");
  await page.locator(".scarp-picture").press("f");
  const was = await page.evaluate(() => window.covered());
  await page.locator(".scarp-picture").press("-");
  const farther = await page.evaluate(() => window.covered());
  assert.ok(Math.abs(farther / was - 0.64) < 0.03, `0.8 of the size covers 0.64 of the area: ${farther / was}`);
});

test("while it is turned, a slow machine draws a part of the particles, and all of them at rest", async (t) => {
  const page = await opened(t, "space.html");
  const counts = await page.evaluate(async () => {
    const { stage, particles } = document.querySelector(".scarp-picture").picture;
    const drawn = () => particles.geometry.drawRange.count;
    const all = particles.order.length;
    stage.stir();
    stage.draw(1000);
    stage.stir();
    stage.draw(1500);  // half a second later, ten times what it may take
    const turned = drawn();
    stage.rest();
    stage.draw(1600);
    return { all, turned, rested: drawn() };
  });
  assert.ok(counts.turned > 0 && counts.turned <= 0.11 * counts.all, `${counts.turned} of ${counts.all}`);
  assert.equal(counts.rested, counts.all);
});

test("a cut takes away what is beyond it", async (t) => {
  const page = await opened(t, "space.html");
  await redrawn(page, () => page.getByLabel("walls").uncheck());
  await redrawn(page, () => page.getByLabel("rock:").selectOption("particles"));
  const seen = (x) => page.evaluate((at) => window.colourAt(at), [x, 0.05, 1.9]);  // the front face
  const isSoil = ([r, g, b]) => Math.max(r, g, b) - Math.min(r, g, b) > 40;  // white and walls are not coloured
  assert.ok(isSoil(await seen(7.5)));
  await page.getByText("cut", { exact: true }).click();
  await laidOut(page);
  await page.evaluate(() => window.keep());
  await page.getByLabel("x, to").fill("500");
  assert.ok(!isSoil(await seen(7.5)), "cut away");
  assert.ok(isSoil(await seen(1.5)), "left");
  await page.getByRole("button", { name: "no cut" }).click();
  assert.ok(await page.evaluate(() => window.changed()) < 0.001, "all is there again");
  await page.getByLabel("depth of the cut that faces you").fill("500");
  assert.ok(await page.evaluate(() => window.changed()) > 0.1, "the oblique cut is seen");
});

test("terrain is a surface, particles or hidden", async (t) => {
  const page = await opened(t, "space.html");
  await redrawn(page, () => page.getByLabel("clay:").selectOption("hidden"));
  near(await page.evaluate((at) => window.colourAt(at), [4.2, 2.5, 2.0]).then(([r, g, b]) => [r > b, g > b, r >= g]), [true, true, true], "rock's colour");
  const surface = await page.evaluate(() => window.covered());
  await redrawn(page, () => page.getByLabel("rock:").selectOption("particles"));
  const particles = await page.evaluate(() => window.covered());
  assert.ok(particles > 1.02 * surface, `a surface has no sides: ${surface}, ${particles}`);
  await redrawn(page, () => page.getByLabel("rock:").selectOption("hidden"));
  const walls = await page.evaluate(() => window.covered());
  await redrawn(page, () => page.getByLabel("walls").uncheck());
  assert.ok(walls > 0.1 && (await page.evaluate(() => window.covered())) === 0, "nothing is left");
});

test("a page that leaves particles out says how many", async (t) => {
  const page = await opened(t, "thinned.html");
  const words = await page.locator(".notes").first().innerText();
  const shown = Number(words.match(/([\d\u202f]+) of 57\u202f600 particles/)[1].replaceAll("\u202f", ""));
  const drawn = await page.evaluate(() => document.querySelector(".scarp-picture").picture.index.frames[0].count);
  assert.ok(shown < 57_600 / 2 && Math.abs(shown - drawn) < 0.05 * drawn, `${shown}, ${drawn}`);
});

test("a narrow page shows all controls without scrolling sideways", async (t) => {
  for (const name of ["plane.html", "space.html"]) {
    const page = await opened(t, name, { width: 340, height: 700 });
    await page.getByText("cut", { exact: true }).click();
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 340);
    const [wide, high] = await page.locator("canvas").evaluate((canvas) => [canvas.clientWidth, canvas.clientHeight]);
    assert.ok(wide > 280 && high > 200, `${wide} x ${high}`);
  }
});

test("scarp watch shows a moment as soon as it is there, and ends on Ctrl-C", async (t) => {
  const last = join(folder, "plane", "frames", "soil_00001.hdf");
  const kept = join(folder, "kept.hdf");
  renameSync(last, kept);
  const server = spawn("/usr/bin/python3", [join(scripts, "scarp_watch.py"), join(folder, "plane")], { env: environment });
  t.after(() => server.kill("SIGKILL"));
  const ended = new Promise((resolve) => server.on("exit", resolve));
  const said = await new Promise((resolve) => server.stdout.once("data", (text) => resolve(String(text))));
  const page = await opened(t, said.match(/http:\S+/)[0]);
  assert.match(await page.locator(".moment").innerText(), /\(1 of 1\)/);
  await page.evaluate(() => window.keep());
  copyFileSync(kept, `${last}.part`);
  await redrawn(page, () => renameSync(`${last}.part`, last));
  assert.match(await page.locator(".moment").innerText(), /t = 2 s.*\(2 of 2\)/);
  assert.ok(await page.evaluate(() => window.changed()) > 0.02, "the shear is seen");
  await page.close();
  server.kill("SIGINT");
  assert.equal(await ended, 0);
});
