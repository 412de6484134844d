// As driver.c.
import { readFileSync } from "node:fs";
const libraries = [
  //: each
  ["LIBRARY", MEMBERS, "OMEGA"],
  //: end
];
const grades = WITH_GRADIENTS ? ["", "fast_"] : [];
const modules = await Promise.all(libraries.map(([name]) => import(`./${name}.mjs`)));
const parameters = (layout, x) => {
  const p = {};
  let at = 0;
  for (const [name, length] of layout) {
    p[name] = length ? x.slice(at, at + length) : x[at];
    at += length || 1;
  }
  return p;
};
// Infinite numbers are written "inf".
const number = (word) => (word.endsWith("inf") ? Number(word.replace("inf", "Infinity")) : Number(word));
for (const line of readFileSync(0, "utf8").trim().split("\n")) {
  const [library, ...x] = line.split(" ").map(number);
  const m = modules[library], [, layout, omega] = libraries[library], p = parameters(layout, x);
  const a = m.critical_velocity_certified(p), f = m.fast_critical_velocity_certified(p);
  const gradients = grades.flatMap((grade) => {
    const g = m[`${grade}critical_velocity_gradient`](p);
    return [g.value, ...layout.flatMap(([name]) => g.partial[name])];
  });
  console.log(a.value, a.relative_error_bound, f.value, f.relative_error_bound, m.critical_velocity(p),
    m.fast_critical_velocity(p), m.critical_velocity_batch(p, [p[omega]])[0],
    m.fast_critical_velocity_batch(p, [p[omega]])[0], ...gradients);
}
