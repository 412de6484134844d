#include "paper/scenes.hpp"

#include <fmt/core.h>

namespace vcrit::validation::paper {

Problem driven_problem(const std::string& contact, const std::string& tangential,
                       const std::string& drive, bool body) {
  std::string text = fmt::format("[contact]\nnormal = \"{}\"\n{}\n", contact, tangential);
  if (!drive.empty()) text += fmt::format("[drive]\nnetwork = \"{}\"\n", drive);
  if (!drive.empty() && body) text += "[body]\nmass = 0.4\n";
  text +=
      "[oscillation]\nangular_frequency = 1.3\namplitude = 0.1\nindentation = 1.0\n[friction]\n"
      "coefficient = 0.3\n[elements]\n";
  // Primes over 10, so that no two branches are alike.
  const std::pair<const char*, double> values[] = {{"k1", 1.7}, {"k2", 2.9}, {"k3", 1.3},
                                                   {"k4", 3.1}, {"c1", 0.7}, {"c2", 1.9},
                                                   {"c3", 0.5}, {"c4", 4.3}};
  const std::string used = contact + tangential + drive;
  for (const auto& [name, value] : values)
    if (used.find(name) != used.npos) text += fmt::format("{} = {}\n", name, value);
  return parse_problem(text, "paper");
}

}  // namespace vcrit::validation::paper
