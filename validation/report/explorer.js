// The explorer: sliders set parameters, the generated evaluator (vcrit_scene) answers.
"use strict";

const vcrit_explorer = (() => {
  const data = JSON.parse(document.getElementById("explorer-data").textContent);
  const inputs = data.sliders.map((_, i) => document.getElementById(`slider-${i}`));
  const outputs = data.sliders.map((_, i) => document.getElementById(`value-${i}`));
  const place = (role) => data.sliders.findIndex((slider) => slider.role === role);
  const own = ["angular frequency", "amplitude of the normal oscillation", "mean indentation",
    "coefficient of friction"].map(place);
  const [frequency, amplitude, indentation] = own;
  const prefixes = ["f", "p", "n", "µ", "m", "", "k", "M", "G", "T"];

  function quantity(value, unit) {
    if (!Number.isFinite(value)) return value > 0 ? "∞" : "undefined";
    if (unit === "kg") return quantity(value * 1000, "g");
    if (value === 0 || unit === "" || unit === "rad/s") return `${Number(value.toPrecision(5))} ${unit}`;
    const step = Math.max(-5, Math.min(4, Math.floor(Math.log10(Math.abs(value)) / 3)));
    return `${Number((value / 1000 ** step).toPrecision(5))} ${prefixes[step + 5]}${unit}`;
  }

  const stop = () => Math.round((Number(inputs[frequency].value) + 2) * 5);  // of the friction grid

  // At rest exactly the scene's numbers.
  const factor = (i) => (Number(inputs[i].value) === 0 ? 1 : 10 ** Number(inputs[i].value));
  const valueOf = (i) => data.sliders[i].values[0] * factor(i);

  function parameters() {
    const p = {};
    data.sliders.forEach((slider, i) => {
      p[slider.name] = slider.array ? slider.values.map((x) => x * factor(i)) : valueOf(i);
    });
    return p;
  }

  function response(p) {
    const values = vcrit_scene.critical_velocity_batch(p, Float64Array.from(data.omegas));
    return data.omegas.map((omega, n) => [omega, values[n] > 0 && values[n] < Infinity ? values[n] : null]);
  }

  // The amplitude of the normal force over its mean; it needs the elements of the scene.
  function normalRatio() {
    return data.grid.amplitude_ratios[stop()] * factor(amplitude) / factor(indentation);
  }

  function frictionAt(row, column, ratio) {
    const levels = data.grid.amplitudes, at = (k) => data.grid.friction[row * levels.length + k][column];
    const above = levels.findIndex((level) => level >= ratio), k = above < 0 ? levels.length - 1 : above;
    if (at(k) === null) return null;
    if (k === 0) return 1 - (1 - at(0)) * ratio / levels[0];
    return at(k - 1) + (at(k) - at(k - 1)) * (ratio - levels[k - 1]) / (levels[k] - levels[k - 1]);
  }

  function friction() {
    const ratio = normalRatio();
    if (!(ratio < 1)) return [];
    return data.grid.ratios.map((speed, n) => [speed, frictionAt(stop(), n, ratio)]);
  }

  function warning() {
    if (!data.grid) return "";
    const moved = inputs.some((input, i) => !own.includes(i) && Number(input.value) !== 0);
    if (moved) return "The friction curve is of the scene’s own elements.";
    const inside = normalRatio() < 1 && valueOf(amplitude) < valueOf(indentation);
    return inside ? "" : "Not admissible: the contact would open, and v* does not hold.";
  }

  const chart = (name) => document.getElementById(`explored-${name}`);

  function update() {
    const p = parameters();
    data.sliders.forEach((slider, i) => {
      outputs[i].textContent = slider.array ? `× ${Number(factor(i).toPrecision(4))}` : quantity(valueOf(i), slider.unit);
      outputs[i].dataset.value = String(slider.array ? factor(i) : valueOf(i));
    });
    const velocity = vcrit_scene.critical_velocity(p);
    const shown = document.getElementById("explored-velocity");
    shown.textContent = quantity(velocity, "m/s");
    shown.dataset.value = String(velocity);
    document.getElementById("explored-warning").textContent = warning();
    vcrit_charts.update(chart("response"), "now", response(p));
    if (data.grid) vcrit_charts.update(chart("friction"), "now", friction());
  }

  for (const input of inputs) input.addEventListener("input", update);
  document.getElementById("explorer-reset").addEventListener("click", () => {
    for (const input of inputs) input.value = "0";
    update();
  });
  for (const name of ["response", ...(data.grid ? ["friction"] : [])]) vcrit_charts.show(chart(name), data[name]);
  update();
  return { friction };
})();
