// SymPy: peers/sympy_loop.py writes two loops, compiled here.
#include "harness/network_json.hpp"
#include "harness/script.hpp"
#include "speed/methods.hpp"

namespace vcrit::speed {

namespace {

// cse of a ladder's expressions is not back in any time that one would wait.
constexpr std::chrono::seconds longest_cse{60};

nlohmann::ordered_json asked(const Subject& subject) {
  const Problem& problem = subject.problem;
  nlohmann::ordered_json json{{"columns", nlohmann::ordered_json::array()},
                              {"omega", omega_column},
                              {"normal", bench::network_json(problem->normal.network())},
                              {"drive", bench::network_json(problem->drive_network()->network())}};
  for (const VariedParameter& column : subject.columns)
    json["columns"].push_back(to_text(column.symbol));
  if (const auto* network = std::get_if<ReducedNetwork>(&problem->tangential))
    json["tangential"] = bench::network_json(network->network());
  else
    json["ratio"] = to_text(std::get<Isotropic>(problem->tangential).quantity.symbol);
  return json;
}

}  // namespace

std::vector<TimedMethod> sympy(const Subject& subject, const std::filesystem::path& compiler) {
  const validation::PrivateFolder folder;
  const std::filesystem::path source = folder.path() / "loop.cpp";
  bench::run_script("sympy_loop.py", asked(subject), {source}, folder.path(), longest_cse);
  std::vector<TimedMethod> all;
  const auto add = [&](const char* name, const std::vector<std::string>& flags) {
    const auto library = std::make_shared<const Library>(compiler, flags, source);
    all.push_back(evaluator(name, CallMode::sweep, library, "sweep"));
    all.push_back(evaluator(name, CallMode::varying, library, "varying"));
  };
  add("SymPy cse", Flags::scalar());
  add("SymPy cse, fast-math", Flags::unsafe());
  return all;
}

}  // namespace vcrit::speed
