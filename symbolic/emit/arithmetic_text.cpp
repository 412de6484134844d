#include "emit/arithmetic_text.hpp"

namespace vcrit::symbolic::text {

const char* const licence =
    R"(// SPDX-License-Identifier: MIT-0
// Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
// documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
// rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to
// permit persons to whom the Software is furnished to do so. THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY
// KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR
// PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR
// OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE
// SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.
)";

const char* const twofold =
    R"(// high + low, twice the digits of a double. An operation errs by less than 16 u^2, u = 2^-53 (Joldes, Muller, Popescu
// 2017: sum 3, product 7, quotient 15 u^2; root 25/8 u^2).
struct Twofold {
  double high, low;
  constexpr Twofold(double h, double l = 0) noexcept : high(h), low(l) {}
  explicit operator double() const noexcept { return high; }
};
inline Twofold ordered_sum(double a, double b) noexcept { return {a + b, b - ((a + b) - a)}; }
inline Twofold sum(double a, double b) noexcept {
  const double s = a + b, t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}
inline Twofold product(double a, double b) noexcept {
#if defined(__FMA__) || defined(__FP_FAST_FMA) || defined(__aarch64__)
  return {a * b, std::fma(a, b, -(a * b))};
#else
  const double s = 134217729.0 * a, t = 134217729.0 * b, x = s - (s - a), y = t - (t - b);
  return {a * b, ((x * y - a * b) + x * (b - y) + (a - x) * y) + (a - x) * (b - y)};
#endif
}
inline Twofold operator+(Twofold a, Twofold b) noexcept {
  const Twofold s = sum(a.high, b.high), t = sum(a.low, b.low);
  const Twofold v = ordered_sum(s.high, s.low + t.high);
  return ordered_sum(v.high, v.low + t.low);
}
inline Twofold operator-(Twofold a, Twofold b) noexcept { return a + Twofold(-b.high, -b.low); }
inline Twofold operator*(Twofold a, Twofold b) noexcept {
  const Twofold p = product(a.high, b.high);
  return ordered_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}
inline Twofold operator/(Twofold a, Twofold b) noexcept {
  const double q = a.high / b.high;
  const Twofold r = b * Twofold(q);
  return ordered_sum(q, ((a.high - r.high) + (a.low - r.low)) / b.high);
}
inline Twofold sqrt(Twofold a) noexcept {
  const double r = std::sqrt(a.high);
  const Twofold s = product(r, r);
  return ordered_sum(r, (((a.high - s.high) - s.low) + a.low) / (2.0 * r));
}
using std::sqrt;
)";

const char* const inertia =
    R"(// a + b - x, rounded so that nothing is lost where it nearly vanishes.
inline Twofold less(Twofold a, Twofold b, Twofold x) noexcept { return a + b - x; }
inline double less(double a, double b, Twofold x) noexcept {
  const Twofold s = sum(a, b);
  return (s.high - x.high) + (s.low - x.low);
}
)";

const char* const edge =
    R"(// An edge of a network's graph and its error bound in roundings: over() 10, join() 1, to first order
// in what came before; where that is not enough (1e12 roundings) or the range is left: infinite.
template <class T>
struct Edge {
  T re, im;
  double roundings, size;
  Edge(T a, T b, double r) noexcept
      : re(a), im(b), roundings(r), size(length(double(a), double(b))) {
    if (!(roundings < 1e12 && within(size))) roundings = std::numeric_limits<double>::infinity();
  }
};
template <class T>
Edge<T> spring(T k) noexcept { return {k, T(0.0), 0.0}; }
template <class T>
Edge<T> damper(T x) noexcept { return {T(0.0), x, 1.0}; }
template <class T>
Edge<T> maxwell(T k, T x) noexcept {
  const T g = x * k / (1.0 + x * x);
  return {g * x, g, 6.0};
}
template <class T>
Edge<T> join(const Edge<T>& a, const Edge<T>& b) noexcept {
  const Edge<T> s(a.re + b.re, a.im + b.im, 0.0);
  return {s.re, s.im, 1.01 * ((a.roundings * a.size + b.roundings * b.size) / s.size + 1.0)};
}
template <class T>
Edge<T> over(const Edge<T>& a, const Edge<T>& b, const Edge<T>& total) noexcept {  // a b/total
  const T re = a.re * b.re - a.im * b.im, im = a.re * b.im + a.im * b.re;
  const T q = total.re * total.re + total.im * total.im;
  return {(re * total.re + im * total.im) / q, (im * total.re - re * total.im) / q,
          1.01 * (a.roundings + b.roundings + total.roundings + 10.0)};
}
)";

const char* const within =
    "inline bool within(double x) noexcept { return x >= 0x1p-200 && x <= 0x1p+200; }\n";

const char* const length =
    "inline double length(double a, double b) noexcept { return std::sqrt(a * a + b * b); }\n";

const char* const estimate =
    "struct Estimate { double value, roundings; };  // roundings: relative errors, added up\n";

const char* const certified =
    R"(// Factors (1 + e_j)^(+-1) with sum |e_j| <= e change a value by at most e/(1 - e); 1.0001 covers the roundings'
// products, `last` is the rounding of the result to a double.
inline Certified bounded(const Parameters& p, Estimate v, double unit, double last) noexcept {
  const double e = v.roundings * unit;
  const bool known = in_range(p) && e < 0.25 && v.value > 0x1p-900 && v.value < 0x1p+900;
  return {v.value, known ? (1.0001 * e / (1.0 - e) + last) * (1.0 + 0x1p-50)
                         : std::numeric_limits<double>::infinity()};
}
inline Certified plain(const Parameters& p) noexcept { return bounded(p, evaluate<double>(p), 0x1p-53, 0.0); }
inline Certified accurate(const Parameters& p) noexcept {
  return in_range(p) ? bounded(p, evaluate<Twofold>(p), 0x1p-102, 0x1p-53) : plain(p);
}
template <class Velocity>
void sweep(Parameters p, std::span<const double> omega, std::span<double> out, Velocity v) noexcept {
  for (std::size_t i = 0; i < out.size() && i < omega.size(); ++i) {
    p.omega = omega[i];
    out[i] = v(p).value;
  }
}
)";

const char* const calls =
    R"(/// v*: infinite at resonance, 0 at antiresonance, NaN for 0/0.
inline double critical_velocity(const Parameters& p) noexcept { return detail::accurate(p).value; }
/// v* at each omega in place of p.omega; `out` may be `omega` itself.
inline void critical_velocity(const Parameters& p, std::span<const double> omega, std::span<double> out) noexcept {
  detail::sweep(p, omega, out, detail::accurate);
}
/// v*, and a bound on its relative error for exactly these parameters.
inline Certified critical_velocity_certified(const Parameters& p) noexcept { return detail::accurate(p); }
namespace fast {
inline double critical_velocity(const Parameters& p) noexcept { return detail::plain(p).value; }
inline void critical_velocity(const Parameters& p, std::span<const double> omega, std::span<double> out) noexcept {
  detail::sweep(p, omega, out, detail::plain);
}
inline Certified critical_velocity_certified(const Parameters& p) noexcept { return detail::plain(p); }
}  // namespace fast
)";

}  // namespace vcrit::symbolic::text
