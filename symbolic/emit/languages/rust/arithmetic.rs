// The fixed parts of generated Rust, by sections. The generator fills in what begins with THE_. What is under "alone" is
// not generated: with it this file compiles as it is.
//: begin
#[allow(dead_code, non_snake_case, unused_parens, unused_variables, clippy::all)]
#[rustfmt::skip]
mod evaluator {
//: alone
const THE_MOST_EDGES: usize = 52;
#[derive(Clone, Copy, Debug)]
pub struct Parameters { pub mu0: f64, pub THE_OMEGA: f64, pub du_z: f64 }
//: structs
#[derive(Clone, Copy, Debug)]
pub struct Certified {
    pub value: f64,
    /// infinite: nothing is known
    pub relative_error_bound: f64,
}
#[derive(Clone, Copy, Debug)]
pub struct Gradient {
    pub value: f64,
    /// d value/d parameter
    pub partial: Parameters,
}

// Sums are in the order that is written, doubles rounded as doubles: Rust has no option that changes this. Without the
// instruction mul_add is a function of the C library, slower; is_exact() asks whether it rounds once.
#[cfg(all(target_arch = "x86", not(target_feature = "sse2")))]
compile_error!("doubles have to be rounded as doubles: a target with SSE2");
//: numbers
/// hi + lo; operations err by less than 16 u^2 of their terms' absolute values, u = 2^-53
#[derive(Clone, Copy)]
struct Dd { hi: f64, lo: f64 }
fn dd_number(hi: f64, lo: f64) -> Dd { Dd { hi, lo } }
fn dd_of(x: f64) -> Dd { dd_number(x, 0.0) }
fn dd_quick(a: f64, b: f64) -> Dd {
    let s = a + b;
    dd_number(s, b - (s - a))
}
fn dd_sum(a: f64, b: f64) -> Dd {
    let s = a + b;
    let t = s - a;
    dd_number(s, (a - (s - t)) + (b - t))
}
fn dd_product(a: f64, b: f64) -> Dd {
    let p = a * b;
    dd_number(p, a.mul_add(b, -p))
}
fn dd_negated(a: Dd) -> Dd { dd_number(-a.hi, -a.lo) }
fn dd_add_d(a: Dd, b: f64) -> Dd {
    let s = dd_sum(a.hi, b);
    dd_quick(s.hi, s.lo + a.lo)
}
fn dd_add(a: Dd, b: Dd) -> Dd {
    let s = dd_sum(a.hi, b.hi);
    dd_quick(s.hi, s.lo + (a.lo + b.lo))
}
fn dd_mul_d(a: Dd, b: f64) -> Dd {
    let p = dd_product(a.hi, b);
    dd_quick(p.hi, a.lo.mul_add(b, p.lo))
}
fn dd_mul(a: Dd, b: Dd) -> Dd {
    let p = dd_product(a.hi, b.hi);
    dd_quick(p.hi, p.lo + a.lo.mul_add(b.hi, a.hi * b.lo))
}
fn dd_div(a: Dd, b: Dd) -> Dd {
    let q = a.hi / b.hi;
    dd_quick(q, dd_add(a, dd_negated(dd_mul_d(b, q))).hi / b.hi)
}
fn dd_root(a: Dd) -> Dd {
    let r = a.hi.sqrt();
    dd_quick(r, dd_add(a, dd_negated(dd_product(r, r))).hi / (2.0 * r))
}
fn within(limit: f64, x: f64) -> bool { x <= limit && x * limit >= 1.0 }
/// 2^e of a normal number
fn power(e: i64) -> f64 { f64::from_bits(((1023 + e) as u64) << 52) }
/// e of 2^e <= |x| < 2^(e + 1), where x is not 0
fn exponent(x: f64) -> i64 {
    let stored = |y: f64| (y.to_bits() >> 52 & 0x7ff) as i64 - 1023;
    if stored(x) > -1023 { stored(x) } else { stored(x * power(54)) - 54 }
}
/// x 2^e, rounded once
fn scaled(mut x: f64, mut e: i64) -> f64 {
    for _ in 0..2 {
        if e > 1023 {
            x *= power(1023);
            e -= 1023;
        } else if e < -1022 {
            x *= power(-969); // exact, unless the next step leaves 0
            e += 969;
        }
    }
    x * power(e.clamp(-1022, 1023))
}
//: wide
/// times 2^e, for numbers out of range
#[derive(Clone, Copy)]
struct Wide { t: Dd, e: i64 }
#[inline(never)]
fn wide_scaled(t: Dd, s: i64) -> Wide {
    if t.hi == 0.0 || !t.hi.is_finite() {
        return Wide { t, e: -100000 };
    }
    let e = s + exponent(t.hi);
    Wide { t: dd_number(scaled(t.hi, s - e), scaled(t.lo, s - e)), e }
}
fn wide_number(hi: f64, lo: f64) -> Wide { wide_scaled(dd_number(hi, lo), 0) }
fn wide_of(x: f64) -> Wide { wide_scaled(dd_of(x), 0) }
fn wide_over(a: Wide, s: i64) -> Dd { dd_number(scaled(a.t.hi, a.e - s), scaled(a.t.lo, a.e - s)) }
fn wide_rounded(a: Wide) -> f64 { scaled(a.t.hi, a.e) }
fn wide_negated(a: Wide) -> Wide { wide_scaled(dd_negated(a.t), a.e) }
#[inline(never)]
fn wide_add(a: Wide, b: Wide) -> Wide {
    let e = a.e.max(b.e);
    wide_scaled(dd_add(wide_over(a, e), wide_over(b, e)), e)
}
#[inline(never)]
fn wide_mul(a: Wide, b: Wide) -> Wide { wide_scaled(dd_mul(a.t, b.t), a.e + b.e) }
#[inline(never)]
fn wide_div(a: Wide, b: Wide) -> Wide { wide_scaled(dd_div(a.t, b.t), a.e - b.e) }
#[inline(never)]
fn wide_root(a: Wide) -> Wide {
    let e = a.e & !1;
    if a.t.hi == 0.0 { a } else { wide_scaled(dd_root(wide_over(a, e)), e / 2) }
}
fn wide_magnitude(a: Wide) -> Wide { if a.t.hi < 0.0 { wide_negated(a) } else { a } }
//: less_inertia
/// k - m w^2, exact but for the last rounding
fn plain_less_inertia(k: f64, m: f64, w: f64) -> f64 {
    let t = dd_product(m, w);
    (-t.lo).mul_add(w, (-t.hi).mul_add(w, k))
}
fn dd_less_inertia(k: f64, m: f64, w: f64) -> Dd {
    let t = dd_product(m, w);
    let (p, q) = (dd_product(t.hi, w), dd_product(t.lo, w));
    dd_add_d(dd_add(dd_sum(k, -p.hi), dd_negated(dd_sum(p.lo, q.hi))), -q.lo)
}
fn wide_less_inertia(k: f64, m: f64, w: f64) -> Wide {
    let (a, b, c) = (wide_of(k), wide_of(m), wide_of(w));
    let bcc = wide_mul(wide_mul(b, c), c);
    if (a.e - bcc.e).abs() > 300 {
        return wide_add(a, wide_negated(bcc));
    }
    let e = b.e + 2 * c.e;
    wide_scaled(dd_less_inertia(wide_over(a, e).hi, b.t.hi, c.t.hi), e)
}
//: power_unit
/// a power of two near 1/x
fn unit(x: f64) -> f64 { f64::from_bits(0x7fe0000000000000u64.wrapping_sub(x.to_bits() & 0x7ff0000000000000)) }
fn wide_unit(_: Wide) -> f64 { 1.0 }
//: nonzero
/// zeros only occur out of range: T/Q = 0/1
fn wide_nonzero(a: Wide, b: Wide) -> Wide { if a.t.hi == 0.0 && b.t.hi == 0.0 { wide_of(1.0) } else { a } }
//: ties
/// edges that are 0, as bits
fn wide_gap(gaps: f64, re: Wide, im: Wide) -> f64 {
    2.0 * gaps + if re.t.hi == 0.0 && im.t.hi == 0.0 { 1.0 } else { 0.0 }
}
/// Gaps may leave parts that nothing holds. They carry no load: one gap that leads to each becomes an edge of stiffness 1
/// (1), its other gaps are none for good (0), and all other edges stay as they are (-1). wiring: two nodes an edge.
fn tie(wiring: &str, gaps: f64, edge: usize) -> f64 {
    let n = wiring.len() / 2;
    let node = |i: usize| 1u64 << (wiring.as_bytes()[i] - b'a');
    let ends = |i: usize| node(2 * i) | node(2 * i + 1);
    let is_gap = |i: usize| gaps as u64 >> (n - 1 - i) & 1 == 1; // exact: at most THE_MOST_EDGES bits
    let mut held = 3; // the terminals, and what edges and ties connect with them
    let mut kind = -1.0;
    let mut is_first = true;
    while gaps > 0.0 {
        for i in 0..n * n {
            if !is_gap(i % n) && ends(i % n) & held != 0 {
                held |= ends(i % n);
            }
        }
        if is_first && is_gap(edge) && ends(edge) & !held != 0 {
            kind = 0.0;
        }
        is_first = false;
        match (0..n).find(|&i| is_gap(i) && ends(i) & held != 0 && ends(i) & !held != 0) {
            Some(next) if next == edge => return 1.0,
            Some(next) => held |= ends(next),
            None => break,
        }
    }
    kind
}
fn plain_tied(a: f64, kind: f64, otherwise: f64) -> f64 { if kind < 0.0 { a } else { kind * otherwise } }
fn wide_tied(a: Wide, kind: f64, otherwise: f64) -> Wide { if kind < 0.0 { a } else { wide_of(kind * otherwise) } }
//: magnitude
fn dd_magnitude(a: Dd) -> Dd { if a.hi < 0.0 { dd_negated(a) } else { a } }
//: unless_moderate
fn unless_moderate(x: f64) -> f64 { if within(power(200), x) { 0.0 } else { f64::INFINITY } }
fn wide_unless_moderate(_: Wide) -> Wide { wide_of(0.0) }
//: alone
const THE_ROWS: f64 = 1.0;
//: table
/// The drive's receptance as it was measured: angular frequency, real and imaginary part. Linear between two rows.
static ROWS: &[f64] = &[THE_ROWS];
/// of the row at or below omega, but for the last one; -1 outside of the table
fn place(omega: f64) -> f64 {
    let (mut low, mut high) = (0, ROWS.len() / 3 - 1);
    if !(omega >= ROWS[0] && omega <= ROWS[3 * high]) {
        return -1.0;
    }
    while low + 1 < high {
        let middle = (low + high) / 2;
        if ROWS[3 * middle] <= omega { low = middle } else { high = middle }
    }
    low as f64
}
fn entry(at: f64, number: usize) -> f64 { if at < 0.0 { f64::NAN } else { ROWS[3 * at as usize + number] } }
//: alone
fn in_range(p: &Parameters) -> bool { p.mu0 > 0.0 }
fn allowed(p: &Parameters) -> bool { p.mu0 > 0.0 }
fn THE_SQUARE_ROOT(x: f64) -> f64 { x.sqrt() }
fn THE_DD_ROOT(x: Dd) -> Dd { dd_root(x) }
fn THE_WIDE_ROOT(x: Wide) -> Wide { wide_root(x) }
//: finished
/// Whether sums and products keep what they round off, of numbers that the compiler does not know: there are libraries
/// whose fma is a product and a sum.
fn is_exact() -> bool {
    use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
    const EXACT: u64 = 1;
    const INEXACT: u64 = 2;
    static KNOWN: AtomicU64 = AtomicU64::new(0x3fffffffffffffff); // 2 - 2^-52, until it is known: for each thread the same
    let known = KNOWN.load(Relaxed);
    if known == EXACT || known == INEXACT {
        return known == EXACT;
    }
    let (one, small, odd) = (known & 0x3ff0000000000000, known & 0x3c30000000000000, known);
    let (a, b, c) = (f64::from_bits(one), f64::from_bits(small), f64::from_bits(odd)); // 1, 2^-60
    let (sum, product) = (dd_add(dd_of(a), dd_of(b)), dd_mul(dd_of(c), dd_of(c)));
    let exact = dd_quick(a, b).lo == b && dd_sum(b, a).lo == b && dd_add_d(sum, -a).hi == b
        && c.mul_add(c, -(c * c)) == power(-104) && product.lo == power(-104);
    KNOWN.store(if exact { EXACT } else { INEXACT }, Relaxed);
    exact
}
const U: f64 = f64::EPSILON / 2.0; // 2^-53
const TWOFOLD: f64 = 16.0 * U * U; // 2^-102
struct Evaluated { certified: Certified, safe: bool }
/// v* = factor root(above/below). Factors (1 + e_j)^(+-1) with sum |e_j| = e < 2^-10 change it by less than 1.01 e, the
/// last rounding by u, and another one by 2^-1075 where numbers are subnormal. safe: none has left the range of doubles.
fn finished(value: f64, e: f64, u: f64, safe: bool) -> Evaluated {
    let known = e < power(-10) && value < f64::MAX;
    let bound = if known { (1.01 * e + u) * (1.0 + 4.0 * f64::EPSILON) } else { f64::INFINITY };
    Evaluated { certified: Certified { value, relative_error_bound: bound }, safe }
}
fn is_safe(h: f64, v: f64, inside: bool) -> bool {
    inside && h > power(-900) && h < power(900) && v >= f64::MIN_POSITIVE
}
fn plain_finished(above: f64, below: f64, factor: f64, roundings: f64, inside: bool) -> Evaluated {
    let h = above / below;
    let v = THE_SQUARE_ROOT(h) * factor;
    finished(v, roundings * U, 0.0, is_safe(h, v, inside))
}
fn dd_finished(above: Dd, below: Dd, factor: Dd, roundings: f64, inside: bool) -> Evaluated {
    let v = dd_mul(THE_DD_ROOT(dd_div(above, below)), factor).hi;
    finished(v, roundings * TWOFOLD, U, is_safe(above.hi / below.hi, v, inside))
}
fn wide_finished(above: Wide, below: Wide, factor: Wide, roundings: Wide, inside: bool) -> Evaluated {
    let h = (above.t.hi / below.t.hi).abs();
    let v = if h > 0.0 && h < f64::INFINITY {
        wide_rounded(wide_mul(THE_WIDE_ROOT(wide_div(above, below)), factor))
    } else {
        THE_SQUARE_ROOT(h) * factor.t.hi
    };
    let least = f64::from_bits(1); // 2^-1074
    let tiny = if v > 0.0 { U + least / (2.0 * v - least) } else { 1.0 };
    let e = if inside { wide_rounded(roundings) * TWOFOLD } else { f64::INFINITY };
    finished(v, e, if v >= f64::MIN_POSITIVE { U } else { tiny }, true)
}
//: alone
fn wide_evaluate(p: &Parameters, partial: Option<&mut Parameters>) -> Evaluated {
    let x = wide_of(p.mu0);
    if let Some(d) = partial { *d = *p; }
    wide_finished(x, x, x, x, allowed(p))
}
fn THE_GRADE_evaluate(p: &Parameters, partial: Option<&mut Parameters>) -> Evaluated {
    let x = dd_of(p.mu0);
    if let Some(d) = partial { *d = *p; }
    dd_finished(x, x, x, 50.0, in_range(p))
}
//: calls
fn THE_GRADE_result(p: &Parameters, mut partial: Option<&mut Parameters>) -> Certified {
    let r = THE_GRADE_evaluate(p, partial.as_deref_mut());
    if r.safe { r.certified } else { wide_evaluate(p, partial).certified }
}
pub fn THE_FAST_critical_velocity(p: &Parameters) -> f64 {
    THE_GRADE_result(p, None).value
}
pub fn THE_FAST_critical_velocity_certified(p: &Parameters) -> Certified {
    let mut c = THE_GRADE_result(p, None);
    if !is_exact() {
        c.relative_error_bound = f64::INFINITY;
    }
    c
}
pub fn THE_FAST_critical_velocity_gradient(p: &Parameters) -> Gradient {
    let mut partial = *p;
    let value = THE_GRADE_result(p, Some(&mut partial)).value;
    Gradient { value, partial }
}
pub fn THE_FAST_critical_velocity_batch(p: &Parameters, omega: &[f64], out: &mut [f64]) {
    let mut at = *p;
    for (omega, out) in omega.iter().zip(out) {
        at.THE_OMEGA = *omega;
        *out = THE_FAST_critical_velocity(&at);
    }
}
//: end
}
#[allow(unused_imports)]
pub use self::evaluator::*;
