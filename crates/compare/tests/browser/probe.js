"use strict";
// Looks at the page when all of it is there and refusals have been told of, and writes
// what it finds into the document around the page.
const look = () => {
  const wipes = [...document.querySelectorAll(".wipe")].map((wipe) => {
    const over = wipe.querySelector(".over");
    const clip = () => getComputedStyle(over).clipPath;
    const before = clip();
    const range = wipe.querySelector("input");
    range.value = 20;
    range.dispatchEvent(new Event("input", { bubbles: true }));
    const after = clip();
    const left = wipe.querySelector("select");
    const source = over.src;
    left.selectedIndex = 2;
    left.dispatchEvent(new Event("change", { bubbles: true }));
    const visible = wipe.getBoundingClientRect().height > 100;
    return { visible, clips: [before, after], exchanged: source !== over.src };
  });
  const lines = [...document.querySelectorAll(".main-chart")].map((figure) => {
    const drawn = new Set([...figure.querySelectorAll(".chart polyline")].map((l) => getComputedStyle(l).stroke));
    const swatches = [...figure.querySelectorAll(".legend polygon")];
    return swatches.filter((swatch) => drawn.has(getComputedStyle(swatch).fill)).length;
  });
  const requests = performance.getEntriesByType("resource").map((entry) => entry.name);
  const broken = [...document.images].filter((image) => image.complete && !image.naturalWidth);
  const found = top.document.createElement("script");
  found.type = "application/json";
  found.id = "findings";
  found.textContent = JSON.stringify({
    wipes,
    lines,
    errors: window.seenErrors,
    requests: requests.filter((name) => !name.startsWith("data:")),
    window: innerWidth,
    breadth: document.documentElement.scrollWidth,
    dark: matchMedia("(prefers-color-scheme: dark)").matches,
    first_line: getComputedStyle(document.querySelector(".main-chart polyline")).stroke,
    broken_pictures: broken.length,
  });
  top.document.body.append(found);
};
addEventListener("load", () => setTimeout(look, 300));
