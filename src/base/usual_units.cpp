#include "base/usual_units.hpp"

#include <array>

namespace vcrit {

namespace {

constexpr auto usual = [] {
  using enum Dimension;
  return std::array{
      UsualUnit{none, "%", -2},          UsualUnit{stiffness, "N/m", 0},
      UsualUnit{stiffness, "kN/m", 3},   UsualUnit{stiffness, "MN/m", 6},
      UsualUnit{stiffness, "N/mm", 3},   UsualUnit{stiffness, "kN/mm", 6},
      UsualUnit{stiffness, "N/um", 6},   UsualUnit{stiffness, "N/µm", 6},
      UsualUnit{stiffness, "mN/um", 3},  UsualUnit{stiffness, "N/nm", 9},
      UsualUnit{damping, "N.s/m", 0},    UsualUnit{damping, "N s/m", 0},
      UsualUnit{damping, "mN.s/m", -3},  UsualUnit{damping, "kN.s/m", 3},
      UsualUnit{damping, "N.s/mm", 3},   UsualUnit{modulus, "Pa", 0},
      UsualUnit{modulus, "kPa", 3},      UsualUnit{modulus, "MPa", 6},
      UsualUnit{modulus, "GPa", 9},      UsualUnit{viscosity, "Pa.s", 0},
      UsualUnit{viscosity, "mPa.s", -3}, UsualUnit{viscosity, "kPa.s", 3},
      UsualUnit{viscosity, "MPa.s", 6},  UsualUnit{time, "s", 0},
      UsualUnit{time, "ms", -3},         UsualUnit{time, "us", -6},
      UsualUnit{time, "µs", -6},         UsualUnit{time, "ns", -9},
      UsualUnit{mass, "kg", 0},          UsualUnit{mass, "g", -3},
      UsualUnit{mass, "mg", -6},         UsualUnit{length, "m", 0},
      UsualUnit{length, "cm", -2},       UsualUnit{length, "mm", -3},
      UsualUnit{length, "um", -6},       UsualUnit{length, "µm", -6},
      UsualUnit{length, "nm", -9},       UsualUnit{angle, "rad", 0},
      UsualUnit{velocity, "m/s", 0},     UsualUnit{velocity, "cm/s", -2},
      UsualUnit{velocity, "mm/s", -3},   UsualUnit{velocity, "um/s", -6},
      UsualUnit{velocity, "µm/s", -6},   UsualUnit{force, "N", 0},
      UsualUnit{force, "mN", -3},        UsualUnit{force, "uN", -6},
      UsualUnit{force, "µN", -6},        UsualUnit{force, "kN", 3},
      UsualUnit{frequency, "Hz", 0},     UsualUnit{frequency, "kHz", 3},
      UsualUnit{frequency, "MHz", 6},    UsualUnit{angular_frequency, "rad/s", 0},
      UsualUnit{compliance, "m/N", 0},   UsualUnit{compliance, "mm/N", -3},
      UsualUnit{compliance, "um/N", -6}, UsualUnit{compliance, "µm/N", -6},
      UsualUnit{compliance, "nm/N", -9},
  };
}();

}  // namespace

std::span<const UsualUnit> usual_units() { return usual; }

std::optional<int> usual_power(std::string_view unit, Dimension dimension) {
  for (const UsualUnit& row : usual)
    if (row.dimension == dimension && row.name == unit) return row.power;
  return std::nullopt;
}

}  // namespace vcrit
