// SPDX-License-Identifier: BSD-3-Clause
// Makes a picture of every element of the class "scarp-picture" in the page.
import { Picture } from "./picture.js";
import { h } from "./dom.js";
import style from "./style.css";

document.head.append(h("style", {}, style));
for (const root of document.querySelectorAll(".scarp-picture")) {
  root.picture = new Picture(root);
  root.picture.begin().catch((error) => {
    console.error(error);
    root.append(h("p", { className: "problem" }, `The picture cannot be shown: ${error.message}. It needs a browser of 2023 or `
      + "later with WebGL."));
  });
}
