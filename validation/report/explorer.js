// "Try it": fields and sliders set the scene's numbers, the simulator (live/simulator.js) answers. What is set is the
// text of each field, so that a number in the address and in the command line is the number that was seen.
"use strict";

const vcrit_explorer = (() => {
  const data = JSON.parse(document.getElementById("explorer-data").textContent);
  const at = (id) => document.getElementById(id);
  const rows = data.rows.map((row, i) => ({ ...row, field: at(`field-${i}`), slider: at(`slider-${i}`), back: at(`back-${i}`) }));
  const { number, quantity, spoken } = vcrit_words;
  const POINTS = 60, SLOW = 100;  // of a curve; ms
  const REGIMES = ["sliding", "stick-slip", "stick-slip with reverse slip", "sticking", "sliding, and the contact opens",
    "stick-slip, and the contact opens", "stick-slip with reverse slip, and the contact opens"];
  const speed_row = { said: "sliding speed", exponent: -3, linear: false, field: at("explored-speed") };
  let simulator, own, speed = null, slow = false, planned = 0;

  // A field's text is a decimal number: 9.1 N/um is the double next to 9.1e6, as in a scene.
  function decimal(text, power) {
    const [digits, exponent = "0"] = text.toLowerCase().split("e");
    return Number(`${digits}e${Number(exponent) + power}`);
  }
  const si = (row, text) => decimal(text, row.exponent);
  function text_of(row, value) {
    for (let digits = 12; digits < 17; ++digits) {
      const text = number(value / 10 ** row.exponent, digits);
      if (si(row, text) === value) return text;
    }
    return number(value / 10 ** row.exponent, 17);
  }
  for (const row of rows) row.text = row.own = row.array ? "1" : text_of(row, row.values[0]);

  const is_own = (row) => row.text === row.own;
  const is_number = (text) => /^\+?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text);
  const LARGEST_POISSON = 0.5;  // and above -1

  // What is wrong with a text as a value of the row; nothing where it is one.
  function fault(row, text) {
    if (!is_number(row.linear ? text.replace(/^-/, "") : text) || (!row.linear && !(Number(text) > 0) && !/[1-9].*e-/i.test(text)))
      return `is no number${row.linear ? "" : " above 0"}${text.includes(",") ? "; write a decimal point" : ""}`;
    if (row.linear) return Number(text) > -1 && Number(text) <= LARGEST_POISSON ? "" : "is outside the range from −1 to 0.5";
    const value = decimal(text, row.exponent);
    return value > 0 && Number.isFinite(value) ? "" : "is beyond the range of numbers here, 5e-324 to 1.8e308";
  }
  const value_of = (row) => (is_own(row) ? (row.array ? 1 : row.values[0]) : si(row, row.text));
  const set_values = (row) => (row.array ? row.values.map((x) => x * value_of(row)) : [value_of(row)]);

  // Where the slider of a number stands, and the number where it stands.
  const start = (row) => (row.array ? 1 : row.values[0] / 10 ** row.exponent);
  const place = (row, value) => (row.linear ? value * 100 : data.steps * Math.log10(value / start(row)));
  const standing = (row, place) => (row.linear ? place / 100 : start(row) * 10 ** (place / data.steps));

  // A number that is 0 in the scene has no decades around it.
  for (const row of rows) row.slider.hidden = !row.linear && start(row) === 0;

  function take(row, value, digits = 4) {
    const low = standing(row, Number(row.slider.min)), high = standing(row, Number(row.slider.max));
    const within = Math.min(high, Math.max(low, value));
    row.text = number(within, digits);
    if (!row.linear && Math.abs(place(row, within)) < 0.01) row.text = row.own;
    show(row);
  }

  function show(row) {
    if (row.field !== document.activeElement) row.field.value = row.text;  // else it is being typed
    row.field.title = row.text;  // more digits than fit
    const value = Number(row.text);
    row.slider.value = row.linear || (value > 0 && start(row) > 0) ? place(row, value) : 0;
    row.slider.setAttribute("aria-valuetext", row.array ? `times ${row.text}` : `${row.text} ${spoken(row.unit)}`.trim());
    row.back.hidden = is_own(row);
  }

  // The simulator with these numbers. At rest exactly the scene's.
  function moved() {
    for (const row of rows)
      set_values(row).forEach((x, i) => {
        const omega = is_own(row) ? own.loaded[row.places[0]] : 2 * Math.PI * x;
        simulator.set(row.places[i], row.angular ? omega : x);
      });
    return simulator.move();
  }

  function curve(to) {
    const points = [], failed = [];
    for (let n = POINTS; n >= 1; --n) {
      const found = simulator.friction_next(to * n / POINTS);
      if (found.status === 0) points.push({ speed: to * n / POINTS, ratio: found.numbers[0], regime: found.numbers[2] });
      else failed.push(found.message);
    }
    return { points: points.reverse(), failed };
  }

  const reach = (drive) => (drive > 0 && Number.isFinite(drive) ? 1.3 * drive : null);

  // All that is known of the numbers that are set.
  function answer() {
    const result = { messages: [], velocity: null, drive: null, closed: null, mean: null, curve: null, to: null, outside: false };
    const wrong = moved();
    if (wrong.status !== 0) return { ...result, outside: true, messages: [["bad", wrong.message]] };
    const closed = simulator.closed();
    if (closed.status === 0) [result.closed, result.mean] = closed.numbers;
    const amplitude = value_of(rows[data.amplitude]), { exponent, unit, text } = rows[data.amplitude];
    const opens = result.closed !== null && result.closed > 0 && amplitude >= result.closed && !data.separation;
    const reasons = simulator.reasons().message.split("\n").filter(Boolean);
    result.outside = reasons.length > 0;
    if (opens) result.messages.push(["bad", `Outside the model: the contact opens. It stays closed up to an amplitude of ${number(result.closed / 10 ** exponent, 4)} ${unit} (now ${text} ${unit}).`]);
    // What says so once more, by forces: the amplitude's conditions are Eqs. (3) and (4).
    for (const reason of reasons.filter((words) => !opens || !/\(Eq\. [34]\)$/.test(words)))
      result.messages.push(["bad", `Outside the model: ${reason}.`]);
    if (result.outside) return result;
    const critical = simulator.critical();
    if (critical.status === 0) [result.velocity, result.drive, result.formula] = critical.numbers;
    else result.messages.push(["bad", `No v*: ${critical.message}.`]);
    if (result.velocity === Infinity) result.messages.push(["unsure", "Vibration lowers friction at every speed (undamped resonance; any damping makes v* finite)."]);
    if (result.velocity === 0) result.messages.push(["unsure", "Vibration cannot lower friction here: the contact point stands still (antiresonance)."]);
    if (data.separation && amplitude > (result.closed ?? Infinity))
      result.messages.push(["note", `The contact opens in every cycle${result.velocity === null || result.formula ? "" : "; v* is simulated, as the formula does not apply"}.`]);
    result.to = reach(result.drive) ?? (result.velocity === Infinity ? reach(own?.answer?.drive ?? 0.01) : null);
    const probe = result.to === null ? null : simulator.friction_next(result.to);
    if (probe !== null && probe.status !== 0) result.messages.push(["note", `No friction curve: ${probe.message}.`]);
    else if (probe !== null) result.curve = curve(result.to);
    if (result.curve?.failed.length > 0)
      result.messages.push(["unsure", `At ${result.curve.failed.length} of ${POINTS} speeds there is no friction: ${result.curve.failed[0]}.`]);
    const mean = simulator.load_on_average();
    if (mean.status === 0) result.mean = mean.numbers[0];
    return result;
  }

  function tell(messages) {
    at("explored-messages").replaceChildren(...messages.map(([kind, words]) => {
      const item = document.createElement("li");
      item.className = kind;
      item.textContent = words;
      return item;
    }));
  }

  function change(now, before) {
    const share = 100 * (now / before - 1);
    if (!Number.isFinite(share)) return "";
    const words = Math.abs(share) < 10 ? number(Math.abs(share), 2) : Math.abs(share).toFixed(0);
    return ` (${share < 0 ? "−" : "+"}${words} %)`;
  }

  // Number fields that hold no number, by what stands there.
  const unread = () => [...rows, speed_row].filter((row) => row.field.getAttribute("aria-invalid") === "true").map((row) =>
    ["bad", `${row.said}: "${row.field.value}" ${fault(row, row.field.value.trim())}. The last one stays.`]);

  function show_velocity(now) {
    const shown = at("explored-velocity"), applies = now.velocity !== null && !now.outside;
    shown.setAttribute("aria-live", applies ? "polite" : "off");
    shown.textContent = applies ? quantity(now.velocity, "m/s") : "No v*: outside the model";
    if (now.velocity === null && !now.outside) shown.textContent = "unknown";
    shown.classList.toggle("greyed", !applies);
    at("explored-label").hidden = !applies;
    at("explored-was").textContent = is_moved() && applies && own.answer.velocity !== null
      ? `was ${quantity(own.answer.velocity, "m/s")}${change(now.velocity, own.answer.velocity)}` : "";
  }

  const is_moved = () => rows.some((row) => !is_own(row));
  const now_speed = () => (speed !== null ? si(speed_row, speed) : vcrit_explorer.answer.drive / 2);

  function show_friction(now) {
    const chart = at("explored-friction");
    chart.hidden = now.curve === null;
    if (now.curve === null) return;
    const scale = vcrit_words.scale(now.to, "m/s"), line = (points) => points.map(({ speed: x, ratio }) => [x * scale.factor, ratio]);
    // Faster than where its curve ends the scene slides.
    const before = own.answer.curve === null ? [] : line(own.answer.curve.points);
    if (before.length > 0 && before[before.length - 1][1] > 0.9999) before.push([now.to * scale.factor, 1]);
    vcrit_curves.friction(chart, {
      x: { to: now.to * scale.factor, title: `sliding speed, ${scale.unit}` }, rule: now.drive * scale.factor, creeps: now.drive > now.velocity, now: line(now.curve.points),
      own: is_moved() ? before : [], at: now_speed() * scale.factor,
    });
  }

  // Friction and one cycle at the speed of the field.
  function show_point(now) {
    const drives = now.curve !== null && now.drive > 0;
    at("explored-point").hidden = at("explored-cycle").hidden = !drives;
    if (!drives) return;
    const velocity = now_speed(), found = simulator.friction(velocity, 400);
    if (speed === null) at("explored-speed").value = number(velocity * 1000, 3);
    const [ratio, , regime, events] = found.numbers, friction = value_of(rows[data.friction]);
    at("explored-ratio").textContent = found.status === 0
      ? `${number(ratio, 4)} of the friction without vibration, ${quantity(ratio * friction * now.mean, "N")} on average; ${REGIMES[regime]}`
      : found.message;
    at("explored-cycle").hidden = found.status !== 0;
    if (found.status !== 0) return;
    const points = [], first = 4 + 2 * events;
    for (let i = first; i + 3 < found.numbers.length; i += 4) points.push(found.numbers.slice(i, i + 4));
    const period = 1 / value_of(rows.find((row) => row.angular));
    vcrit_curves.cycle(points, found.numbers.slice(4, first), period, velocity);
  }

  function show_links() {
    at("explored-moved").hidden = !is_moved();
    const changed = rows.filter((row) => !is_own(row));
    const words = changed.flatMap((row) => (row.array
      ? row.values.map((x, i) => `--set ${row.name}[${i + 1}]=${x * value_of(row)}`)
      : [`--set "${row.name}=${`${row.text} ${row.unit}`.trim().replace("µ", "u")}"`]));
    at("explored-command").textContent = ["vcrit eval", quoted(data.file), ...words].join(" ");
    const fragment = changed.map((row) => `${encodeURIComponent(row.name)}=${row.text}${in_address(row)}`).join("&");
    if (location.hash.slice(1) !== fragment && (fragment !== "" || location.hash.includes("=")))
      history.replaceState(null, "", `#${fragment || "explorer"}`);
  }
  const quoted = (word) => (/^[\w./-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);

  // Of a unit in the address: 3 of "kHz" where Hz is SI; null of one that measures something else.
  function exponent_of(row, unit) {
    if (unit === "") return 0;
    const base = in_address(row).replace(/^[pnumkMG](?=[A-Za-z])/, ""), powers = { p: -12, n: -9, u: -6, m: -3, k: 3, M: 6, G: 9 };
    if (base === "N/um" && unit === "N/m") return 0;
    if (base === "N/um" || base === "g" || !unit.endsWith(base)) return null;
    return unit === base ? 0 : (unit.length === base.length + 1 ? powers[unit[0]] ?? null : null);
  }
  const in_address = (row) => (row.array ? "" : row.unit.replace("µ", "u").replace(" ", "_"));

  // What the address says; bare numbers are in SI.
  function read_address() {
    for (const part of location.hash.slice(1).split("&")) {
      const [name, text] = part.split("=").map((word) => { try { return decodeURIComponent(word); } catch { return word; } });
      const row = rows.find((each) => each.name === name);
      const found = /^(-?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)(.*)$/i.exec(text ?? "");
      if (!row || !found) continue;
      const unit = found[2].replace("µ", "u"), power = exponent_of(row, unit);
      const as_field = row.array || unit === in_address(row);
      if (!as_field && power === null) continue;
      const read = as_field ? found[1] : text_of(row, decimal(found[1], power));
      if (fault(row, read) === "") row.text = read;
    }
  }

  function refresh() {
    const begin = performance.now();
    vcrit_explorer.answer = answer();
    const now = vcrit_explorer.answer;
    tell([...unread(), ...now.messages]);
    show_velocity(now);
    show_friction(now);
    show_point(now);
    show_links();
    mark_closed(now);
    at("explorer").classList.remove("computing");
    slow = performance.now() - begin > SLOW;
    ++vcrit_explorer.answered;
  }

  // The tick on the amplitude's slider: beyond it the contact opens.
  function mark_closed(now) {
    const row = rows[data.amplitude], low = Number(row.slider.min), high = Number(row.slider.max);
    const share = now.closed > 0 ? (place(row, now.closed / 10 ** row.exponent) - low) / (high - low) : 1;
    row.slider.parentElement.style.setProperty("--closed", `${100 * Math.min(1, Math.max(0, share))}%`);
  }

  // Where an answer takes long, the old one is shown pale until the new one is there.
  function update() {
    if (!simulator || planned !== 0) return;
    if (slow) at("explorer").classList.add("computing");
    planned = (slow ? setTimeout : requestAnimationFrame)(() => { planned = 0; refresh(); }, slow ? 30 : undefined);
  }

  function keyed(row, event) {
    const forward = ["ArrowRight", "ArrowUp", "PageUp"].includes(event.key);
    const steps = { ArrowRight: 0, ArrowUp: 0, ArrowLeft: 0, ArrowDown: 0, PageUp: 10, PageDown: 10 }[event.key];
    const value = row.linear || Number(row.text) > 0 ? Number(row.text) : start(row);
    if (event.key === "Home" || event.key === "End") take(row, standing(row, Number(event.key === "Home" ? row.slider.min : row.slider.max)), 5);
    else if (steps === undefined) return;
    else if (row.linear) take(row, value + (forward ? 1 : -1) * (event.shiftKey || steps ? 0.1 : 0.005), 5);
    else take(row, value * (steps ? 10 ** (steps / data.steps) : event.shiftKey ? 1.1 : 1.005) ** (forward ? 1 : -1), 5);
    event.preventDefault();
    update();
  }

  function listen(row) {
    row.slider.addEventListener("input", () => { take(row, standing(row, Number(row.slider.value))); update(); });
    row.slider.addEventListener("keydown", (event) => keyed(row, event));
    row.field.addEventListener("input", () => {
      const text = row.field.value.trim(), good = fault(row, text) === "";
      row.field.setAttribute("aria-invalid", String(!good));
      if (good) row.text = text;
      show(row);
      update();
    });
    row.field.addEventListener("blur", () => { row.field.setAttribute("aria-invalid", "false"); row.field.value = row.text; update(); });
    row.back.addEventListener("click", () => { row.text = row.own; show(row); row.field.focus(); update(); });
  }

  function reset() {
    for (const row of rows) row.text = row.own;
    for (const row of rows) show(row);
    update();
  }

  async function copied(button, text) {
    const words = button.textContent;
    try { await navigator.clipboard.writeText(text); button.textContent = "Copied"; } catch { button.textContent = "Copying is not allowed here"; }
    setTimeout(() => { button.textContent = words; }, 2000);
  }

  async function begin() {
    const bytes = await vcrit_simulator.inflated(at("simulator-module").textContent.trim());
    simulator = await vcrit_simulator.start(bytes);
    const loaded = simulator.load(data.scene);
    if (loaded.status !== 0) return tell([["bad", loaded.message]]);
    own = { loaded: loaded.numbers, answer: null };
    const texts = rows.map((row) => row.text);
    for (const row of rows) row.text = row.own;
    own.answer = answer();
    rows.forEach((row, i) => { row.text = texts[i]; });
    refresh();
  }

  function fail(error) {
    tell([["bad", `The simulator does not run in this browser (${error.message}).`]]);
  }

  speed_row.field.addEventListener("input", () => {
    const text = speed_row.field.value.trim(), good = fault(speed_row, text) === "";
    speed_row.field.setAttribute("aria-invalid", String(!good));
    if (good) speed = text;
    update();
  });
  speed_row.field.addEventListener("blur", () => {
    if (speed_row.field.getAttribute("aria-invalid") !== "true") return;
    speed_row.field.setAttribute("aria-invalid", "false");
    if (speed !== null) speed_row.field.value = speed;
    update();
  });
  at("explorer-reset").addEventListener("click", reset);
  at("explorer-link").addEventListener("click", (event) => copied(event.target, location.href));
  at("explorer-copy").addEventListener("click", (event) => copied(event.target, at("explored-command").textContent));
  addEventListener("hashchange", () => { read_address(); for (const row of rows) show(row); update(); });
  read_address();
  for (const row of rows) { show(row); listen(row); }
  const explorer = { answer: null, answered: 0, rows, ready: null, settled: () => planned === 0,
    simulate: (velocity) => simulator.friction(velocity, 0),
    set: (texts) => { rows.forEach((row) => { row.text = texts[row.name] ?? row.own; show(row); }); refresh(); } };
  addEventListener("resize", update);
  // Not before it is about to be seen: the page is there at once.
  explorer.ready = new Promise((done) => {
    new IntersectionObserver((seen, observer) => {
      if (!seen.some((entry) => entry.isIntersecting)) return;
      observer.disconnect();
      begin().catch(fail).then(done);
    }, { rootMargin: "300px" }).observe(at("explorer"));
  });
  return explorer;
})();
