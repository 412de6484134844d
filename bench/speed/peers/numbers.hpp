// Numbers by what is known of them: one, real (double), imaginary, complex. Each operation costs
// what it must and no more; two doubles instead of std::complex, which guards against overflow.
#pragma once

namespace by_hand {

struct One {};
struct Imaginary {
  double im;
};
struct Complex {
  double re, im;
};

inline double operator*(Imaginary a, Imaginary b) { return -(a.im * b.im); }
inline Imaginary operator*(double a, Imaginary b) { return {a * b.im}; }
inline Complex operator*(double a, Complex b) { return {a * b.re, a * b.im}; }
inline Complex operator*(Complex a, Imaginary b) { return {-(a.im * b.im), a.re * b.im}; }
inline Complex operator*(Complex a, Complex b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
}
inline Imaginary operator*(Imaginary a, double b) { return b * a; }
inline Complex operator*(Complex a, double b) { return b * a; }
inline Complex operator*(Imaginary a, Complex b) { return b * a; }

inline Imaginary operator+(Imaginary a, Imaginary b) { return {a.im + b.im}; }
inline Complex operator+(double a, Imaginary b) { return {a, b.im}; }
inline Complex operator+(double a, Complex b) { return {a + b.re, b.im}; }
inline Complex operator+(Imaginary a, Complex b) { return {b.re, a.im + b.im}; }
inline Complex operator+(Complex a, Complex b) { return {a.re + b.re, a.im + b.im}; }
inline Complex operator+(Imaginary a, double b) { return b + a; }
inline Complex operator+(Complex a, double b) { return b + a; }
inline Complex operator+(Complex a, Imaginary b) { return b + a; }
inline Complex operator+(Imaginary a, One) { return {1.0, a.im}; }

template <class A>
A operator*(One, A a) {
  return a;
}
template <class A>
A operator*(A a, One) {
  return a;
}
inline One operator*(One, One) { return {}; }

// |a|^2
inline One squared(One) { return {}; }
inline double squared(double a) { return a * a; }
inline double squared(Imaginary a) { return a.im * a.im; }
inline double squared(Complex a) { return a.re * a.re + a.im * a.im; }

}  // namespace by_hand
