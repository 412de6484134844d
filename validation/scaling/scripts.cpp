#include "scaling/scripts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <filesystem>

#include "base/files.hpp"
#include "compiler.hpp"
#include "network/reduction.hpp"

namespace vcrit::scaling {

namespace {

// A script has the processor time of whoever calls it.
constexpr std::chrono::minutes longest{10};

/// One assignment a step: v0 = k1, v1 = c1*s, ...
struct Assignments {
  using Value = std::string;
  std::string text;
  int count = 0;

  Value named(const std::string& expression) {
    text += fmt::format("  v{} = {}\n", count, expression);
    return fmt::format("v{}", count++);
  }
  Value element(const Element& e) {
    const std::string k = to_text(e.coefficient), tau = to_text(e.second);
    if (e.kind == ElementKind::spring) return named(k);
    if (e.kind == ElementKind::damper) return named(k + "*s");
    return named(fmt::format("{0}*{1}*s/(1 + {1}*s)", k, tau));
  }
  Value parallel(const Value& a, const Value& b) { return named(a + " + " + b); }
  Value series(const Value& a, const Value& b) {
    return named(fmt::format("1/(1/{} + 1/{})", a, b));
  }
  Value mesh(const Value& a, const Value& b, const Value& total) {
    return named(fmt::format("{}*{}/{}", a, b, total));
  }
};

// SymPy remembers expressions between runs, and is made to forget. Prints the median of as many
// runs as fit into a tenth of a second.
constexpr const char* timing = R"(
import time
from sympy.core.cache import clear_cache as forget
def measured(run):
  seconds, begin = [], time.perf_counter()
  while not seconds or time.perf_counter() - begin < 0.1:
    forget(); start = time.perf_counter(); run(); seconds.append(time.perf_counter() - start)
  print("seconds", sorted(seconds)[len(seconds)//2])
)";

std::string names(const Network& network) {
  std::vector<std::string> all{"s"};
  for (const Symbol& symbol : symbols_of(network)) all.push_back(to_text(symbol));
  return fmt::format("{}", fmt::join(all, " "));
}

std::string composition(const Network& network, const std::string& last) {
  Assignments assignments;
  const std::string whole = evaluate(reduce(network), assignments);
  return "def run():\n" + assignments.text + "  return " + fmt::format(fmt::runtime(last), whole) +
         "\n";
}

/// What a script says behind "seconds", its last word; its file comes behind the other words.
std::optional<double> run(std::vector<std::string> words, const std::string& script) {
  if (!std::filesystem::exists(words.front())) return std::nullopt;
  const validation::PrivateFolder folder;
  const std::filesystem::path file = folder.path() / "script";
  write_file(file, script);
  words.push_back(file.string());
  const auto result = validation::run_program(words, folder.path(), longest, std::nullopt);
  const std::size_t at = result.output.rfind("seconds ");
  if (!result.succeeded() || at == std::string::npos) return std::nullopt;
  const double seconds = std::atof(result.output.c_str() + at + 8);
  return seconds > 0 ? std::optional(seconds) : std::nullopt;
}

std::optional<double> python(const std::string& script) {
  return run({"/usr/bin/python3"}, timing + script + "measured(run)\n");
}

std::string sympy(const Case& each, const std::string& last) {
  const std::string all = names(each.network);
  std::string list = all;
  for (char& c : list) c = c == ' ' ? ',' : c;
  return fmt::format(
             "import sys\nsys.setrecursionlimit(100000)\nimport sympy\n{} = sympy.symbols('{}', "
             "positive=True)\n",
             list, all) +
         composition(each.network, last);
}

}  // namespace

std::optional<double> sympy_composed(const Case& each) { return python(sympy(each, "{}")); }

std::optional<double> sympy_cancel(const Case& each) {
  return python(sympy(each, "sympy.cancel({})"));
}

std::optional<double> sympy_field(const Case& each) {
  const std::string all = names(each.network);
  std::string list = all;
  for (char& c : list) c = c == ' ' ? ',' : c;
  return python(
      fmt::format(
          "import sympy\nfrom sympy.polys.fields import field\n_, {0} = field('{0}', sympy.ZZ)\n",
          list) +
      composition(each.network, "{}"));
}

std::optional<double> maxima_newdet(const Case& each) {
  const Wiring wires = wiring(each.network);
  std::vector<std::vector<std::string>> k(wires.nodes, std::vector<std::string>(wires.nodes, "0"));
  for (const Wiring::Edge& edge : wires.edges)
    for (const auto& [i, j] : {std::pair{edge.from, edge.to}, std::pair{edge.to, edge.from}}) {
      k[i][i] += "+" + edge.stiffness;
      k[i][j] += "-" + edge.stiffness;
    }
  // Terminal 1 is held, terminal 0 comes last.
  const auto matrix = [&](bool with_terminal) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 2; i < wires.nodes; ++i) kept.push_back(i);
    if (with_terminal) kept.push_back(0);
    std::vector<std::string> rows;
    for (const std::size_t i : kept) {
      std::vector<std::string> row;
      for (const std::size_t j : kept) row.push_back(k[i][j]);
      rows.push_back(fmt::format("[{}]", fmt::join(row, ",")));
    }
    return fmt::format("matrix({})", fmt::join(rows, ","));
  };
  // Short ones are repeated, since the clock ticks in milliseconds.
  const std::string script = fmt::format(
      "a: {}$\nb: {}$\n"
      "measured(n) := block([t: elapsed_real_time()], for i thru n do (newdet(a), newdet(b)), "
      "(elapsed_real_time() - t)/n)$\n"
      "t: measured(1)$\nif t < 0.005 then t: measured(1000)$\nprint(\"seconds\", float(t))$\n",
      matrix(true), wires.nodes == 2 ? "matrix([1])" : matrix(false));
  return run({"/usr/bin/maxima", "--very-quiet", "--batch"}, script);
}

}  // namespace vcrit::scaling
