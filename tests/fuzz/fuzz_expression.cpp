// Network expressions. What is accepted has safe names, is the same in parentheses, and is passive:
// with all elements 1 its stiffness is finite, and neither part of it is negative.
#include <cmath>
#include <optional>

#include "base/identifiers.hpp"
#include "fuzz.hpp"
#include "network/expression.hpp"
#include "network/masses.hpp"
#include "stiffness/dynamic_stiffness.hpp"

using namespace vcrit;

namespace {

const Surroundings& surroundings() {
  static const Surroundings around{
      [](const std::string& name, const Place& place, int) -> std::optional<Network> {
        if (name == "loop") throw InputError(place, "a loop", "none");
        if (name != "pad") return std::nullopt;
        return parallel({spring({"k8"}), series({spring({"k9"}), damper({"c9"})})});
      },
      [](const std::string& name) -> std::optional<int> {
        if (name == "kk" || name == "tau") return 3;
        if (name == "none") return 0;
        return std::nullopt;
      }};
  return around;
}

void check_network(const Network& network) {
  Values values;
  for (const Symbol& symbol : symbols_of(network)) {
    fuzz::check(!unsafe_as_identifier(symbol.name), "names are safe in code");
    values[symbol] = 1;
  }
  const std::complex<double> k = dynamic_stiffness(network, values, 1);
  if (has_masses(network)) return;
  fuzz::check(std::isfinite(k.real()) && std::isfinite(k.imag()), "a stiffness is finite");
  fuzz::check(k.real() >= 0 && k.imag() >= 0, "a network without masses is passive");
}

}  // namespace

void fuzz::read_expression(const std::string& text) {
  if (fuzz::many_branches(text)) return;
  fuzz::answered([&] {
    const Network network = parse_expression(text, {"scene.toml", 1, 1}, surroundings());
    fuzz::check(parse_expression("(" + text + ")", {"scene.toml", 1, 1}, surroundings()) == network,
                "parentheses around the whole change nothing");
    check_network(network);
  });
}
