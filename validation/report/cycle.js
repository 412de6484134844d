// One cycle of the scene: a line across its charts, moved by a slider or by time, and what holds at that moment.
"use strict";

(() => {
  const at = (id) => document.getElementById(id);
  const { numberWords } = vcrit_scales;
  const charts = [...document.querySelectorAll("#cycle .chart")];
  const figures = charts.map((chart) => JSON.parse(chart.nextElementSibling.textContent));
  const [{ x: { title, range: [, period] }, bands }] = figures;

  // Titles are "what, unit". The curve is the last of a figure's series, behind its bounds.
  function told({ y, series }, time) {
    const [what, unit] = y.title.split(", "), { points } = series[series.length - 1];
    const gap = (point) => Math.abs(point[0] - time);
    const nearest = points.reduce((best, point) => (gap(point) < gap(best) ? point : best));
    return `${what} ${numberWords(nearest[1], 3)} ${unit}`;
  }

  function show(part) {
    const time = part * period, band = bands.find(({ from, to }) => time >= from && time <= to);
    for (const chart of charts) vcrit_charts.mark(chart, time);
    const motion = band && (band.words === "reverse slip" ? band.words : "sticks");
    const words = [...figures.map((figure) => told(figure, time)), motion].filter(Boolean).join(", ");
    const instant = `${numberWords(time, 3)} ${title.split(", ")[1]}: ${words}`;
    at("cycle-instant").textContent = instant;
    at("cycle-time").setAttribute("aria-valuetext", instant);
  }

  vcrit_scrubber({ button: at("cycle-play"), slider: at("cycle-time"), show });
  at("cycle-scrubber").hidden = false;
  show(0);
})();
