#include "problem/variants.hpp"

#include <utility>

namespace vcrit {

/// Makes problems of another structure.
class Variant {
 public:
  explicit Variant(const Problem& problem) : parts(*problem), values(problem.known_values()) {}
  Problem made() { return Problem(std::move(parts), values); }

  Resolved parts;
  Values values;
};

Problem as_doubles(const Problem& problem) {
  Variant variant(problem);
  variant.parts.typed = std::make_shared<const BySymbol<TypedNumber>>();
  variant.parts.frequency.reset();
  return variant.made();
}

Problem called_otherwise(const Problem& problem, std::map<std::string, std::string> names) {
  Variant variant(problem);
  variant.parts.names = std::move(names);
  return variant.made();
}

Problem warning_of(const Problem& problem, std::vector<std::string> warnings) {
  Variant variant(problem);
  Source source = *problem->source;
  source.warnings = std::move(warnings);
  variant.parts.source = std::make_shared<const Source>(std::move(source));
  return variant.made();
}

Problem staying_closed(const Problem& problem) {
  Variant variant(problem);
  variant.parts.separation = false;
  return variant.made();
}

Problem at_depth(const Problem& problem, double indentation) {
  Variant variant(problem);
  variant.parts.load.reset();
  variant.parts.indentation.value = indentation;
  return variant.made();
}

Problem with_rigid_drive(const Problem& problem) {
  Variant variant(problem);
  variant.parts.drive = Rigid{};
  variant.parts.mass.reset();
  return variant.made();
}

Problem over_spring(const Problem& problem, ReducedNetwork normal, const Symbol& stiffness) {
  Variant variant(problem);
  variant.parts.normal = std::move(normal);
  variant.parts.tangential = ReducedNetwork(spring(stiffness));
  std::vector<Symbol> elements = *problem->elements;
  elements.push_back(stiffness);
  variant.parts.elements = std::make_shared<const std::vector<Symbol>>(std::move(elements));
  variant.values[stiffness] = 1;
  variant.parts.drive = Rigid{};
  variant.parts.mass.reset();
  variant.parts.indenter.reset();
  variant.parts.mount.reset();
  variant.parts.mount_mass.reset();
  variant.parts.separation = false;
  return variant.made();
}

Problem with_indenter(const Problem& problem, const Indenter& indenter) {
  Variant variant(problem);
  variant.parts.indenter = indenter;
  return variant.made();
}

Problem with_normal_spring(const Problem& problem, const Symbol& symbol, double stiffness) {
  Variant variant(problem);
  variant.parts.normal = ReducedNetwork(spring(symbol));
  variant.parts.elements = std::make_shared<const std::vector<Symbol>>(1, symbol);
  variant.values[symbol] = stiffness;
  return variant.made();
}

Problem with_isotropic(const Problem& problem, const Isotropic& isotropic) {
  Variant variant(problem);
  variant.parts.tangential = isotropic;
  return variant.made();
}

}  // namespace vcrit
