#include "emit/network_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.hpp"

namespace vcrit::symbolic {

namespace {

using SymbolName = std::function<std::string(const Symbol&)>;
using Component = std::optional<std::string>;

// Relative errors of the formulas below, counted in roundings: a product or quotient adds those of
// its operands and one, a sum of positive terms takes the larger and one.
constexpr int damper_roundings = 1;   // w c
constexpr int maxwell_roundings = 6;  // x 1, 1 + x^2 2, g 1 + 2 + 1, g x 5; and x itself 1
constexpr int same_kind_roundings = 3;
constexpr int spring_damper_roundings = 5;  // k^2 + x^2 2, g 4, g x 5
constexpr int series_roundings = 9;  // |z1 + z2|^2 4, |z|^2 2, a1 |z2|^2 3, sum 4, quotient 9

struct Value {
  Component re, im;
  int path = 0;  ///< the largest sum of roundings on a way to an element
};

/// Series-parallel code.
class TreeWriter {
 public:
  using Value = symbolic::Value;

  TreeWriter(NetworkCode& code, const std::string& prefix, const SymbolName& symbol)
      : code_(code), prefix_(prefix), symbol_(symbol) {}

  Value element(const Element& e) {
    const std::string k = symbol_(e.coefficient);
    if (e.kind == ElementKind::spring) {
      code_.ranges.push_back(k);
      return {"T(" + k + ")", std::nullopt, 0};
    }
    if (e.kind == ElementKind::damper) {
      code_.ranges.push_back("p.omega * " + k);
      return {std::nullopt, write("x", "w * " + k, 1), damper_roundings};
    }
    const std::string tau = symbol_(e.time);
    for (const std::string& range :
         {k, "p.omega * " + tau, fmt::format("p.omega * {} * {}", tau, k)})
      code_.ranges.push_back(range);
    const std::string x = write("x", "w * " + tau, 1);
    const std::string g = write("g", fmt::format("{0} * {1} / (1.0 + {0} * {0})", x, k), 4);
    return {write("a", g + " * " + x, 1), g, maxwell_roundings};
  }

  Value parallel(const Value& a, const Value& b) {
    const bool rounds = (a.re && b.re) || (a.im && b.im);
    return {sum(a.re, b.re, "a"), sum(a.im, b.im, "b"),
            std::max(a.path, b.path) + (rounds ? 1 : 0)};
  }

  Value series(const Value& a, const Value& b) {
    const int path = std::max(a.path, b.path);
    if (!a.im && !b.im) return {same_kind(*a.re, *b.re), std::nullopt, path + same_kind_roundings};
    if (!a.re && !b.re) return {std::nullopt, same_kind(*a.im, *b.im), path + same_kind_roundings};
    if (!a.im && !b.re) return spring_damper(*a.re, *b.im, path);
    if (!a.re && !b.im) return spring_damper(*b.re, *a.im, path);
    if (!a.im || !a.re) return one_and_general(a, b, path);
    if (!b.im || !b.re) return one_and_general(b, a, path);
    return general(a, b, path);
  }

  [[noreturn]] Value mesh(const Value&, const Value&, const Value&) {
    throw Bug("a series-parallel network has no mesh");
  }

 private:
  std::string write(const char* letter, const std::string& expression, int operations) {
    const std::string name = fmt::format("{}_{}{}", prefix_, letter, ++count_);
    code_.lines.push_back(fmt::format("const T {} = {};", name, expression));
    code_.operations += operations;
    return name;
  }

  Component sum(const Component& a, const Component& b, const char* letter) {
    if (!a || !b) return a ? a : b;
    return write(letter, *a + " + " + *b, 1);
  }

  std::string same_kind(const std::string& a, const std::string& b) {
    return write("r", fmt::format("{0} * {1} / ({0} + {1})", a, b), 3);
  }

  // k i x/(k + i x)
  Value spring_damper(const std::string& k, const std::string& x, int path) {
    const std::string g = write("g", fmt::format("{0} * {1} / ({0} * {0} + {1} * {1})", k, x), 5);
    const std::string re = write("a", g + " * " + x, 1);
    return {re, write("b", g + " * " + k, 1), path + spring_damper_roundings};
  }

