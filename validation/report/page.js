// Draws the page's charts and lets formulas be copied. Vega-Embed brings an interpreter for
// Vega's expressions (ast), so that the page's policy can forbid evaluation of text.
"use strict";

// How one chart is drawn: legends must fit its width.
function drawing(chart) {
  const narrow = chart.clientWidth < 560;
  const legend = { ...style.config.legend, columns: narrow ? 2 : 4, gradientLength: narrow ? 110 : 220 };
  return { ...style, config: { ...style.config, legend } };
}

const style = {
  mode: "vega-lite",
  renderer: "svg",
  ast: true,
  actions: { export: { svg: true, png: true }, source: false, compiled: false, editor: false },
  config: {
    font: "system-ui, sans-serif",
    axis: { labelFontSize: 12, titleFontSize: 12.5, titleFontWeight: "normal", titlePadding: 8,
            gridColor: "#e2e5ea", tickCount: 8, domainColor: "#a9afb8", tickColor: "#a9afb8" },
    axisY: { minExtent: 44, tickCount: 6 },
    legend: { labelFontSize: 12.5, symbolStrokeWidth: 2.2 },
    text: { fontSize: 12, color: "#5d6470" },
    view: { stroke: null },
  },
};

// A map comes as its edges and values; a cell without a value is left out.
function cells({ x, y, v }) {
  const columns = x.length - 1, rows = [];
  v.forEach((value, n) => {
    const i = n % columns, j = Math.floor(n / columns);
    if (value !== null) rows.push({ x: x[i], x2: x[i + 1], y: y[j], y2: y[j + 1], v: value });
  });
  return rows;
}

for (const chart of document.querySelectorAll(".chart:not(.explored-chart)")) {
  const specification = JSON.parse(chart.nextElementSibling.textContent);
  for (const layer of specification.layer)
    if (layer.data?.grid) layer.data = { values: cells(layer.data.grid) };
  const dark = matchMedia("(prefers-color-scheme: dark)").matches;
  vegaEmbed(chart, specification, { ...drawing(chart), tooltip: { theme: dark ? "dark" : "light" } })
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

// Paper has nothing to unfold; what only a screen needs stays hidden by the style.
const folded = () => document.querySelectorAll("details:not([open]):not(.latex):not(.data)");
let unfolded = [];
addEventListener("beforeprint", () => {
  unfolded = [...folded()];
  for (const part of unfolded) part.open = true;
});
addEventListener("afterprint", () => {
  for (const part of unfolded) part.open = false;
});
