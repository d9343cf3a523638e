// SPDX-License-Identifier: BSD-3-Clause
// Makes the one script that a page with a picture holds: node build.mjs [where to]; with three.js, whose licence it carries.
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = fileURLToPath(new URL(".", import.meta.url));
const { version } = JSON.parse(await readFile(`${here}node_modules/three/package.json`, "utf8"));
const licence = await readFile(`${here}node_modules/three/LICENSE`, "utf8");
await build({
  absWorkingDir: here,
  entryPoints: ["src/main.js"],
  outfile: process.argv[2] ?? "scarp_viewer.js",
  bundle: true,
  minify: true,
  format: "iife",
  charset: "utf8",
  target: ["chrome90", "firefox113", "safari16.4"],
  loader: { ".css": "text" },
  legalComments: "none",
  banner: { js: `/*! scarp's picture; with three.js ${version}:\n${licence}*/` },
});