  // A spring k in series with a + i b, with t = k + a, r = k/(t^2 + b^2):
  //   Re = r (a t + b^2), Im = r k b.
  // A damper exchanges the roles of a and b, and of Re and Im.
  Value one_and_general(const Value& one, const Value& z, int path) {
    const std::string& k = one.re ? *one.re : *one.im;
    const std::string& a = one.re ? *z.re : *z.im;
    const std::string& b = one.re ? *z.im : *z.re;
    const std::string t = write("t", k + " + " + a, 1);
    const std::string r = write("r", fmt::format("{0} / ({1} * {1} + {2} * {2})", k, t, b), 4);
    const std::string like =
        write("a", fmt::format("{0} * ({1} * {2} + {3} * {3})", r, a, t, b), 4);
    const std::string other = write("b", fmt::format("{} * {} * {}", r, k, b), 2);
    return {one.re ? like : other, one.re ? other : like, path + series_roundings};
  }

  // Re = (a1 |z2|^2 + a2 |z1|^2)/|z1 + z2|^2, Im likewise.
  Value general(const Value& z1, const Value& z2, int path) {
    const std::string s = write("s", *z1.re + " + " + *z2.re, 1);
    const std::string t = write("t", *z1.im + " + " + *z2.im, 1);
    const auto square = [](const std::string& x, const std::string& y) {
      return fmt::format("{0} * {0} + {1} * {1}", x, y);
    };
    const std::string size = write("q", square(s, t), 3);
    const std::string size1 = write("q", square(*z1.re, *z1.im), 3);
    const std::string size2 = write("q", square(*z2.re, *z2.im), 3);
    const auto part = [&](const char* letter, const std::string& x1, const std::string& x2) {
      return write(letter, fmt::format("({} * {} + {} * {}) / {}", x1, size2, x2, size1, size), 4);
    };
    const std::string re = part("a", *z1.re, *z2.re);
    return {re, part("b", *z1.im, *z2.im), path + series_roundings};
  }

  NetworkCode& code_;
  std::string prefix_;
  const SymbolName& symbol_;
  int count_ = 0;
};

/// Code with meshes: every step is an Edge<T>, which carries its own bound.
class MeshWriter {
 public:
  using Value = std::string;

  MeshWriter(NetworkCode& code, const std::string& prefix, const SymbolName& symbol)
      : code_(code), prefix_(prefix), symbol_(symbol) {}

  Value element(const Element& e) {
    const std::string k = symbol_(e.coefficient);
    if (e.kind == ElementKind::spring) return write("spring<T>(" + k + ")", 0);
    if (e.kind == ElementKind::damper) return write("damper(w * " + k + ")", 1);
    return write(fmt::format("maxwell<T>({}, w * {})", k, symbol_(e.time)), 6);
  }
  Value parallel(const Value& a, const Value& b) {
    return write(fmt::format("join({}, {})", a, b), 2);
  }
  Value series(const Value& a, const Value& b) {
    return write(fmt::format("over({0}, {1}, join({0}, {1}))", a, b), 19);
  }
  Value mesh(const Value& a, const Value& b, const Value& total) {
    return write(fmt::format("over({}, {}, {})", a, b, total), 17);
  }

 private:
  std::string write(const std::string& expression, int operations) {
    const std::string name = fmt::format("{}{}", prefix_, ++count_);
    code_.lines.push_back(fmt::format("const Edge<T> {} = {};", name, expression));
    code_.operations += operations;
    return name;
  }

  NetworkCode& code_;
  std::string prefix_;
  const SymbolName& symbol_;
  int count_ = 0;
};

}  // namespace

Roundings operator+(const Roundings& a, const Roundings& b) {
  const bool both = !a.variable.empty() && !b.variable.empty();
  return {a.constant + b.constant, a.variable + (both ? " + " : "") + b.variable};
}

std::string expression(const Roundings& roundings) {
  if (roundings.variable.empty()) return fmt::format("{}.0", roundings.constant);
  if (roundings.constant == 0) return roundings.variable;
  return fmt::format("{} + {}.0", roundings.variable, roundings.constant);
}

NetworkCode network_code(const Reduction& reduction, const std::string& prefix,
                         const SymbolName& symbol) {
  NetworkCode code;
  code.meshed = std::any_of(reduction.steps.begin(), reduction.steps.end(),
                            [](const Step& step) { return step.kind == Step::Kind::mesh; });
  if (code.meshed) {
    MeshWriter writer(code, prefix, symbol);
    const std::string whole = evaluate(reduction, writer);
    code.re = whole + ".re";
    code.im = whole + ".im";
    code.roundings = {0, whole + ".roundings"};
    return code;
  }
  TreeWriter writer(code, prefix, symbol);
  const Value whole = evaluate(reduction, writer);
  code.re = whole.re;
  code.im = whole.im;
  // Rounded up: sqrt(2) < 1.42.
  code.roundings = {static_cast<int>(std::ceil(1.42 * whole.path)), ""};
  return code;
}

}  // namespace vcrit::symbolic
