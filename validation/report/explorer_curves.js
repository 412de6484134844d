// The explorer's pictures: friction over speed, and one period with a scrubber. Plain SVG, drawn anew each time.
"use strict";

const vcrit_curves = (() => {
  const at = (id) => document.getElementById(id);
  const { scale, number } = vcrit_words;
  const left = 52, right = 14;

  function node(name, attributes, words) {
    const made = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    if (words !== undefined) made.textContent = words;
    return made;
  }

  /// Round numbers from low to high, about so many.
  function ticks(low, high, count) {
    const rough = (high - low) / count, power = 10 ** Math.floor(Math.log10(rough));
    const step = power * [1, 2, 5, 10].find((each) => each * power >= rough * 0.999);
    const all = [];
    for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) all.push(Number((i * step).toPrecision(6)));
    return all;
  }

  // A plane with its axes; x and y say where numbers lie.
  function plane(svg, { width, top, bottom, x, y, counts = [5, 4], words = true }) {
    const to_x = (value) => left + (value - x.from) / (x.to - x.from) * (width - left - right);
    const to_y = (value) => bottom - (value - y.from) / (y.to - y.from) * (bottom - top);
    for (const value of ticks(y.from, y.to, counts[1])) {
      svg.append(node("line", { class: "grid", x1: left, x2: width - right, y1: to_y(value), y2: to_y(value) }));
      svg.append(node("text", { class: "words", x: left - 6, y: to_y(value) + 4, "text-anchor": "end" }, String(value).replace("-", "−")));
    }
    if (words)
      for (const value of ticks(x.from, x.to, counts[0]))
        svg.append(node("text", { class: "words", x: to_x(value), y: bottom + 17, "text-anchor": "middle" }, value));
    svg.append(node("line", { class: "axis", x1: left, x2: width - right, y1: bottom, y2: bottom }));
    svg.append(node("text", { class: "words", x: left, y: top - 8 }, y.title));
    if (words) svg.append(node("text", { class: "words", x: width - right, y: bottom + 34, "text-anchor": "end" }, x.title));
    return { x: to_x, y: to_y };
  }

  // Of lines that leave the picture by far browsers do not read the numbers.
  const FAR = 1e5, length = (pixels) => Math.min(FAR, Math.max(-FAR, pixels)).toFixed(2);
  const path = (points, to) => points.map(([x, y], i) => `${i ? "L" : "M"}${length(to.x(x))} ${length(to.y(y))}`).join("");

  function blank(place, height, label) {
    const width = Math.max(260, place.clientWidth), svg = node("svg", { viewBox: `0 0 ${width} ${height}`, width, height, role: "img", "aria-label": label });
    place.replaceChildren(svg);
    return { svg, width };
  }

  const value_at = (points, x) => {
    const above = points.findIndex(([each]) => each >= x);
    if (above <= 0) return above === 0 ? points[0][1] : null;
    const [x0, y0] = points[above - 1], [x1, y1] = points[above];
    return y0 + (y1 - y0) * (x - x0) / (x1 - x0);
  };

  /// Points (speed, ratio) of now and of the scene; `rule`: v*, of the drive; `at`: the speed of the field.
  function friction(place, { x, rule, creeps, now, own, at: here }) {
    const height = innerWidth < 640 ? 210 : 280, { svg, width } = blank(place, height, "Friction over sliding speed");
    const high = Math.max(1.15, ...now.map(([, y]) => 1.1 * y));
    const to = plane(svg, { width, top: 30, bottom: height - 42, x: { from: 0, ...x }, y: { from: 0, to: high, title: "friction / friction without vibration" } });
    const clip = node("clipPath", { id: "explored-clip" });
    clip.append(node("rect", { x: left, y: 20, width: width - left - right, height: height - 62 }));
    svg.append(clip);
    if (Number.isFinite(rule)) {
      svg.append(node("line", { class: "rule", x1: to.x(rule), x2: to.x(rule), y1: 30, y2: height - 42 }));
      svg.append(node("text", { class: "words", x: to.x(rule) + 5, y: height - 50 }, creeps ? "v* + creep" : "v*"));
    }
    if (own.length > 0) {
      svg.append(node("path", { class: "own", d: path(own, to), "clip-path": "url(#explored-clip)" }));
      label(svg, to, own, x.to, "this scene", 0.3, 14);
    }
    svg.append(node("path", { class: "now", d: path(now, to), "clip-path": "url(#explored-clip)" }));
    if (own.length > 0) label(svg, to, now, x.to, "now", 0.62, -8);
    const ratio = value_at(now, here);
    if (ratio !== null) svg.append(node("circle", { class: "point", cx: to.x(here), cy: to.y(ratio), r: 4.5 }));
  }

  // At a share of the width, above its line or below it.
  function label(svg, to, points, end, words, share, aside) {
    const ratio = value_at(points, share * end);
    if (ratio !== null) svg.append(node("text", { class: words === "now" ? "words now-words" : "words", x: to.x(share * end), y: to.y(ratio) + aside }, words));
  }

  let period_shown = null;

  /// Points (phase, contact speed, force, bound) and events (phase, motion) of one period in s.
  function cycle(points, events, period, velocity) {
    const height = 380, place = at("explored-period"), { svg, width } = blank(place, height, "Force and contact speed over one period");
    const time = scale(period, "s"), speeds = scale(Math.max(...points.map((p) => Math.abs(p[1])), velocity), "m/s");
    const forces = scale(Math.max(...points.map((p) => p[3])), "N"), turn = 2 * Math.PI;
    const xs = points.map((p) => p[0] / turn * period * time.factor), end = period * time.factor;
    const across = { from: 0, to: end, title: `time, ${time.unit}` };
    const most = 1.1 * Math.max(...points.map((p) => p[3])) * forces.factor;
    const least = Math.min(0, ...points.map((p) => 1.1 * p[2] * forces.factor));
    // A narrow line has no room for all words beside those of sticking.
    const what = width < 420 ? "force and its bound" : "friction force and its bound";
    const upper = plane(svg, { width, top: 28, bottom: 190, x: across, y: { from: least, to: most, title: `${what}, ${forces.unit}` }, words: false });
    const values = points.map((p) => p[1] * speeds.factor), low = Math.min(0, ...values);
    const high = Math.max(...values) || velocity * speeds.factor;  // it may stick all the time
    const lower = plane(svg, { width, top: 232, bottom: height - 42, x: across, y: { from: low - 0.05 * (high - low), to: high + 0.1 * (high - low), title: `contact speed, ${speeds.unit}` }, counts: [5, 3] });
    for (const [from, until] of sticking(events, points)) {
      for (const [top, bottom] of [[28, 190], [232, height - 42]])
        svg.prepend(node("rect", { class: "sticks", x: lower.x(from * end), y: top, width: lower.x(until * end) - lower.x(from * end), height: bottom - top }));
    }
    const share = sticking(events, points).reduce((sum, [from, until]) => sum + until - from, 0);
    if (share > 0) svg.append(node("text", { class: "words", x: width - right, y: 20, "text-anchor": "end" }, `sticks ${Math.round(100 * share)} %`));
    const bounds = points.map((p, i) => [xs[i], p[3] * forces.factor]);
    svg.append(node("path", { class: "bound", d: path(bounds, upper) + (least < 0 ? path(bounds.map(([x, y]) => [x, Math.max(-y, least)]), upper) : "") }));
    svg.append(node("path", { class: "now", d: path(points.map((p, i) => [xs[i], p[2] * forces.factor]), upper) }));
    svg.append(node("path", { class: "now", d: path(points.map((p, i) => [xs[i], p[1] * speeds.factor]), lower) }));
    const cursor = node("line", { class: "cursor", y1: 28, y2: height - 42 });
    svg.append(cursor);
    period_shown = { points, period, time, forces, speeds, cursor, to: (part) => lower.x(part * end) };
    move_to(scrubber.part());
  }

  // Parts of the period, 0 to 1, in which it sticks.
  function sticking(events, points) {
    const STICK = 1, parts = [];
    if (events.length === 0) return points.every((p) => p[1] === 0) ? [[0, 1]] : [];
    for (let i = 0; i < events.length; i += 2) {
      if (events[i + 1] !== STICK) continue;
      const from = events[i] / (2 * Math.PI), until = (events[i + 2] ?? events[0]) / (2 * Math.PI);
      parts.push(...(until > from ? [[from, until]] : [[from, 1], [0, until]]));
    }
    return parts;
  }

  function move_to(part) {
    if (!period_shown) return;
    const { points, period, time, forces, speeds, cursor, to } = period_shown, x = to(part);
    for (const end of ["x1", "x2"]) cursor.setAttribute(end, x);
    const point = points[Math.min(points.length - 1, Math.round(part * points.length))];
    const shown = (value, { factor, unit }) => `${number(value * factor, 3)} ${unit}`;
    const words = `${shown(part * period, time)}: force ${shown(point[2], forces)}, contact speed ${shown(point[1], speeds)}`;
    at("explored-instant").textContent = words;
    at("explorer-time").setAttribute("aria-valuetext", words);
  }

  const scrubber = vcrit_scrubber({ button: at("explorer-play"), slider: at("explorer-time"), show: move_to });
  return { friction, cycle };
})();
