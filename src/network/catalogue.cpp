#include "network/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace vcrit {

namespace {

using Names = std::vector<std::string>;

Network k(const std::string& name) { return spring({name}); }
Network c(const std::string& name) { return damper({name}); }

Network prony(const Names& n, int branches) {
  std::vector<Network> parts{k(n[0])};
  for (int j = 1; j <= branches; ++j) parts.push_back(maxwell({n[1], j}, {n[2], j}));
  return parallel(std::move(parts));
}

}  // namespace

bool Rheology::has_arrays() const {
  return std::any_of(arguments.begin(), arguments.end(),
                     [](const auto& argument) { return argument.second == Argument::array; });
}

std::string Rheology::signature() const {
  Names names;
  for (const auto& [argument, kind] : arguments) names.push_back(argument);
  return fmt::format("{}({})", name, fmt::join(names, ", "));
}

const std::vector<Rheology>& catalogue() {
  constexpr auto scalar = Rheology::Argument::scalar;
  constexpr auto array = Rheology::Argument::array;
  static const std::vector<Rheology> rheologies{
      {"spring", {{"k", scalar}}, [](const Names& n, int) { return k(n[0]); }},
      {"damper", {{"c", scalar}}, [](const Names& n, int) { return c(n[0]); }},
      {"mass", {{"m", scalar}}, [](const Names& n, int) { return mass({n[0]}); }},
      {"kelvin",
       {{"k", scalar}, {"c", scalar}},
       [](const Names& n, int) {
         return parallel({k(n[0]), c(n[1])});
       }},
      {"maxwell",
       {{"k", scalar}, {"c", scalar}},
       [](const Names& n, int) {
         return series({k(n[0]), c(n[1])});
       }},
      {"zener",
       {{"k0", scalar}, {"k1", scalar}, {"c1", scalar}},
       [](const Names& n, int) {
         return parallel({k(n[0]), series({k(n[1]), c(n[2])})});
       }},
      {"jeffreys",
       {{"c0", scalar}, {"k1", scalar}, {"c1", scalar}},
       [](const Names& n, int) {
         return parallel({c(n[0]), series({k(n[1]), c(n[2])})});
       }},
      {"burgers",
       {{"k1", scalar}, {"c1", scalar}, {"k2", scalar}, {"c2", scalar}},
       [](const Names& n, int) {
         return series({k(n[0]), c(n[1]), parallel({k(n[2]), c(n[3])})});
       }},
      {"prony", {{"k0", scalar}, {"k", array}, {"tau", array}}, prony},
  };
  return rheologies;
}

}  // namespace vcrit
