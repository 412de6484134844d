#include "speed/problems.hpp"

#include <fmt/core.h>

#include <array>

namespace vcrit::speed {

namespace {

/// A network, or the ratio of an isotropic contact. `place` is "n", "t" or "d" and ends up in the
/// names of its elements.
struct Part {
  std::string by_hand, expression, table;
  std::vector<VariedParameter> columns;
};
using Kind = Part (*)(const std::string& place);

// Stiff but ordinary: w c ~ k and m w^2 ~ k at w ~ 1e5.
VariedParameter stiffness(const std::string& name) { return {{name}, 1e6, 1e8}; }
VariedParameter damping(const std::string& name) { return {{name}, 10, 1000}; }

/// K_j at `place` has spring "k<place>j" and damper "c<place>j".
std::vector<VariedParameter> numbered(const std::string& place, int count) {
  std::vector<VariedParameter> columns;
  for (int j = 1; j <= count; ++j) columns.push_back(stiffness(fmt::format("k{}{}", place, j)));
  for (int j = 1; j <= count; ++j) columns.push_back(damping(fmt::format("c{}{}", place, j)));
  return columns;
}

Part spring_part(const std::string& x) { return {"Spring", "k" + x, "", {stiffness("k" + x)}}; }

Part kelvin_part(const std::string& x) {
  return {"Kelvin", fmt::format("k{0} | c{0}", x), "", {stiffness("k" + x), damping("c" + x)}};
}

Part zener_part(const std::string& x) {
  return {"Zener",
          fmt::format("k{0}0 | (k{0}1 - c{0}1)", x),
          "",
          {stiffness("k" + x + "0"), stiffness("k" + x + "1"), damping("c" + x + "1")}};
}

Part burgers_part(const std::string& x) {
  return {"Burgers",
          fmt::format("k{0}1 - c{0}1 - (k{0}2 | c{0}2)", x),
          "",
          {stiffness("k" + x + "1"), damping("c" + x + "1"), stiffness("k" + x + "2"),
           damping("c" + x + "2")}};
}

Part prony_part(const std::string& x) {
  Part part{
      "Prony", fmt::format("prony(k{0}0, k{0}, tau{0}, 10)", x), "", {stiffness("k" + x + "0")}};
  for (int j = 1; j <= 10; ++j) part.columns.push_back({{"k" + x, j}, 1e6, 1e8});
  for (int j = 1; j <= 10; ++j) part.columns.push_back({{"tau" + x, j}, 1e-7, 1e-3});
  return part;
}

Part ladder_part(const std::string& x) {
  std::string expression = fmt::format("k{0}10 | c{0}10", x);
  for (int j = 9; j > 0; --j)
    expression = fmt::format("c{0}{1} | (k{0}{1} - ({2}))", x, j, expression);
  return {"Ladder", expression, "", numbered(x, 10)};
}

std::string graph(const std::string& name, const std::array<std::string, 5>& edges) {
  static constexpr std::array between{R"("A", "C")", R"("A", "D")", R"("C", "B")", R"("D", "B")",
                                      R"("C", "D")"};
  std::string table = fmt::format("[networks.{}]\nterminals = [\"A\", \"B\"]\nedges = [", name);
  for (std::size_t j = 0; j < edges.size(); ++j)
    table += fmt::format("[\"{}\", {}], ", edges[j], between[j]);
  return table + "]\n";
}

Part bridge_part(const std::string& x) {
  std::array<std::string, 5> edges;
  for (std::size_t j = 0; j < edges.size(); ++j)
    edges[j] = fmt::format("k{0}{1} | c{0}{1}", x, j + 1);
  return {"Bridge", "bridge_" + x, graph("bridge_" + x, edges), numbered(x, 5)};
}

// As scenes/bridge.toml, its nodes 1 and 2 named C and D.
Part single_element_bridge_part(const std::string& x) {
  const std::string k = "k" + x, c = "c" + x;
  return {"SingleElementBridge",
          "bridge_" + x,
          graph("bridge_" + x, {k + "1", c + "1", c + "2", k + "3", k + "2"}),
          {stiffness(k + "1"), damping(c + "1"), stiffness(k + "2"), damping(c + "2"),
           stiffness(k + "3")}};
}

Part isotropic_part(const std::string&) { return {"Isotropic", "", "", {{{"ratio"}, 0.5, 1}}}; }

Subject subject(const std::string& name, Kind normal, Kind tangential, Kind drive) {
  const std::array parts{normal("n"), tangential("t"), drive("d")};
  std::vector<VariedParameter> columns{
      {{"mu0"}, 0.1, 0.5}, {{"omega"}, 5e4, 2e5}, {{"du_z"}, 1e-8, 1e-6}, {{"m"}, 1e-4, 1e-2}};
  std::string tables;
  for (const Part& part : parts) {
    columns.insert(columns.end(), part.columns.begin(), part.columns.end());
    tables += part.table;
  }
  const std::string how = parts[1].expression.empty()
                              ? "tangential_ratio = \"ratio\""
                              : fmt::format("tangential = \"{}\"", parts[1].expression);
  return {name,
          fmt::format("Scene<{}, {}, {}>", parts[0].by_hand, parts[1].by_hand, parts[2].by_hand),
          std::move(columns),
          parse_problem(
              fmt::format("title = \"{}\"\n[contact]\nnormal = \"{}\"\n{}\n[drive]\nnetwork = "
                          "\"{}\"\n[body]\nmass = \"m\"\n{}",
                          name, parts[0].expression, how, parts[2].expression, tables),
              name + ".toml")};
}

}  // namespace

std::vector<Subject> all_subjects() {
  return {subject("Kelvin", kelvin_part, kelvin_part, kelvin_part),
          subject("Zener", zener_part, zener_part, zener_part),
          subject("Burgers", burgers_part, burgers_part, burgers_part),
          subject("Prony-10", prony_part, prony_part, prony_part),
          subject("ladder-10", ladder_part, ladder_part, ladder_part),
          subject("bridge", bridge_part, bridge_part, bridge_part),
          subject("S1", kelvin_part, isotropic_part, spring_part),
          subject("S2", prony_part, prony_part, kelvin_part),
          subject("S3", single_element_bridge_part, single_element_bridge_part, spring_part)};
}

}  // namespace vcrit::speed
