// Lets formulas be copied, and unfolds the page for paper.
"use strict";

function say(button, word) {
  button.textContent = word;
  setTimeout(() => { button.textContent = "Copy"; }, 1500);
}

for (const button of document.querySelectorAll("button.copy")) {
  button.addEventListener("click", async () => {
    const source = button.parentElement.querySelector("code");
    try {
      await navigator.clipboard.writeText(source.textContent);
      say(button, "Copied");
    } catch {
      getSelection().selectAllChildren(source);
      say(button, "Selected");
    }
  });
}

// Formulas do not scroll on paper. The style makes one smaller that is wider than a sheet, down to letters of 6 points;
// what is wider still is left out, with a word on it.
const longest = 84;  // of letters of 6 points across a sheet
function fitFormulas() {
  for (const math of document.querySelectorAll(".equation > math:last-of-type")) {
    const line = math.parentElement, first = line.firstElementChild.getBoundingClientRect(), last = math.getBoundingClientRect();
    const wide = (last.right - first.left) / parseFloat(getComputedStyle(math).fontSize);
    line.style.setProperty("--wide", Math.max(1, wide).toFixed(1));
    line.classList.toggle("too-wide", wide > longest);
    if (wide <= longest || line.nextElementSibling?.matches(".only-paper")) continue;
    const words = document.createElement("span");
    words.className = "only-paper";
    words.textContent = "wider than this sheet; the page shows it";
    line.after(words);
  }
}

// Paper has nothing to unfold; what only a screen needs stays hidden by the style.
const folded = () => document.querySelectorAll("details:not([open]):not(.latex):not(.data):not(.save):not(.derivation):not(.screen)");
let unfolded = [];
addEventListener("beforeprint", () => {
  unfolded = [...folded()];
  for (const part of unfolded) part.open = true;
  fitFormulas();
});
addEventListener("afterprint", () => {
  for (const part of unfolded) part.open = false;
});
