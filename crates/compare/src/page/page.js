"use strict";
// The wipe: two pictures of the page on top of each other, and how much is seen of
// the upper one. Without this nothing on the page is missing but the wipe.
for (const wipe of document.querySelectorAll(".wipe")) {
  const [left, right] = wipe.querySelectorAll("select");
  const range = wipe.querySelector("input");
  const stage = wipe.querySelector(".stage");
  const layer = (kind, name) => {
    const made = document.createElement(kind);
    made.className = name;
    stage.append(made);
    return made;
  };
  const under = layer("img", "under");
  const over = layer("img", "over");
  const seam = layer("div", "seam");

  const show = (image, choice) => {
    const shown = document.getElementById(choice.value);
    if (!shown) return;
    image.src = shown.src;
    image.alt = shown.alt;
  };
  const move = () => {
    over.style.clipPath = `inset(0 ${100 - range.value}% 0 0)`;
    seam.style.left = `${range.value}%`;
  };
  const follow = (event) => {
    const box = stage.getBoundingClientRect();
    const share = (event.clientX - box.left) / box.width;
    range.value = Math.round(100 * Math.min(1, Math.max(0, share)));
    move();
  };
  left.addEventListener("change", () => show(over, left));
  right.addEventListener("change", () => show(under, right));
  range.addEventListener("input", move);
  under.draggable = over.draggable = false;
  stage.addEventListener("pointerdown", (event) => {
    stage.setPointerCapture(event.pointerId);
    follow(event);
  });
  stage.addEventListener("pointermove", (event) => event.buttons & 1 && follow(event));

  show(over, left);
  show(under, right);
  move();
  wipe.hidden = false;
}
