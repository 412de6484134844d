#include "facts/dependence.hpp"

#include <functional>

#include "analysis/residues.hpp"
#include "base/errors.hpp"
#include "formula/names.hpp"

namespace vcrit::symbolic {

namespace {

constexpr int pairs_to_compare = 3;
// Nobody divides by 0 at so many.
constexpr std::uint64_t most_pairs = 100;

/// Whether v*^2/(-s^2) is one number at each point and where `moved` takes it.
bool stays(const SymbolicModel& model,
           const std::function<ResiduePoint(const ResiduePoint&)>& moved) {
  const auto per_frequency = [&](const ResiduePoint& point) -> std::optional<Residue> {
    const auto square = square_at(model, point);
    const Residue s = point(own_name("s"));
    if (!square) return std::nullopt;
    return *square * inverse(s * s);
  };
  int compared = 0;
  for (std::uint64_t number = 0; compared < pairs_to_compare; ++number) {
    ensure(number < most_pairs, "v* is finite at nearly all points");
    const ResiduePoint point = named_point(number);
    const auto here = per_frequency(point), there = per_frequency(moved(point));
    if (!here || !there) continue;
    if (!(*here == *there)) return false;
    ++compared;
  }
  return true;
}

}  // namespace

bool is_independent_of(const SymbolicModel& model, const std::set<std::string>& names) {
  return stays(model, [&names](const ResiduePoint& point) -> ResiduePoint {
    return [&names, point](const std::string& symbol) {
      return names.contains(symbol) ? point("another " + symbol) : point(symbol);
    };
  });
}

// The receptance of a table is another number at another frequency.
bool is_proportional_to_frequency(const SymbolicModel& model) {
  return stays(model, [](const ResiduePoint& point) -> ResiduePoint {
    return [point](const std::string& symbol) {
      if (symbol == own_name("s") || symbol == "omega") return point(symbol) * point("frequency");
      const bool measured = symbol == own_name("R_d") || symbol == own_name("conjugate R_d");
      return measured ? point("another " + symbol) : point(symbol);
    };
  });
}

}  // namespace vcrit::symbolic
