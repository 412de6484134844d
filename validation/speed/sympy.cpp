// SymPy: |K|^2 composed of real and imaginary parts as expressions, common subexpressions named by
// cse, printed by ccode.
#include <fmt/core.h>

#include <stdexcept>

#include "base/files.hpp"
#include "network/reduction.hpp"
#include "speed/methods.hpp"

namespace vcrit::speed {

namespace {

constexpr std::chrono::seconds longest{60};

// Parameters are named by their columns: x0, x1, ...
constexpr const char* beginning = R"(
import sys
sys.setrecursionlimit(100000)
import sympy

class Number:
  def __init__(self, re, im): self.re, self.im = re, im
  def __add__(a, b): return Number(a.re + b.re, a.im + b.im)
  def __mul__(a, b): return Number(a.re*b.re - a.im*b.im, a.re*b.im + a.im*b.re)
  def __truediv__(a, b):
    q = b.squared()
    return Number((a.re*b.re + a.im*b.im)/q, (a.im*b.re - a.re*b.im)/q)
  def squared(self): return self.re**2 + self.im**2

def spring(k): return Number(k, sympy.Integer(0))
def damper(c): return Number(sympy.Integer(0), c*x1)
def maxwell(k, t): return spring(k)*damper(t)/(spring(1) + damper(t))
def series(a, b): return a*b/(a + b)
)";

constexpr const char* ending = R"(
loaded = drive + spring(-x3*x1**2)
v = x0*x1*x2*sympy.sqrt(normal.squared()*(tangential + loaded).squared()
                        /(tangential.squared()*loaded.squared()))
names, (value,) = sympy.cse(v, symbols=sympy.numbered_symbols('t'))
with open(sys.argv[1], "w") as file:
  for name, expression in names: file.write(f"    const double {name} = {sympy.ccode(expression)};\n")
  file.write(f"    out[i] = {sympy.ccode(value)};\n")
)";

/// One assignment a step.
class Assignments {
 public:
  using Value = std::string;
  explicit Assignments(const Problem& problem) {
    for (std::size_t j = 0; j < problem.columns.size(); ++j)
      names_[problem.columns[j].symbol] = fmt::format("x{}", j);
  }

  void assign(const std::string& name, const Network& network) {
    const std::string value = evaluate(reduce(network), *this);
    text += fmt::format("{} = {}\n", name, value);
  }
  Value element(const Element& e) {
    const std::string& x = names_.at(e.coefficient);
    if (e.kind == ElementKind::spring) return named(fmt::format("spring({})", x));
    if (e.kind == ElementKind::damper) return named(fmt::format("damper({})", x));
    return named(fmt::format("maxwell({}, {})", x, names_.at(e.second)));
  }
  Value parallel(const Value& a, const Value& b) { return named(a + " + " + b); }
  Value series(const Value& a, const Value& b) {
    return named(fmt::format("series({}, {})", a, b));
  }
  Value mesh(const Value& a, const Value& b, const Value& total) {
    return named(fmt::format("{}*{}/{}", a, b, total));
  }
  const std::string& of(const Symbol& symbol) const { return names_.at(symbol); }

  std::string text;

 private:
  Value named(const std::string& expression) {
    text += fmt::format("z{} = {}\n", count_, expression);
    return fmt::format("z{}", count_++);
  }
  std::map<Symbol, std::string> names_;
  int count_ = 0;
};

std::string script(const Problem& problem) {
  Assignments assignments(problem);
  for (std::size_t j = 0; j < problem.columns.size(); ++j)
    assignments.text += fmt::format("x{0} = sympy.Symbol('x{0}', positive=True)\n", j);
  const Scene& scene = problem.scene;
  assignments.assign("normal", scene.normal);
  if (const auto* network = std::get_if<Network>(&scene.tangential))
    assignments.assign("tangential", *network);
  else
    assignments.text +=
        fmt::format("tangential = spring({})*normal\n",
                    assignments.of(std::get<Isotropic>(scene.tangential).quantity.symbol));
  assignments.assign("drive", *scene.drive);
  return beginning + assignments.text + ending;
}

std::string loop(const Problem& problem, const std::string& body, Mode mode) {
  std::string outside, inside;
  for (std::size_t j = 0; j < problem.columns.size(); ++j) {
    const bool fixed = mode == Mode::sweep && j != omega_column;
    (fixed ? outside : inside) +=
        fmt::format("  const double x{0} = x[{0}][{1}];\n", j, fixed ? "0" : "i");
  }
  return fmt::format(
      "extern \"C\" void {}(const double* const* x, std::size_t n, double* __restrict out,\n"
      "    double*) {{\n{}#pragma omp simd\n  for (std::size_t i = 0; i < n; ++i) {{\n{}{}  }}\n"
      "}}\n",
      mode == Mode::sweep ? "sweep" : "varying", outside, inside, body);
}

}  // namespace

std::vector<Evaluator> sympy(const Problem& problem, const std::filesystem::path& compiler) {
  const validation::PrivateFolder folder;
  const std::filesystem::path file = folder.path() / "script.py", body = folder.path() / "body.inc",
                              source = folder.path() / "loop.cpp";
  write_file(file, script(problem));
  const auto result =
      validation::run_program({"/usr/bin/python3", file, body}, folder.path(), longest);
  if (result.timed_out) throw std::runtime_error("cse was not back in a minute");
  if (!result.succeeded())
    throw std::runtime_error("the script failed: " + result.output.substr(0, 2000));
  std::string text = "#include <cmath>\n#include <cstddef>\nusing std::pow;\nusing std::sqrt;\n";
  for (const Mode mode : both_modes) text += loop(problem, read_file(body), mode);
  write_file(source, text);
  std::vector<Evaluator> all;
  const auto add = [&](const char* name, const std::vector<std::string>& flags) {
    const auto library = std::make_shared<const Library>(compiler, flags, source);
    all.push_back(evaluator(name, Mode::sweep, library, "sweep"));
    all.push_back(evaluator(name, Mode::varying, library, "varying"));
  };
  add("SymPy cse", Flags::scalar());
  add("SymPy cse, fast-math", Flags::unsafe());
  return all;
}

}  // namespace vcrit::speed
