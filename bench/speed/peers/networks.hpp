// The networks of the problems by hand, K = over/under without a division, and Eq. (24) as one
// quotient of products. The elements E give values, e[j], and products with s, e.damper(j): as
// numbers at one frequency, or as polynomials in s. VCRIT_SCENE is the problem that is compiled.
#pragma once

#include <type_traits>

#include "speed/peers/numbers.hpp"

namespace by_hand {

template <class Over, class Under>
struct Fraction {
  Over over;
  Under under;
};
template <class Over, class Under>
Fraction(Over, Under) -> Fraction<Over, Under>;

struct Spring {
  static constexpr int size = 1;
  template <class E>
  [[gnu::always_inline]] static auto stiffness(const E& e) {
    return Fraction<double, One>{e[0], {}};
  }
};

struct Kelvin {
  static constexpr int size = 2;
  template <class E>
  [[gnu::always_inline]] static auto stiffness(const E& e) {
    return Fraction{e[0] + e.damper(1), One{}};
  }
};

// k0 | (k1 - c1)
struct Zener {
  static constexpr int size = 3;
  template <class E>
  [[gnu::always_inline]] static auto stiffness(const E& e) {
    const auto under = e[1] + e.damper(2);
    return Fraction{e[0] * under + e[1] * e.damper(2), under};
  }
};

// k1 - c1 - (k2 | c2)
struct Burgers {
  static constexpr int size = 4;
  template <class E>
  [[gnu::always_inline]] static auto stiffness(const E& e) {
    const auto damper = e.damper(1);
    const auto last = e[2] + e.damper(3);
    return Fraction{e[0] * (damper * last), last * (damper + e[0]) + e[0] * damper};
  }
};

// k0, k_1..k_10, tau_1..tau_10
struct Prony {
  static constexpr int size = 21;
  template <class E>
  [[gnu::always_inline]] static auto stiffness(const E& e) {
    return with<10>(e);
  }

 private:
  template <int branches, class E>
  [[gnu::always_inline]] static auto with(const E& e) {
    if constexpr (branches == 0) {
      return Spring::stiffness(e);
    } else {
      const auto others = with<branches - 1>(e);
      const auto turn = e.damper(10 + branches);
      return Fraction{others.over * turn + others.over + e[branches] * (others.under * turn),
                      others.under * turn + others.under};
    }
  }
};

// K_10 = k_10 | c_10, K_j = c_j | (k_j - K_{j+1}). Both sides of the fraction grow by a stiffness a
// rung; scaled down twice, the products of all squares stay doubles.
struct Ladder {
  static constexpr int size = 20;
  template <class E>
  [[gnu::always_inline]] static auto stiffness(const E& e) {
    return from<1>(e);
  }

 private:
  static constexpr double scale = 0x1p-100;

  template <int rung, class E>
  [[gnu::always_inline]] static auto from(const E& e) {
    if constexpr (rung == 10) {
      return Fraction{e[9] + e.damper(19), One{}};
    } else {
      const auto rest = from<rung + 1>(e);
      const double k = rung == 7 || rung == 4 ? scale * e[rung - 1] : e[rung - 1];
      const auto under = k * rest.under + (rung == 7 || rung == 4 ? scale : 1.0) * rest.over;
      return Fraction{k * rest.over + e.damper(9 + rung) * under, under};
    }
  }
};

// Edges z1 A-C, z2 A-D, z3 C-B, z4 D-B, z5 C-D: spanning trees over forests.
template <class Z1, class Z2, class Z3, class Z4, class Z5>
[[gnu::always_inline]] inline auto bridge(Z1 z1, Z2 z2, Z3 z3, Z4 z4, Z5 z5) {
  const auto left = z1 + z3;
  const auto right = z2 + z4;
  return Fraction{(z1 * z3) * right + (z2 * z4) * left + z5 * ((z1 + z2) * (z3 + z4)),
                  left * right + z5 * (left + right)};
}

// k_1..k_5, c_1..c_5
struct Bridge {
  static constexpr int size = 10;
  template <class E>
  [[gnu::always_inline]] static auto stiffness(const E& e) {
    return bridge(e[0] + e.damper(5), e[1] + e.damper(6), e[2] + e.damper(7), e[3] + e.damper(8),
                  e[4] + e.damper(9));
  }
};

// k1 A-C, c1 A-D, k2 C-D, c2 C-B, k3 D-B
struct SingleElementBridge {
  static constexpr int size = 5;
  template <class E>
  [[gnu::always_inline]] static auto stiffness(const E& e) {
    return bridge(e[0], e.damper(1), e.damper(3), e[4], e[2]);
  }
};

struct Isotropic {
  static constexpr int size = 1;
};

// |over_a over_b| / |under_a under_b under_c|
template <class OverA, class OverB, class UnderA, class UnderB, class UnderC>
struct Quotient {
  OverA over_a;
  OverB over_b;
  UnderA under_a;
  UnderB under_b;
  UnderC under_c;
};
template <class OverA, class OverB, class UnderA, class UnderB, class UnderC>
Quotient(OverA, OverB, UnderA, UnderB, UnderC) -> Quotient<OverA, OverB, UnderA, UnderB, UnderC>;

// K_d - m w^2 over its denominator; VCRIT_EXACT_DRIVE keeps the product's rounding error where an
// elastic drive may come near its resonance.
template <class E, class Over, class Under>
[[gnu::always_inline]] inline auto load(const E& e, const Fraction<Over, Under>& drive) {
#ifdef VCRIT_EXACT_DRIVE
  if constexpr (std::is_same_v<Over, double>)
    return e.less_inertia(drive.over, 3);
  else
#endif
    return drive.over + e.inertia(3) * drive.under;
}

// |K_n|/|K_t| |K_t + K_d - m w^2|/|K_d - m w^2|, of the columns mu0, omega, du_z, m, elements.
template <class Normal, class Tangential, class Drive>
struct Scene {
  static constexpr int columns = 4 + Normal::size + Tangential::size + Drive::size;

  template <class E>
  [[gnu::always_inline]] static auto quotient(const E& e) {
    const auto normal = Normal::stiffness(e.after(4));
    const auto drive = Drive::stiffness(e.after(4 + Normal::size + Tangential::size));
    const auto loaded = load(e, drive);
    if constexpr (Tangential::size == 1) {
      const double ratio = e[4 + Normal::size];
      const auto sum = ratio * normal.over * drive.under + loaded * normal.under;
      return Quotient{One{}, sum, normal.under, ratio, loaded};
    } else {
      const auto tangential = Tangential::stiffness(e.after(4 + Normal::size));
      const auto sum = tangential.over * drive.under + loaded * tangential.under;
      return Quotient{normal.over, sum, normal.under, tangential.over, loaded};
    }
  }
};

using Problem = VCRIT_SCENE;

}  // namespace by_hand
