#include "base/usual_units.hpp"

#include <array>

namespace vcrit {

namespace {

constexpr auto usual = [] {
  using enum Dimension;
  return std::array{
      TabledUnit{none, "%", -2},          TabledUnit{stiffness, "N/m", 0},
      TabledUnit{stiffness, "kN/m", 3},   TabledUnit{stiffness, "MN/m", 6},
      TabledUnit{stiffness, "N/mm", 3},   TabledUnit{stiffness, "kN/mm", 6},
      TabledUnit{stiffness, "N/um", 6},   TabledUnit{stiffness, "N/µm", 6},
      TabledUnit{stiffness, "mN/um", 3},  TabledUnit{stiffness, "N/nm", 9},
      TabledUnit{damping, "N.s/m", 0},    TabledUnit{damping, "N s/m", 0},
      TabledUnit{damping, "mN.s/m", -3},  TabledUnit{damping, "kN.s/m", 3},
      TabledUnit{damping, "N.s/mm", 3},   TabledUnit{modulus, "Pa", 0},
      TabledUnit{modulus, "kPa", 3},      TabledUnit{modulus, "MPa", 6},
      TabledUnit{modulus, "GPa", 9},      TabledUnit{viscosity, "Pa.s", 0},
      TabledUnit{viscosity, "mPa.s", -3}, TabledUnit{viscosity, "kPa.s", 3},
      TabledUnit{viscosity, "MPa.s", 6},  TabledUnit{time, "s", 0},
      TabledUnit{time, "ms", -3},         TabledUnit{time, "us", -6},
      TabledUnit{time, "µs", -6},         TabledUnit{time, "ns", -9},
      TabledUnit{mass, "kg", 0},          TabledUnit{mass, "g", -3},
      TabledUnit{mass, "mg", -6},         TabledUnit{length, "m", 0},
      TabledUnit{length, "cm", -2},       TabledUnit{length, "mm", -3},
      TabledUnit{length, "um", -6},       TabledUnit{length, "µm", -6},
      TabledUnit{length, "nm", -9},       TabledUnit{angle, "rad", 0},
      TabledUnit{velocity, "m/s", 0},     TabledUnit{velocity, "cm/s", -2},
      TabledUnit{velocity, "mm/s", -3},   TabledUnit{velocity, "um/s", -6},
      TabledUnit{velocity, "µm/s", -6},   TabledUnit{force, "N", 0},
      TabledUnit{force, "mN", -3},        TabledUnit{force, "uN", -6},
      TabledUnit{force, "µN", -6},        TabledUnit{force, "kN", 3},
      TabledUnit{frequency, "Hz", 0},     TabledUnit{frequency, "kHz", 3},
      TabledUnit{frequency, "MHz", 6},    TabledUnit{angular_frequency, "rad/s", 0},
      TabledUnit{compliance, "m/N", 0},   TabledUnit{compliance, "mm/N", -3},
      TabledUnit{compliance, "um/N", -6}, TabledUnit{compliance, "µm/N", -6},
      TabledUnit{compliance, "nm/N", -9},
  };
}();

}  // namespace

std::span<const TabledUnit> tabled_units() { return usual; }

std::optional<int> usual_power(std::string_view unit, Dimension dimension) {
  for (const TabledUnit& row : usual)
    if (row.dimension == dimension && row.name == unit) return row.power;
  return std::nullopt;
}

}  // namespace vcrit
