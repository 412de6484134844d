// Draws the page's charts and lets formulas be copied. Vega-Embed brings an interpreter for
// Vega's expressions (ast), so that the page's policy can forbid evaluation of text.
"use strict";

const drawing = {
  mode: "vega-lite",
  renderer: "svg",
  ast: true,
  actions: { export: { svg: true, png: true }, source: false, compiled: false, editor: false },
  config: {
    font: "system-ui, sans-serif",
    axis: { labelFontSize: 12, titleFontSize: 12.5, titleFontWeight: "normal", titlePadding: 8,
            gridColor: "#e2e5ea", tickCount: 8, domainColor: "#a9afb8", tickColor: "#a9afb8" },
    axisY: { minExtent: 44, tickCount: 6 },
    legend: { labelFontSize: 12.5, symbolStrokeWidth: 2.2, columns: innerWidth < 600 ? 2 : 4 },
    text: { fontSize: 12, color: "#5d6470" },
    view: { stroke: null },
  },
};

for (const chart of document.querySelectorAll(".chart:not(.explored-chart)")) {
  const specification = JSON.parse(chart.nextElementSibling.textContent);
  const dark = matchMedia("(prefers-color-scheme: dark)").matches;
  vegaEmbed(chart, specification, { ...drawing, tooltip: { theme: dark ? "dark" : "light" } })
    .catch((error) => { chart.textContent = `This chart could not be drawn: ${error.message}`; });
}

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
