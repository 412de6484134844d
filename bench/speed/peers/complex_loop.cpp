// Eq. (24) as one writes it down with std::complex. Compiled at run time for VCRIT_SCENE.
#include <complex>

#include "speed/peers/columns.hpp"

namespace complex_by_hand {

namespace {

using by_hand::At;
using by_hand::first_values;
using by_hand::Fixed;
using by_hand::Varying;
using Number = std::complex<double>;

template <class E>
struct Elements {
  E e;
  Number s;
  double k(int j) const { return e[j]; }
  Number c(int j) const { return e[j] * s; }
};

inline Number series(Number a, Number b) { return 1.0 / (1.0 / a + 1.0 / b); }

struct Spring {
  static constexpr int size = 1;
  template <class E>
  [[gnu::always_inline]] static Number stiffness(const Elements<E>& e) {
    return e.k(0);
  }
};

struct Kelvin {
  static constexpr int size = 2;
  template <class E>
  [[gnu::always_inline]] static Number stiffness(const Elements<E>& e) {
    return e.k(0) + e.c(1);
  }
};

struct Zener {
  static constexpr int size = 3;
  template <class E>
  [[gnu::always_inline]] static Number stiffness(const Elements<E>& e) {
    return e.k(0) + series(e.k(1), e.c(2));
  }
};

struct Burgers {
  static constexpr int size = 4;
  template <class E>
  [[gnu::always_inline]] static Number stiffness(const Elements<E>& e) {
    return 1.0 / (1.0 / e.k(0) + 1.0 / e.c(1) + 1.0 / (e.k(2) + e.c(3)));
  }
};

struct Prony {
  static constexpr int size = 21;
  template <class E>
  [[gnu::always_inline]] static Number stiffness(const Elements<E>& e) {
    Number sum = e.k(0);
#pragma GCC unroll 10
    for (int j = 1; j <= 10; ++j) sum += e.k(j) * e.c(10 + j) / (1.0 + e.c(10 + j));
    return sum;
  }
};

struct Ladder {
  static constexpr int size = 20;
  template <class E>
  [[gnu::always_inline]] static Number stiffness(const Elements<E>& e) {
    Number rest = e.k(9) + e.c(19);
#pragma GCC unroll 10
    for (int j = 8; j >= 0; --j) rest = e.c(10 + j) + series(e.k(j), rest);
    return rest;
  }
};

// Nodal balance at the two inner nodes.
inline Number bridge(Number z1, Number z2, Number z3, Number z4, Number z5) {
  const Number at_c = z1 + z3 + z5, at_d = z2 + z4 + z5, det = at_c * at_d - z5 * z5;
  const Number u_c = (z1 * at_d + z2 * z5) / det, u_d = (z2 * at_c + z1 * z5) / det;
  return u_c * z3 + u_d * z4;
}

struct Bridge {
  static constexpr int size = 10;
  template <class E>
  [[gnu::always_inline]] static Number stiffness(const Elements<E>& e) {
    return bridge(e.k(0) + e.c(5), e.k(1) + e.c(6), e.k(2) + e.c(7), e.k(3) + e.c(8),
                  e.k(4) + e.c(9));
  }
};

struct SingleElementBridge {
  static constexpr int size = 5;
  template <class E>
  [[gnu::always_inline]] static Number stiffness(const Elements<E>& e) {
    return bridge(e.k(0), e.c(1), e.c(3), e.k(4), e.k(2));
  }
};

struct Isotropic {
  static constexpr int size = 1;
};

template <class Normal, class Tangential, class Drive>
struct Scene {
  static constexpr int columns = 4 + Normal::size + Tangential::size + Drive::size;

  template <class E>
  [[gnu::always_inline]] static double velocity(const E& e) {
    const Number s(0.0, e.omega);
    const Number normal = Normal::stiffness(Elements<E>{e.after(4), s});
    Number tangential;
    if constexpr (Tangential::size == 1)
      tangential = e[4 + Normal::size] * normal;
    else
      tangential = Tangential::stiffness(Elements<E>{e.after(4 + Normal::size), s});
    const Number drive =
        Drive::stiffness(Elements<E>{e.after(4 + Normal::size + Tangential::size), s});
    const Number loaded = drive - e[3] * e.omega * e.omega;
    return e[0] * e.omega * e[2] * std::abs(normal) / std::abs(tangential) *
           std::abs(tangential + loaded) / std::abs(loaded);
  }
};

using Problem = VCRIT_SCENE;

}  // namespace

extern "C" [[gnu::flatten]] void varying(const double* const* x, std::size_t n,
                                         double* __restrict out, double*) {
#pragma GCC ivdep
  for (std::size_t i = 0; i < n; ++i) out[i] = Problem::velocity(At<Varying>{{x, i}, x[1][i]});
}

extern "C" [[gnu::flatten]] void sweep(const double* const* x, std::size_t n,
                                       double* __restrict out, double*) {
  const auto values = first_values<Problem::columns>(x);
  const double* __restrict const omega = x[1];
#pragma GCC ivdep
  for (std::size_t i = 0; i < n; ++i)
    out[i] = Problem::velocity(At<Fixed>{{values.data()}, omega[i]});
}

}  // namespace complex_by_hand
