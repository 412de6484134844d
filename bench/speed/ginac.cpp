// GiNaC's compile_ex: v* as one real expression, written to C and compiled by gcc while the program
// runs, called value by value.
#include <fmt/core.h>
#include <ginac/ginac.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "network/reduction.hpp"
#include "speed/methods.hpp"

namespace vcrit::speed {

namespace {

using GiNaC::ex;

// compile_ex writes expressions out as trees.
constexpr double most_operations = 200'000;

struct Pair {
  ex re, im;
  double operations = 0;  ///< of both parts, written out
};
Pair operator+(const Pair& a, const Pair& b) {
  return {a.re + b.re, a.im + b.im, a.operations + b.operations + 2};
}
Pair operator*(const Pair& a, const Pair& b) {
  return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re,
          2 * (a.operations + b.operations) + 6};
}
Pair operator/(const Pair& a, const Pair& b) {
  const ex q = b.re * b.re + b.im * b.im;
  return {(a.re * b.re + a.im * b.im) / q, (a.im * b.re - a.re * b.im) / q,
          2 * (a.operations + b.operations) + 4 * b.operations + 14};
}
ex squared(const Pair& a) { return a.re * a.re + a.im * a.im; }

struct Composition {
  using Value = Pair;
  const std::map<Symbol, ex>& symbols;
  ex omega;

  Pair element(const Element& e) const {
    const Pair k{symbols.at(e.coefficient), 0}, c{0, k.re * omega, 1};
    if (e.kind == ElementKind::spring) return k;
    if (e.kind == ElementKind::damper) return c;
    const ex turn = symbols.at(e.second) * omega, share = k.re * turn / (1 + turn * turn);
    return {share * turn, share, 14};
  }
  static Pair parallel(const Pair& a, const Pair& b) { return checked(a + b); }
  static Pair series(const Pair& a, const Pair& b) { return checked(a * b / (a + b)); }
  static Pair mesh(const Pair& a, const Pair& b, const Pair& total) {
    return checked(a * b / total);
  }

 private:
  static Pair checked(const Pair& result) {
    if (result.operations > most_operations)
      throw std::runtime_error("more than 200,000 operations written out");
    return result;
  }
};

struct Formula {
  GiNaC::lst symbols, value;
};

Formula formula(const Subject& subject) {
  Formula result;
  std::map<Symbol, ex> symbols;
  for (const VariedParameter& column : subject.columns) {
    const GiNaC::symbol symbol(fmt::format("x{}", symbols.size()));
    symbols[column.symbol] = symbol;
    result.symbols.append(symbol);
  }
  const Problem& problem = subject.problem;
  const ex mu0 = result.symbols[0], omega = result.symbols[1], du_z = result.symbols[2],
           m = result.symbols[3];
  Composition composition{symbols, omega};
  const auto stiffness = [&](const ReducedNetwork& network) {
    return evaluate(network.reduction(), composition);
  };
  const Pair normal = stiffness(problem->normal);
  const auto* network = std::get_if<ReducedNetwork>(&problem->tangential);
  const Pair tangential =
      network != nullptr
          ? stiffness(*network)
          : Pair{symbols.at(std::get<Isotropic>(problem->tangential).quantity.symbol), 0} * normal;
  const Pair loaded = stiffness(*problem->drive_network()) + Pair{-m * omega * omega, 0, 3};
  result.value.append(mu0 * omega * du_z *
                      sqrt(squared(normal) * squared(tangential + loaded) /
                           (squared(tangential) * squared(loaded))));
  return result;
}

/// The flags reach GiNaC's compiler by the environment.
class CompilerFlags {
 public:
  explicit CompilerFlags(const char* flags) { setenv("CXXFLAGS", flags, 1); }
  ~CompilerFlags() { unsetenv("CXXFLAGS"); }
  CompilerFlags(const CompilerFlags&) = delete;
  CompilerFlags& operator=(const CompilerFlags&) = delete;
};

/// compile_ex writes into the working folder, and an interruption leaves it there.
class InTemporaryFolder {
 public:
  InTemporaryFolder() { current_path(std::filesystem::temp_directory_path()); }
  ~InTemporaryFolder() { current_path(before_); }
  InTemporaryFolder(const InTemporaryFolder&) = delete;
  InTemporaryFolder& operator=(const InTemporaryFolder&) = delete;

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
};

void run_on_samples(GiNaC::FUNCP_CUBA function, const Samples& samples, int columns, double* out) {
  std::vector<double> x(static_cast<std::size_t>(columns));
  const int one = 1;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i == 0 || samples.mode() == CallMode::varying)
      for (std::size_t j = 0; j < x.size(); ++j) x[j] = samples.columns()[j][i];
    x[omega_column] = samples.columns()[omega_column][i];
    function(&columns, x.data(), &one, out + i);
  }
}

}  // namespace

std::vector<TimedMethod> ginac(const Subject& subject) {
  const Formula all = formula(subject);
  std::vector<TimedMethod> result;
  for (const auto& [name, flags] : {std::pair{"GiNaC compile_ex", ""},
                                    std::pair{"GiNaC compile_ex, -O3", "-O3 -march=native"}}) {
    const CompilerFlags environment(flags);
    const InTemporaryFolder folder;
    GiNaC::FUNCP_CUBA function = nullptr;
    GiNaC::compile_ex(all.value, all.symbols, function);
    const int columns = static_cast<int>(subject.columns.size());
    for (const CallMode mode : both_modes) {
      TimedMethod each;
      each.method = name;
      each.mode = mode;
      each.run = [function, columns](const Samples& samples, double* out, double*) {
        run_on_samples(function, samples, columns, out);
      };
      result.push_back(std::move(each));
    }
  }
  return result;
}

}  // namespace vcrit::speed
