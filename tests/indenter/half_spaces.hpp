// Indenters on half-spaces for the tests of this room.
#pragma once

#include <string>

#include "indenter/half_space.hpp"
#include "support/scene_text.hpp"

namespace vcrit::reference {

/// With 20 kHz, mu0 = 0.3, Poisson's ratio 0.3; `indenter` and `elements` in TOML, lengths in m.
inline Scene scene_of(const std::string& indenter, double indentation, double amplitude,
                      const std::string& normal = "k0",
                      const std::string& elements = "k0 = \"5 GPa\"", bool separation = true) {
  return test::scene_of({.normal = normal,
                         .separation = separation,
                         .indenter = indenter + "\n",
                         .frequency = "20 kHz",
                         .amplitude = amplitude,
                         .indentation = indentation,
                         .coefficient = 0.3,
                         .more = "[elements]\n" + elements + "\n"});
}

/// v* of an elastic half-space, mu0 omega du_z/ratio with ratio = 2(1 - nu)/(2 - nu), in m/s.
inline double elastic_critical_velocity(double amplitude) {
  constexpr double pi = 3.14159265358979323846;
  return 0.3 * 2 * pi * 20e3 * amplitude * (2 - 0.3) / (2 * (1 - 0.3));
}

}  // namespace vcrit::reference
