// The page's charts: each is drawn when it comes near the screen, again when its width changes, says what is under a
// pointer or chosen with arrow keys, and can be saved.
"use strict";

const vcrit_charts = (() => {
  const { numberWords } = vcrit_scales;
  const { add, drawingOf, inside, planOf } = vcrit_drawing;
  const reach = 24;          // pixels between a pointer and the point that it means
  const charts = new Map();  // by their elements

  function html(parent, name, className, text = "") {
    const node = document.createElement(name);
    node.className = className;
    node.textContent = text;
    return parent.appendChild(node);
  }

  // Points that are seen, in pixels of the frame.
  function pointsOf(plan) {
    return plan.figure.series.flatMap((series) => series.points.map(([x, y, words]) =>
      ({ series, values: [x, y], words, x: plan.x(x), y: plan.y(y) })).filter(({ x, y }) => inside(plan, x, y)));
  }

  function draw(element, width = element.clientWidth || 640, part = 1) {  // what is folded has no width
    const chart = charts.get(element), { figure } = chart;
    chart.width = element.clientWidth;
    chart.plan = planOf({ ...figure, height: Math.round(part * figure.height) }, width);
    chart.points = pointsOf(chart.plan);
    chart.chosen = null;
    const svg = drawingOf(chart.plan);
    const before = chart.svg ?? element.querySelector(".still");  // what is there without scripts
    if (before) before.replaceWith(svg);
    else element.prepend(svg);
    chart.svg = svg;
    drawMark(chart);
    element.classList.toggle("named", chart.plan.ends.length > 0);
    chart.told.hidden = true;
  }

  // The line of a moment, drawn again with the chart.
  function drawMark({ svg, plan, marked }) {
    if (marked === null) return;
    const line = svg.querySelector(".cursor") ?? add(svg.querySelector(".frame"), "path", { class: "cursor", stroke: "#1d2126" });
    line.setAttribute("d", `M${plan.x(marked)} 0v${plan.height}`);
  }

  function mark(element, x) {
    const chart = charts.get(element);
    chart.marked = x;
    if (chart.svg) drawMark(chart);
  }

  function tryToDraw(element) {
    near.unobserve(element);
    try {
      draw(element);
    } catch (error) {
      element.textContent = `This chart could not be drawn: ${error.message}`;
    }
  }

  function nearest({ points }, x, y) {
    let found = null, least = reach;
    for (const point of points) {
      const distance = Math.hypot(point.x - x, point.y - y);
      if (distance < least) [found, least] = [point, distance];
    }
    return found;
  }

  // Lines of [title, text].
  function aboutPoint({ figure }, { series, values: [x, y], words }) {
    if (words) return [[series.name, words]];
    return [[series.name, ""], [figure.x.title, numberWords(x, 6)], [figure.y.title, numberWords(y, 7)]];
  }

  const between = (value, a, b) => value >= Math.min(a, b) && value <= Math.max(a, b);

  function aboutPlace({ figure, ...plan }, x, y) {
    const lines = [], { map, bands, rules } = figure;
    if (map) {
      const cell = (edges, at) => edges.findIndex((edge, i) => i > 0 && between(at, edges[i - 1], edge)) - 1;
      const i = cell(map.x.map(plan.x), x), j = cell(map.y.map(plan.y), y), v = map.values[j * (map.x.length - 1) + i];
      if (i >= 0 && j >= 0 && v !== null) {
        const named = map.value.ticks?.find(([at]) => at === v);
        lines.push([map.value.title, named ? named[1] : numberWords(v, 6)]);
      }
    }
    for (const { from, to, words } of bands)
      if (words && between(x, plan.x(from), plan.x(to))) lines.push(["", words]);
    for (const { at, horizontal, words } of rules)
      if (words && Math.abs(horizontal ? y - plan.y(at) : x - plan.x(at)) < 4) lines.push(["", words]);
    return lines;
  }

  function tell(chart, point, x, y) {
    const { plan, told, svg } = chart, within = inside(plan, x, y);
    const lines = [...(point ? aboutPoint(plan, point) : []), ...(within ? aboutPlace(plan, x, y) : [])];
    svg.querySelector(".chosen")?.remove();
    told.hidden = lines.length === 0;
    told.replaceChildren();
    for (const [title, text] of lines.filter((line) => line.some(Boolean))) {
      const line = html(told, "div", "");
      if (title) html(line, "b", "", title);
      line.append(title && text ? ` ${text}` : text);
    }
    if (point) {
      const ring = { cx: point.x, cy: point.y, r: 6, fill: "none", stroke: point.series.colour, "stroke-width": 2 };
      add(svg.querySelector(".frame"), "circle", { class: "chosen", ...ring });
    }
    const left = plan.left + x < plan.width / 2;
    told.style.left = left ? `${plan.left + x + 14}px` : "auto";
    told.style.right = left ? "auto" : `${plan.width - plan.left - x + 14}px`;
    told.style.top = `${Math.max(0, plan.top + y - 10)}px`;
  }

  function hush(chart) {
    chart.chosen = null;
    chart.told.hidden = true;
    chart.svg?.querySelector(".chosen")?.remove();
  }

  function pointed(chart, event) {
    if (!chart.plan || !chart.svg.contains(event.target)) return hush(chart);
    const box = chart.svg.getBoundingClientRect();
    const x = event.clientX - box.left - chart.plan.left, y = event.clientY - box.top - chart.plan.top;
    tell(chart, nearest(chart, x, y), x, y);
  }

  function pressed(chart, element, event) {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key], { points } = chart;
    if (event.key === "Escape") hush(chart);
    if (!step || event.target !== element || !points?.length) return;
    event.preventDefault();
    const last = points.length - 1;
    chart.chosen = chart.chosen === null ? (step > 0 ? 0 : last) : Math.min(last, Math.max(0, chart.chosen + step));
    const point = points[chart.chosen];
    tell(chart, point, point.x, point.y);
  }

  function download(file, name) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(file);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  // On white, whatever the page is.
  function picture({ svg }) {
    const copy = svg.cloneNode(true);
    for (const node of copy.querySelectorAll(".chosen, .cursor")) node.remove();
    copy.prepend(add(copy, "rect", { width: "100%", height: "100%", fill: "#ffffff" }));
    return new Blob([new XMLSerializer().serializeToString(copy)], { type: "image/svg+xml" });
  }

  async function pixels({ plan, svg }, file) {
    const image = new Image(), canvas = document.createElement("canvas");
    image.src = URL.createObjectURL(file);
    await image.decode();
    canvas.width = 2 * plan.width;
    canvas.height = 2 * plan.total;
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    URL.revokeObjectURL(image.src);
    return new Promise((done) => { canvas.toBlob(done, "image/png"); });
  }

  function offerToSave(element, chart) {
    const menu = html(element, "details", "save"), summary = html(menu, "summary", "", "⋯");
    summary.setAttribute("aria-label", "Save this chart");
    html(menu, "button", "", "Save as SVG").addEventListener("click", () => {
      download(picture(chart), `${chart.figure.name}.svg`);
      menu.open = false;
    });
    html(menu, "button", "", "Save as PNG").addEventListener("click", async () => {
      download(await pixels(chart, picture(chart)), `${chart.figure.name}.png`);
      menu.open = false;
    });
  }

  // Drawn when half a screen away.
  const near = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) if (isIntersecting) tryToDraw(target);
  }, { rootMargin: "50% 0px" });

  // After the frame in which the width changed: drawing may change the height.
  const resized = new ResizeObserver((entries) => requestAnimationFrame(() => {
    for (const { target } of entries) {
      const { svg, width } = charts.get(target);
      if (svg && target.clientWidth !== width) tryToDraw(target);
    }
  }));

  // On paper three charts stand side by side, and the first beside the system: each is drawn so narrow that its words
  // stay readable, and lower by as much.
  const onPaper = [["#cycle, #frequency, .panels", 330, 0.75], [".first", 600, 0.85]];
  const sizeOnPaper = (element) => onPaper.find(([places]) => element.closest(places) !== null);
  addEventListener("beforeprint", () => {
    for (const [element, { svg }] of charts) {
      const size = sizeOnPaper(element);
      if (size) draw(element, ...size.slice(1));
      else if (!svg) tryToDraw(element);
    }
  });
  addEventListener("afterprint", () => {
    for (const element of charts.keys()) if (sizeOnPaper(element)) draw(element);
  });

  // The element becomes the chart of a figure.
  function show(element, figure) {
    const chart = { figure, chosen: null, marked: null };
    charts.set(element, chart);
    if (!element.querySelector(".still")) element.style.minHeight = `${figure.height + 60}px`;
    element.tabIndex = 0;
    chart.told = html(element, "div", "told");
    chart.told.hidden = true;
    chart.told.setAttribute("role", "status");
    offerToSave(element, chart);
    for (const name of ["pointermove", "pointerdown"]) element.addEventListener(name, (event) => pointed(chart, event));
    for (const name of ["pointerleave", "blur"]) element.addEventListener(name, () => hush(chart));
    element.addEventListener("keydown", (event) => pressed(chart, element, event));
    near.observe(element);
    resized.observe(element);
  }

  for (const element of document.querySelectorAll(".chart:not(.explored-chart)"))
    show(element, JSON.parse(element.nextElementSibling.textContent));

  return { show, mark };
})();
