// Contacts and drives of many rheologies as scenes, with numbers near 1.
#pragma once

#include <array>
#include <string>

#include "problem/problem.hpp"

namespace vcrit::validation::paper {

/// Networks that can carry a mean load: no springs but their own, series, parallels, branches.
inline constexpr std::array contacts{"k1",
                                     "kelvin(k1, c1)",
                                     "zener(k1, k2, c1)",
                                     "k1 | c2 | k2 - c1",
                                     "kelvin(k1, c1) - kelvin(k2, c2)",
                                     "k1 - kelvin(k2, c2)",
                                     "k1 | k2 - c1 | k3 - c2 | k4 - c3"};
inline constexpr std::array tangentials{"tangential_ratio = 0.7", "poisson = 0.3",
                                        "tangential = \"zener(k2, k1, c2)\"",
                                        "tangential = \"burgers(k4, c4, k1, c2)\""};
/// None is rigid.
inline constexpr std::array drives{"", "k3", "kelvin(k3, c3)", "zener(k3, k4, c3)",
                                   "maxwell(k4, c4)"};

/// With a body below a drive that gives, where `body` says so.
Problem driven_problem(const std::string& contact, const std::string& tangential,
                       const std::string& drive, bool body);

}  // namespace vcrit::validation::paper
