// Axes of the charts: where a value lies, which values have ticks, and how numbers are written.
"use strict";

const vcrit_scales = (() => {
  const almost = 1e-9;  // of a power of ten: numbers of a record have seven digits

  const raised = (integer) =>
    String(integer).replace("-", "⁻").replace(/\d/g, (digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]);

  // Between 0.001 and 1000 as it is, else with a power of ten: 1.5·10⁻⁷.
  function numberWords(value, digits) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e").map(Number);
    if (value === 0 || Math.abs(exponent) <= 3) return String(Number(value.toPrecision(digits))).replace("-", "−");
    const sign = value < 0 ? "−" : "", factor = Math.abs(mantissa) === 1 ? "" : `${Math.abs(mantissa)}·`;
    return `${sign}${factor}10${raised(exponent)}`;
  }

  // 1, 2 or 5 times a power of ten, the one nearest to `size` by ratio.
  function roundStep(size) {
    const power = 10 ** Math.floor(Math.log10(size)), rest = size / power;
    return power * (rest < Math.SQRT2 ? 1 : rest < Math.sqrt(10) ? 2 : rest < Math.sqrt(50) ? 5 : 10);
  }

  function linearTicks([low, high], count) {
    const step = roundStep((high - low) / count), decimals = Math.max(0, -Math.floor(Math.log10(step) + almost));
    const large = Math.max(Math.abs(low), Math.abs(high)) >= 1e6 || decimals > 4, ticks = [];
    for (let n = Math.ceil(low / step - almost); n <= high / step + almost; ++n) {
      const at = Number((n * step).toPrecision(12));
      ticks.push({ at, words: large ? numberWords(at, 6) : at.toFixed(decimals).replace("-", "−") });
    }
    return ticks;
  }

  // Each power of ten, or each second, third, ... of many. Up to five have ticks of their multiples between them; those
  // have words where powers alone would say too little.
  function logarithmicTicks([low, high], count) {
    const first = Math.ceil(Math.log10(low) - almost), last = Math.floor(Math.log10(high) + almost);
    const powers = last - first + 1, stride = Math.max(1, Math.ceil(powers / count)), ticks = [];
    if (powers === 0 && high / low < 2) return linearTicks([low, high], count);
    const named = [[1, 2, 3, 4, 5, 6, 7, 8, 9], [1, 2, 5], [1, 2, 5]][powers] ?? [1];
    for (let n = first - 1; n <= last; ++n)
      for (let factor = 1; factor < (powers <= 5 && stride === 1 ? 10 : 2); ++factor) {
        const at = Number(`${factor}e${n}`), words = named.includes(factor) && n % stride === 0;
        const within = at >= low * (1 - almost) && at <= high * (1 + almost);
        if (within) ticks.push({ at, words: words ? numberWords(at, 6) : "" });
      }
    return ticks;
  }

  // The least and the largest of the values that have a place; of none or one, some range around it.
  function extent(values, logarithmic) {
    let low = Infinity, high = -Infinity;
    for (const value of values) {
      if (value === null) continue;
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    if (low > high) return logarithmic ? [1, 10] : [0, 1];
    if (low < high) return [low, high];
    return logarithmic ? [low / 2, high * 2] : [low - (Math.abs(low) || 1), high + (Math.abs(high) || 1)];
  }

  // To whole powers of ten, or whole steps.
  function rounded([low, high], logarithmic, count) {
    if (logarithmic)
      return [10 ** Math.floor(Math.log10(low) + almost), 10 ** Math.ceil(Math.log10(high) - almost)];
    const step = roundStep((high - low) / count);
    return [Math.floor(low / step + almost) * step, Math.ceil(high / step - almost) * step];
  }

  // The scale of an axis that has to show `values`, with about `count` ticks. `at` says where a value lies: 0 at the
  // low end, 1 at the high end, NaN for a gap.
  function scaleOf(axis, values, count) {
    const { logarithmic } = axis, wanted = Math.max(2, Math.round(count));
    const domain = axis.range ?? rounded(extent(values, logarithmic), logarithmic, wanted);
    const measure = logarithmic ? Math.log10 : Number, [low, high] = domain.map(measure);
    const inside = ({ at }) => at >= Math.min(...domain) && at <= Math.max(...domain);
    const ticks = axis.ticks ? axis.ticks.map(([at, words]) => ({ at, words })).filter(inside)
      : (logarithmic ? logarithmicTicks : linearTicks)(domain, wanted);
    return { domain, ticks, at: (value) => (value === null ? NaN : (measure(value) - low) / (high - low)) };
  }

  return { numberWords, scaleOf };
})();
