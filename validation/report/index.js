// Shows those scenes alone whose title or file name has what was typed.
"use strict";

const filter = document.getElementById("filter");
filter.addEventListener("input", () => {
  const wanted = filter.value.trim().toLowerCase();
  let shown = 0;
  for (const line of document.querySelectorAll(".scenes > li")) {
    const name = line.querySelector(".name").textContent, file = line.querySelector("code").textContent;
    line.hidden = !`${name} ${file}`.toLowerCase().includes(wanted);
    if (!line.hidden) ++shown;
  }
  document.getElementById("none-left").hidden = shown > 0;
});
