// Numbers of the explorer as people read and say them.
"use strict";

const vcrit_words = (() => {
  const prefixes = ["p", "n", "µ", "m", "", "k", "M", "G"];
  const prefix_words = { p: "pico", n: "nano", "µ": "micro", m: "milli", k: "kilo", M: "mega", G: "giga" };
  const unit_words = { Hz: "hertz", m: "metres", g: "grams", s: "seconds", N: "newtons", Pa: "pascals", "m/s": "metres per second",
    "N/m": "newtons per metre", "N.s/m": "newton seconds per metre", "N/µm": "newtons per micrometre" };

  /// So many significant digits, no zeros behind them.
  function number(value, digits) {
    if (!Number.isFinite(value)) return value > 0 ? "∞" : "−";
    return String(Number(value.toPrecision(digits)));
  }

  /// What to multiply numbers of this size with, and the unit that they then have.
  function scale(size, unit) {
    if (size === 0 || !Number.isFinite(size) || unit === "") return { factor: 1, unit };
    const step = Math.max(-4, Math.min(3, Math.floor(Math.log10(Math.abs(size)) / 3 + 1e-9)));
    return { factor: 1000 ** -step, unit: prefixes[step + 4] + unit };
  }

  function quantity(value, unit, digits = 4) {
    if (!Number.isFinite(value)) return value > 0 ? "∞" : "unknown";
    const { factor, unit: shown } = scale(value, unit);
    return `${number(value * factor, digits)} ${shown}`.trim();
  }

  /// "kilohertz" of "kHz".
  function spoken(unit) {
    if (unit in unit_words) return unit_words[unit];
    const word = prefix_words[unit[0]], base = unit_words[unit.slice(1)];
    return word && base ? word + base : unit;
  }

  return { number, scale, quantity, spoken };
})();
