#include "scaling/scripts.hpp"

#include <cstdlib>
#include <stdexcept>

#include "harness/network_json.hpp"
#include "harness/script.hpp"
#include "run/compiler.hpp"

namespace vcrit::scaling {

namespace {

// A script has the processor time of whoever calls it.
constexpr std::chrono::minutes longest{10};

nlohmann::ordered_json asked(const ScalingCase& each) {
  nlohmann::ordered_json names{"s"}, edges = nlohmann::ordered_json::array();
  for (const Symbol& symbol : symbols_of(each.network)) names.push_back(to_text(symbol));
  const Wiring wires = wiring(each.network);
  for (const Wiring::Edge& edge : wires.edges)
    edges.push_back({edge.from, edge.to, edge.stiffness});
  return {{"names", names},
          {"steps", bench::network_json(each.network)},
          {"nodes", wires.nodes},
          {"edges", edges}};
}

std::optional<double> run(const ScalingCase& each, const char* method) {
  const validation::PrivateFolder folder;
  const std::string said =
      bench::run_script("stiffness.py", asked(each), {method}, folder.path(), longest);
  const double seconds = std::atof(said.c_str() + said.rfind("seconds ") + 8);
  return seconds > 0 ? std::optional(seconds) : std::nullopt;
}

}  // namespace

std::optional<double> sympy_composed(const ScalingCase& each) { return run(each, "composed"); }
std::optional<double> sympy_cancel(const ScalingCase& each) { return run(each, "cancel"); }
std::optional<double> sympy_field(const ScalingCase& each) { return run(each, "field"); }
std::optional<double> maxima_newdet(const ScalingCase& each) { return run(each, "newdet"); }

}  // namespace vcrit::scaling
