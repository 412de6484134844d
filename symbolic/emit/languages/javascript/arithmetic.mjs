// The fixed parts of generated JavaScript, by sections. The generator fills in what begins with THE_. What is under "alone"
// is not generated: with it this file can be imported as it is.
//: numbers
// hi + lo; operations err by less than 16 u^2 of their terms' absolute values, u = 2^-53
const dd_number = (hi, lo) => ({ hi, lo });
const dd_of = (x) => dd_number(x, 0);
const dd_quick = (a, b) => dd_number(a + b, b - (a + b - a));
const dd_sum = (a, b) => {
  const s = a + b, t = s - a;
  return dd_number(s, (a - (s - t)) + (b - t));
};
const dd_product = (a, b) => {
  const p = a * b, ca = 134217729 * a, cb = 134217729 * b;
  const ah = ca - (ca - a), al = a - ah, bh = cb - (cb - b), bl = b - bh;
  return dd_number(p, al * bl - (((p - ah * bh) - al * bh) - ah * bl));
};
const dd_negated = (a) => dd_number(-a.hi, -a.lo);
const dd_add_d = (a, b) => {
  const s = dd_sum(a.hi, b);
  return dd_quick(s.hi, s.lo + a.lo);
};
const dd_add = (a, b) => {
  const s = dd_sum(a.hi, b.hi);
  return dd_quick(s.hi, s.lo + (a.lo + b.lo));
};
const dd_mul_d = (a, b) => {
  const p = dd_product(a.hi, b);
  return dd_quick(p.hi, p.lo + a.lo * b);
};
const dd_mul = (a, b) => {
  const p = dd_product(a.hi, b.hi);
  return dd_quick(p.hi, p.lo + (a.lo * b.hi + a.hi * b.lo));
};
const dd_div = (a, b) => {
  const q = a.hi / b.hi;
  return dd_quick(q, dd_add(a, dd_negated(dd_mul_d(b, q))).hi / b.hi);
};
//: root
const dd_root = (a) => {
  const r = Math.sqrt(a.hi);
  return dd_quick(r, dd_add(a, dd_negated(dd_product(r, r))).hi / (2 * r));
};
//: within
const within = (limit, x) => Object.is(x, 0) || (x <= limit && x * limit >= 1);
//: less_inertia
// k - m w^2, exact but for the last rounding
const dd_less_inertia = (k, m, w) => {
  const t = dd_product(m, w), p = dd_product(t.hi, w), q = dd_product(t.lo, w);
  return dd_add_d(dd_add(dd_sum(k, -p.hi), dd_negated(dd_sum(p.lo, q.hi))), -q.lo);
};
const plain_less_inertia = (k, m, w) => {
  const t = dd_product(m, w), p = dd_product(t.hi, w), s = dd_sum(k, -p.hi);
  return s.hi + ((s.lo - p.lo) - t.lo * w);
};
//: power_unit
const bits = new DataView(new ArrayBuffer(8));
const unit = (x) => {  // a power of two near 1/x
  bits.setFloat64(0, x);
  bits.setUint32(0, 0x7fe00000 - (bits.getUint32(0) & 0x7ff00000));
  bits.setUint32(4, 0);
  return bits.getFloat64(0);
};
//: nonzero
// T/Q = 0/1 of what is not there
const dd_nonzero = (a, b) => (a.hi === 0 && b.hi === 0 ? dd_of(1) : a);
const plain_nonzero = (a, b) => (a === 0 && b === 0 ? 1 : a);
//: ties
// edges that are 0, as bits
const plain_gap = (gaps, re, im) => 2 * gaps + (re === 0 && im === 0 ? 1 : 0);
const dd_gap = (gaps, re, im) => plain_gap(gaps, re.hi, im.hi);
// Gaps may leave parts that nothing holds. They carry no load: one gap that leads to each becomes an edge of stiffness 1
// (1), its other gaps are none for good (0), and all other edges stay as they are (-1). `wiring`: two nodes an edge.
const tie = (wiring, gaps, edge) => {
  if (gaps === 0) return -1;
  const n = wiring.length / 2;
  const node = (i) => 1 << (wiring.charCodeAt(i) - 97);
  const edges = Array.from({ length: n }, (_, i) => ({
    ends: node(2 * i) | node(2 * i + 1),
    gap: Math.floor(gaps / 2 ** (n - 1 - i)) % 2 === 1,
  }));
  let held = 3;  // the terminals, and what edges and ties connect with them
  const leads_on = (e) => (e.ends & held) !== 0 && (e.ends & ~held) !== 0;
  const connect = () => {
    for (let e; (e = edges.find((x) => !x.gap && leads_on(x))); ) held |= e.ends;
  };
  connect();
  const kind = edges[edge].gap && (edges[edge].ends & ~held) !== 0 ? 0 : -1;
  for (let e; (e = edges.find((x) => x.gap && leads_on(x))); connect()) {
    if (e === edges[edge]) return 1;
    held |= e.ends;
  }
  return kind;
};
const plain_tied = (a, kind, otherwise) => (kind < 0 ? a : kind * otherwise);
const dd_tied = (a, kind, otherwise) => (kind < 0 ? a : dd_of(kind * otherwise));
//: magnitude
const dd_magnitude = (a) => (a.hi < 0 ? dd_negated(a) : a);
//: unless_moderate
const unless_moderate = (x) => (within(2 ** 200, x) ? 0 : Infinity);
//: alone
const THE_ROWS = 1;
//: table
// The drive's receptance as it was measured: angular frequency, real and imaginary part. Linear between two rows.
const rows = [THE_ROWS];
const place = (omega) => {  // of the row at or below omega, but for the last one; -1 outside of the table
  let low = 0, high = rows.length / 3 - 1;
  if (!(omega >= rows[0] && omega <= rows[3 * high])) return -1;
  while (low + 1 < high) {
    const middle = Math.floor((low + high) / 2);
    if (rows[3 * middle] <= omega) low = middle;
    else high = middle;
  }
  return low;
};
const entry = (at, number) => (at < 0 ? NaN : rows[3 * at + number]);
//: alone
const in_range = (p) => within(2 ** 200, p.mu0);
const THE_SQUARE_ROOT = Math.sqrt;
const THE_ROOT = dd_root;
//: finished
// v* = factor root(above/below). Factors (1 + e_j)^(+-1) with sum |e_j| = e < 2^-10 change it by less than 1.01 e, the
// last rounding by u. safe: no number has left the range of doubles.
const finished = (h, value, e, u, inside) => {
  const safe = inside && h > 2 ** -900 && h < 2 ** 900 && value >= 2 ** -1022 && value < Infinity;
  const relative_error_bound = safe && e < 2 ** -10 ? (1.01 * e + u) * (1 + 2 ** -50) : Infinity;
  return { certified: { value, relative_error_bound }, safe };
};
const plain_finished = (above, below, factor, roundings, inside) => {
  const h = above / below;
  return finished(h, THE_SQUARE_ROOT(h) * factor, roundings * 2 ** -53, 0, inside);
};
const dd_finished = (above, below, factor, roundings, inside) => {
  const v = dd_mul(THE_ROOT(dd_div(above, below)), factor).hi;
  return finished(above.hi / below.hi, v, roundings * 2 ** -102, 2 ** -53, inside);
};
//: alone
const evaluated = (r, p) => ({ ...r, partial: p });
const dd_evaluate = (p) => {
  const x = dd_of(p.mu0);
  return evaluated(dd_finished(x, x, x, 50, in_range(p)), p);
};
const plain_evaluate = (p) => evaluated(plain_finished(p.mu0, p.mu0, p.mu0, 50, in_range(p)), p);
//: calls
const dd_result = (p, gradient) => {
  const r = dd_evaluate(p, gradient);
  return r.safe ? r : plain_evaluate(p, gradient);
};

export const critical_velocity = (p) => dd_result(p, false).certified.value;
export const critical_velocity_certified = (p) => dd_result(p, false).certified;
export const critical_velocity_gradient = (p) => {  // partial: d value/d parameter
  const r = dd_result(p, true);
  return { value: r.certified.value, partial: r.partial };
};
export const critical_velocity_batch = (p, omega, out = new Float64Array(omega.length)) => {
  const at = { ...p };
  for (let i = 0; i < omega.length; ++i) {
    at.THE_OMEGA = omega[i];
    out[i] = critical_velocity(at);
  }
  return out;
};

// In plain double.
export const fast_critical_velocity = (p) => plain_evaluate(p, false).certified.value;
export const fast_critical_velocity_certified = (p) => plain_evaluate(p, false).certified;
export const fast_critical_velocity_gradient = (p) => {
  const r = plain_evaluate(p, true);
  return { value: r.certified.value, partial: r.partial };
};
export const fast_critical_velocity_batch = (p, omega, out = new Float64Array(omega.length)) => {
  const at = { ...p };
  for (let i = 0; i < omega.length; ++i) {
    at.THE_OMEGA = omega[i];
    out[i] = fast_critical_velocity(at);
  }
  return out;
};
