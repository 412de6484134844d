// Draws a figure as SVG, from its record (figures/figure_json.hpp). Texts of a record may come from
// anybody: they become text and attributes, never markup.
"use strict";

const vcrit_drawing = (() => {
  const { numberWords, scaleOf } = vcrit_scales;
  // For a picture that leaves the page; in it the style sheet has the last word on them.
  const ink = "#1d2126", soft = "#5d6470", frame = "#a9afb8", faint = "#e2e5ea", paper = "#ffffff";
  const fontSize = 12, family = "system-ui, sans-serif", row = 18, lineHeight = 15;  // pixels, as all lengths

  const looks = {
    line: { "stroke-width": 2.2 },
    dashed: { "stroke-width": 1.6, "stroke-dasharray": "6 4" },
    dotted: { "stroke-width": 1.6, "stroke-dasharray": "2 3" },
    circles: { "stroke-width": 1.6 },
    dots: { filled: true },
    crosses: { "stroke-width": 2 },
    squares: { "stroke-width": 1.6 },
    triangles: { "stroke-width": 1.6 },
    diamonds: { "stroke-width": 1.6 },
    bars: { filled: true, opacity: 0.6 },
  };
  // Of maps: one hue from light to dark, even steps of lightness (CIE L* 95 to 20), so that it reads in grey and to all eyes.
  const hues = ["#ecf1f8", "#b1c9e5", "#74a2d1", "#357bb0", "#1d5684", "#123458"];

  const ruler = document.createElement("canvas").getContext("2d");
  ruler.font = `${fontSize}px ${family}`;
  const widthOf = (text) => ruler.measureText(text).width;

  function add(parent, name, attributes = {}, text = "") {
    const node = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, value);
    node.textContent = text;
    return parent.appendChild(node);
  }

  const short = (length) => Math.round(100 * length) / 100;

  // Where the steps of a map begin and end, as parts of its scale: from 0 on each is twice the one before (digits lost: 0,
  // 0.5, 1, 2, 4, 8, 16), as what is small matters; otherwise all are alike.
  function stepsOf({ logarithmic }, [low]) {
    const doubling = !logarithmic && low === 0;
    return [0, ...hues.slice(1).map((_, i) => (doubling ? 2 ** (i + 1 - hues.length) : (i + 1) / hues.length)), 1];
  }

  const colourAt = (part, steps) => hues[Math.max(0, steps.findLastIndex((step, i) => i < hues.length && part >= step))];

  // What an axis has to show, if it has no range of its own.
  function* shownOn(figure, horizontal) {
    const place = horizontal ? 0 : 1;
    for (const series of figure.series) {
      for (const point of series.points) if (point[0] !== null && point[1] !== null) yield point[place];
      if (series.edges && horizontal) yield* series.edges;
      if (series.edges && !horizontal && !figure.y.logarithmic) yield 0;
    }
    for (const rule of figure.rules) if (rule.horizontal !== horizontal) yield rule.at;
    if (horizontal) for (const band of figure.bands) yield* [band.from, band.to];
  }

  // Entries one after the other, in as many rows as they need: each series' name once, or each class of a map.
  function entriesOf(figure, width) {
    const entries = (figure.map?.colours ?? []).map((colour, i) => ({ name: figure.map.value.ticks[i][1], colour }));
    for (const series of figure.series) {
      const known = entries.find((entry) => entry.name === series.name && entry.series);
      if (known) known.series.push(series);
      else if (series.name) entries.push({ name: series.name, series: [series] });
    }
    let x = figure.map?.colours ? widthOf(figure.map.value.title) + 14 : 0, y = 0;
    for (const entry of entries) {
      const space = 26 + widthOf(entry.name);
      if (x > 0 && x + space > width) [x, y] = [0, y + row];
      Object.assign(entry, { x, y });
      x += space + 16;
    }
    return { entries, height: entries.length > 0 ? y + row + 6 : 0 };
  }

  // Names of lines stand at their ends, in place of a legend, where all end at the right and there is room: names apart,
  // none far from its line, and a quarter of the width at most.
  function endsOf(figure, width, y) {
    const { height, series } = figure, named = series.filter(({ name }) => name), x = scaleOf(figure.x, shownOn(figure, true), 5);
    const all = named.map(({ name, colour, style, edges, points }) => {
      const last = points.findLast((point) => x.at(point[0]) <= 1 + 1e-9 && y.at(point[1]) >= 0 && y.at(point[1]) <= 1);
      const line = !(style in marks) && !edges && last && x.at(last[0]) > 0.9;
      return { name, colour, line, place: line ? height * (1 - y.at(last[1])) : 0 };
    });
    const apart = new Set(all.map(({ name }) => name)).size === all.length;
    if (figure.map || !apart || !all.every(({ line }) => line)) return [];
    let free = -Infinity;
    for (const end of [...all].sort((a, b) => a.place - b.place)) {
      end.y = Math.max(end.place, free);
      free = end.y + lineHeight;
      if (end.y - end.place > lineHeight) return [];
    }
    return all.every(({ name }) => widthOf(name) < width / 4 - 8) ? all : [];
  }

  // Where everything lies. Lengths are from the upper left corner of the frame, in which the data are.
  function planOf(figure, width) {
    const { height } = figure, y = scaleOf(figure.y, shownOn(figure, false), height / 45);
    const left = short(22 + Math.max(40, 10 + Math.max(...y.ticks.map(({ words }) => widthOf(words)))));
    const beside = figure.right && width >= 480 ? scaleOf(figure.right, [], height / 45) : null;  // no room for it on a phone
    const room = beside ? 34 + Math.max(...beside.ticks.map(({ words }) => widthOf(words))) : 16;
    const ends = beside ? [] : endsOf(figure, width, y), right = Math.max(room, ...ends.map(({ name }) => 12 + widthOf(name)));
    const inner = Math.max(60, short(width - left - right)), x = scaleOf(figure.x, shownOn(figure, true), inner / 80);
    const aside = width < 560 ? 0 : left;  // on a phone legends need the whole width
    const colours = figure.map && !figure.map.colours ? 52 : 0;
    const { entries, height: legend } = ends.length > 0 ? { entries: [], height: 0 } : entriesOf(figure, width - aside - 30);
    const top = colours + legend + 8;
    return { figure, width, left, aside, top, inner, height, colours, entries, ends, total: top + height + 46,
             xTicks: x.ticks, yTicks: y.ticks, beside, right,
             x: (value) => short(inner * x.at(value)), y: (value) => short(height * (1 - y.at(value))) };
  }

  const inside = ({ inner, height }, x, y) => x >= -1 && x <= inner + 1 && y >= -1 && y <= height + 1;

  function drawGrid(plan, into) {
    const path = (named) =>
      plan.xTicks.filter(({ words }) => !words === !named).map(({ at }) => `M${plan.x(at)} 0v${plan.height}`).join("") +
      plan.yTicks.filter(({ words }) => !words === !named).map(({ at }) => `M0 ${plan.y(at)}h${plan.inner}`).join("");
    const all = add(into, "g", { class: "grid", stroke: faint, "shape-rendering": "crispEdges" });
    add(all, "path", { d: path(true) });
    add(all, "path", { d: path(false), opacity: 0.6 });
  }

  function drawAxis(plan, into, horizontal) {
    const { figure, inner, height, left } = plan, ticks = horizontal ? plan.xTicks : plan.yTicks;
    const axis = add(into, "g", { class: `axis ${horizontal ? "x" : "y"}`, stroke: frame });
    if (horizontal) axis.setAttribute("transform", `translate(0,${height})`);
    add(axis, "path", { d: horizontal ? `M0 0h${inner}` : `M0 0v${height}` });
    let free = -Infinity;  // from here on there is room for words
    for (const { at, words } of ticks) {
      const place = horizontal ? plan.x(at) : plan.y(at), half = widthOf(words) / 2, reach = words ? 5 : 3;
      const where = horizontal ? `${place},0` : `0,${place}`;
      const tick = add(axis, "g", { class: "tick", transform: `translate(${where})` });
      add(tick, "path", { d: horizontal ? `M0 0v${reach}` : `M0 0h-${reach}` });
      const low = horizontal ? place - half : height - place - 6;
      if (!words || low < free) continue;
      free = horizontal ? place + half + 8 : height - place + 8;
      const aside = Math.min(0, inner + 14 - place - half);  // so that the last words end with the picture
      add(tick, "text", horizontal ? { x: short(aside), y: 18, "text-anchor": "middle", stroke: "none" }
        : { x: -8, y: 4, "text-anchor": "end", stroke: "none" }, words);
    }
    const middle = horizontal ? { x: short(inner / 2), y: 38 }
      : { transform: `translate(${short(14 - left)},${height / 2}) rotate(-90)` };
    add(axis, "text", { class: "title", "text-anchor": "middle", stroke: "none", ...middle },
        horizontal ? figure.x.title : figure.y.title);
  }

  // What the heights of y mean in another unit, at the right edge.
  function drawBeside({ figure, beside, right, inner, height }, into) {
    const axis = add(into, "g", { class: "axis right", transform: `translate(${inner},0)`, stroke: frame });
    add(axis, "path", { d: `M0 0v${height}` });
    for (const { at, words } of beside.ticks) {
      const tick = add(axis, "g", { class: "tick", transform: `translate(0,${short(height * (1 - beside.at(at)))})` });
      add(tick, "path", { d: "M0 0h5" });
      add(tick, "text", { x: 8, y: 4, stroke: "none" }, words);
    }
    const turned = `translate(${short(right - 6)},${height / 2}) rotate(-90)`;
    add(axis, "text", { class: "title", "text-anchor": "middle", stroke: "none", transform: turned }, figure.right.title);
  }

  // Cells of one colour make one path.
  function drawMap(plan, into) {
    const { value, x, y, values, colours } = plan.figure.map, columns = x.length - 1, cells = new Map();
    const scale = scaleOf(value, values, 5), steps = stepsOf(value, scale.domain), classes = value.ticks?.map(([at]) => at);
    values.forEach((v, n) => {
      if (v === null) return;
      const colour = colours ? colours[classes.indexOf(v)] : colourAt(scale.at(v), steps);
      const i = n % columns, j = (n - i) / columns;
      const [left, right, low, high] = [plan.x(x[i]), plan.x(x[i + 1]), plan.y(y[j]), plan.y(y[j + 1])];
      cells.set(colour, `${cells.get(colour) ?? ""}M${left} ${low}H${right}V${high}H${left}Z`);
    });
    const all = add(into, "g", { class: "map", "shape-rendering": "crispEdges", "clip-path": `url(#${plan.clip})` });
    for (const [colour, d] of cells) add(all, "path", { d, fill: colour });
  }

  const disc = (x, y, r) => `M${short(x - r)} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`;
  const marks = {
    circles: (x, y) => disc(x, y, 3.3),
    dots: (x, y) => disc(x, y, 3.1),
    crosses: (x, y) => `M${short(x - 4)} ${y}h8M${x} ${short(y - 4)}v8`,
    squares: (x, y) => `M${short(x - 3)} ${short(y - 3)}h6v6h-6Z`,
    triangles: (x, y) => `M${x} ${short(y - 4.2)}l4 7h-8Z`,
    diamonds: (x, y) => `M${x} ${short(y - 4.6)}l4.2 4.6l-4.2 4.6l-4.2 -4.6Z`,
  };

  function barsPath(plan, { points, edges }) {
    const ground = plan.figure.y.logarithmic ? plan.height : Math.min(plan.height, Math.max(0, plan.y(0)));
    return points.map(([, y], i) => (y === null ? "" :
      `M${plan.x(edges[i])} ${ground}V${plan.y(y)}H${plan.x(edges[i + 1])}V${ground}Z`)).join("");
  }

  // A point without a place is a gap.
  function pathOf(plan, series) {
    if (series.edges) return barsPath(plan, series);
    const mark = marks[series.style];
    let path = "", next = "M";
    for (const [valueX, valueY] of series.points) {
      const x = plan.x(valueX), y = plan.y(valueY), gap = Number.isNaN(x + y);
      if (mark && inside(plan, x, y)) path += mark(x, y);
      if (!mark && !gap) path += `${next}${x} ${y}`;
      next = gap ? "M" : "L";
    }
    return path;
  }

  function paint({ style, colour, dashes }) {
    const { filled, ...look } = looks[style];
    if (!marks[style] && dashes && dashes !== "none") look["stroke-dasharray"] = dashes;
    return { class: style, fill: filled ? colour : "none", stroke: filled ? "none" : colour, ...look };
  }

  // Small boxes along a curve, which words keep off.
  function* alongCurve(plan, { style, points }) {
    if (marks[style] || style === "bars") return;
    let last = null;
    for (const [valueX, valueY] of points) {
      const x = plan.x(valueX), y = plan.y(valueY), steps = last ? Math.ceil(Math.hypot(x - last.x, y - last.y) / 8) : 1;
      for (let n = 1; n <= Math.min(steps, 200); ++n) {
        const part = n / steps, at = last ? { x: last.x + (x - last.x) * part, y: last.y + (y - last.y) * part } : { x, y };
        if (inside(plan, at.x, at.y)) yield { curve: true, x: at.x - 2, y: at.y - 2, width: 4, height: 4 };
      }
      last = Number.isNaN(x + y) ? null : { x, y };
    }
  }

  function drawSeries(plan, into, taken) {
    into.setAttribute("stroke-linejoin", "round");
    for (const series of plan.figure.series) {
      const clip = marks[series.style] ? {} : { "clip-path": `url(#${plan.clip})` };
      const d = pathOf(plan, series), look = paint(series);
      // On the dark cells of a map a line or a cross has a white edge.
      if (plan.figure.map && look.fill === "none")
        add(into, "path", { class: "edge", ...clip, fill: "none", stroke: "#ffffff", "stroke-width": look["stroke-width"] + 2, d });
      add(into, "path", { ...look, ...clip, "data-name": series.name, d });
      for (const box of alongCurve(plan, series)) taken.push(box);
    }
  }

  const meet = (a, b) =>
    a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

  // The first place in the frame that is off all of these.
  const free = (plan, taken, boxes) => boxes.find((box) =>
    box.x >= 0 && box.x + box.width <= plan.inner && box.y >= 0 && box.y + box.height <= plan.height &&
    !taken.some((other) => meet(box, other)));

  // Words keep off each other and, if they can, off curves and rules. A resonance stands at a peak and an antiresonance at a
  // dip, so that in a narrow frame their numbers are enough where their names would stand on other rules.
  function placed(plan, taken, rule) {
    const curves = taken.filter(({ line }) => !line), words = curves.filter(({ curve }) => !curve);
    const number = rule.words.replace(/^(anti)?resonance /, "");
    const named = (texts, others) => texts.map((text) => ({ text, box: free(plan, others, [...placesAt(plan, { ...rule, words: text })]) }))
      .find(({ box }) => box);
    const narrow = plan.inner < 400;
    return named(narrow ? [rule.words, number] : [rule.words], taken) ??
      named(narrow ? [number] : [rule.words, number], curves) ?? named([number], words);
  }

  // Places for a rule's words: beside its line from the bottom up, or above and below it from the left.
  function* placesAt(plan, rule) {
    const size = { width: widthOf(rule.words), height: lineHeight };
    if (rule.horizontal) {
      const y = plan.y(rule.at);
      for (let x = 6; x + size.width <= plan.inner; x += 20)
        yield* [{ x, y: y - lineHeight - 2, ...size }, { x, y: y + 2, ...size }];
      return;
    }
    const x = plan.x(rule.at);
    for (let y = plan.height - 4 - lineHeight; y >= 0; y -= lineHeight)
      yield* [{ x: x + 5, y, ...size }, { x: x - 5 - size.width, y, ...size }];
  }

  function drawWords(into, box, words) {
    add(into, "text", { x: short(box.x), y: short(box.y + 12) }, words);
  }

  const widthOfBand = (plan, { from, to }) => short(Math.min(plan.inner, plan.x(to)) - Math.max(0, plan.x(from)));

  function drawBands(plan, into) {
    for (const band of plan.figure.bands) {
      const x = Math.max(0, plan.x(band.from)), width = widthOfBand(plan, band);
      if (width > 0) add(into, "rect", { class: "band", x, y: 0, width, height: plan.height, fill: band.colour, opacity: 0.07 });
    }
  }

  // Words of shades, if they fit: at the top, or as far below it as curves and rules ask for. `taken` grows by the boxes of words.
  function drawBandWords(plan, into, taken) {
    for (const band of plan.figure.bands) {
      const width = widthOfBand(plan, band), own = widthOf(band.words);
      if (!band.words || own + 8 > width) continue;
      const top = { x: Math.max(0, plan.x(band.from)) + (width - own) / 2, y: 2, width: own, height: lineHeight };
      const places = Array.from({ length: Math.floor((plan.height - lineHeight) / 6) }, (_, i) => ({ ...top, y: 2 + 6 * i }));
      const box = free(plan, taken, places) ?? top;
      taken.push(box);
      drawWords(into, box, band.words);
    }
  }

  // And the words of bands, which keep off the lines of rules, as the words of rules keep off them.
  function drawRules(plan, into, wordsInto, taken) {
    const { inner, height } = plan;
    const shown = plan.figure.rules.filter(({ at, horizontal }) =>
      (horizontal ? inside(plan, 0, plan.y(at)) : inside(plan, plan.x(at), 0)));
    for (const { at, horizontal, colour } of shown) {
      const [x, y] = horizontal ? [0, plan.y(at)] : [plan.x(at), 0];
      add(into, "path", { class: "rule", d: `M${x} ${y}${horizontal ? `h${inner}` : `v${height}`}`, stroke: colour,
                          "stroke-dasharray": "4 3" });
      taken.push({ line: true, x, y, width: horizontal ? inner : 0, height: horizontal ? 0 : height });
    }
    drawBandWords(plan, wordsInto, taken);
    for (const rule of shown.filter(({ words }) => words)) {
      const { text, box } = placed(plan, taken, rule) ?? {};
      if (!box) continue;
      taken.push({ ...box, x: box.x - 8, width: box.width + 16 });
      drawWords(wordsInto, box, text);
    }
  }

  function drawLegend(plan, into) {
    const { figure: { map }, aside, colours } = plan;
    const all = add(into, "g", { class: "legend", transform: `translate(${aside},${colours})` });
    if (map?.colours) add(all, "text", { x: 0, y: 13 }, map.value.title);
    for (const { name, x, y, colour, series } of plan.entries) {
      const entry = add(all, "g", { class: "entry", transform: `translate(${short(x)},${y})` });
      if (colour) add(entry, "rect", { x: 4, y: 3, width: 12, height: 12, fill: colour });
      for (const each of series ?? []) {
        const mark = marks[each.style]?.(10, 9) ?? (each.edges ? "M3 4H17V14H3Z" : "M0 9H20");
        add(entry, "path", { ...paint(each), d: mark });
      }
      add(entry, "text", { x: 26, y: 13 }, name);
    }
  }

  function drawEnds({ ends, left, inner, top }, into) {
    const all = add(into, "g", { class: "legend ends", transform: `translate(${left + inner + 6},${top})` });
    for (const { name, colour, y } of ends)
      add(add(all, "g", { class: "entry", transform: `translate(0,${short(y + 4)})`, fill: colour }), "text", {}, name);
  }

  // The colours of a map, from its least to its largest value: one box a step, its bounds below.
  function drawColours(plan, into) {
    const { value, values } = plan.figure.map, width = Math.min(260, plan.width - 60) / hues.length;
    const look = { transform: `translate(${plan.aside},0)`, "shape-rendering": "crispEdges" };
    const all = add(into, "g", { class: "colours", ...look }), scale = scaleOf(value, values, 5);
    add(all, "text", { x: 0, y: 13 }, value.title);
    hues.forEach((fill, i) => add(all, "rect", { x: short(i * width), y: 19, width: short(width), height: 11, fill, stroke: frame,
                                                 "stroke-width": 0.5 }));
    const measure = value.logarithmic ? Math.log10 : Number, [low, high] = scale.domain.map(measure);
    let free = -Infinity;
    stepsOf(value, scale.domain).forEach((part, i) => {
      const at = low + part * (high - low), words = numberWords(value.logarithmic ? 10 ** at : at, 2);
      const half = widthOf(words) / 2, x = Math.max(half - plan.aside, i * width);
      if (x - half < free) return;
      free = x + half + 6;
      add(all, "text", { x: short(x), y: 44, "text-anchor": "middle" }, words);
    });
  }

  let drawings = 0;

  function drawingOf(plan) {
    const { figure, width, total, left, top, inner, height } = plan;
    const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    const outer = { width, height: total, viewBox: `0 0 ${width} ${total}`, role: "img", "aria-label": figure.title,
                    "font-family": family, "font-size": fontSize, fill: ink };
    for (const [key, each] of Object.entries(outer)) svg.setAttribute(key, each);
    plan.clip = `frame-${++drawings}`;
    add(add(svg, "clipPath", { id: plan.clip }), "rect", { x: 0, y: -1, width: inner, height: height + 2 });
    if (plan.colours) drawColours(plan, svg);
    drawLegend(plan, svg);
    drawEnds(plan, svg);
    const into = add(svg, "g", { class: "frame", transform: `translate(${left},${top})` });
    if (figure.map) drawMap(plan, into);
    else drawGrid(plan, into);
    const [bands, series, rules] = ["bands", "series", "rules"].map((name) => add(into, "g", { class: name }));
    const halo = { stroke: paper, "stroke-width": 3, "stroke-linejoin": "round", "paint-order": "stroke" };
    const words = add(into, "g", { class: "words", fill: soft, ...halo });
    const taken = [];
    drawBands(plan, bands);
    drawSeries(plan, series, taken);
    drawRules(plan, rules, words, taken);
    for (const horizontal of [true, false]) drawAxis(plan, into, horizontal);
    if (plan.beside) drawBeside(plan, into);
    return svg;
  }

  return { add, drawingOf, inside, planOf, short };
})();
