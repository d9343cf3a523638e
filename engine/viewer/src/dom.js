// SPDX-License-Identifier: BSD-3-Clause
/// An element with properties, handlers (on...), attributes (aria-..., data-...) and children.
export function h(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (name in element && !name.includes("-")) element[name] = value;
    else element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

/// A labelled choice; `choices`: [value, words].
export function choice(words, choices, onchange, properties = {}) {
  const select = h("select", { onchange: () => onchange(select.value), "aria-label": words, ...properties },
    ...choices.map(([value, said]) => h("option", { value }, said)));
  return { select, label: h("label", {}, h("span", {}, words), select) };
}
