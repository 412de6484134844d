// The explorer: sliders set parameters, the generated evaluator (vcrit_scene) answers; that of the normal network
// alone (vcrit_normal) says whether the contact would open.
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

  // |K_n(i omega)|, but for a factor.
  function normalStiffness(p, omega) {
    const q = { ...data.values, ...p, [data.unit]: 1, mu0: 1, du_z: 1, omega };
    return vcrit_normal.critical_velocity(q) / omega;
  }

  // The amplitude of the normal force over its mean. Far below all relaxation K_n is that at rest.
  function normalRatio(p) {
    const q = { ...data.values, ...p }, slow = 1e-60;
    return normalStiffness(p, q.omega) / normalStiffness(p, q.omega * slow) * q.du_z / q.u_z0;
  }

  // Why v* does not apply; nothing where it does.
  function outside(p) {
    if (!data.carries_load) return ["the normal network carries no load at rest."];
    if (data.may_open) return [];
    const reasons = [], q = { ...data.values, ...p }, force = normalRatio(p);
    if (!(q.du_z < q.u_z0)) reasons.push("the amplitude is not below the indentation (3).");
    if (!(force < 1)) {
      const size = force < 1e6 ? `by ${Number((100 * force).toPrecision(3))} % of` : "far beyond";
      reasons.push(`the contact would open (4): the normal force would oscillate ${size} its mean.`);
    }
    return reasons;
  }

  function frictionAt(row, column, ratio) {
    const levels = data.grid.amplitudes, at = (k) => data.grid.friction[row * levels.length + k][column];
    const above = levels.findIndex((level) => level >= ratio), k = above < 0 ? levels.length - 1 : above;
    if (at(k) === null) return null;
    if (k === 0) return 1 - (1 - at(0)) * ratio / levels[0];
    return at(k - 1) + (at(k) - at(k - 1)) * (ratio - levels[k - 1]) / (levels[k] - levels[k - 1]);
  }

  // Where v* applies.
  function response(p) {
    const values = vcrit_scene.critical_velocity_batch(p, Float64Array.from(data.omegas));
    const shown = (omega, value) => value > 0 && value < Infinity && outside({ ...p, omega }).length === 0;
    return data.omegas.map((omega, n) => [omega, shown(omega, values[n]) ? values[n] : null]);
  }

  // For the elements of the scene alone.
  const moved = () => inputs.some((input, i) => !own.includes(i) && Number(input.value) !== 0);

  function friction() {
    const ratio = data.grid.amplitude_ratios[stop()] * factor(amplitude) / factor(indentation);
    if (moved() || outside(parameters()).length > 0) return [];
    return data.grid.ratios.map((speed, n) => [speed, frictionAt(stop(), n, ratio)]);
  }

  function warnings(reasons) {
    const all = reasons.map((reason) => `Outside the model: ${reason}`);
    if (data.grid && moved()) all.push("No friction curve: it was simulated for the scene’s own elements.");
    return all;
  }

  function tell(lines) {
    const items = lines.map((line) => {
      const item = document.createElement("li");
      item.textContent = line;
      return item;
    });
    document.getElementById("explored-warnings").replaceChildren(...items);
  }

  const chart = (name) => document.getElementById(`explored-${name}`);

  function update() {
    const p = parameters();
    data.sliders.forEach((slider, i) => {
      outputs[i].textContent = slider.array ? `× ${Number(factor(i).toPrecision(4))}` : quantity(valueOf(i), slider.unit);
      outputs[i].dataset.value = String(slider.array ? factor(i) : valueOf(i));
    });
    const velocity = vcrit_scene.critical_velocity(p), reasons = outside(p);
    const shown = document.getElementById("explored-velocity");
    shown.textContent = reasons.length > 0 ? "No v*: outside the model" : quantity(velocity, "m/s");
    document.getElementById("explored-label").hidden = reasons.length > 0;
    shown.dataset.value = String(velocity);
    tell(warnings(reasons));
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
