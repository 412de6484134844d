#include "scaling/libraries.hpp"

#include <flint/fmpz_mpoly.h>
#include <ginac/ginac.h>

#include <algorithm>
#include <map>
#include <memory>

#include "network/reduction.hpp"

namespace vcrit::scaling {

namespace {

using GiNaC::ex;

class Symbols {
 public:
  const ex& operator[](const std::string& name) {
    return known_.try_emplace(name, GiNaC::symbol(name)).first->second;
  }
  /// Of "k1*tau1*s".
  ex product(const std::string& text) {
    ex result = 1;
    std::size_t from = 0;
    while (from <= text.size()) {
      const std::size_t to = std::min(text.find('*', from), text.size());
      result *= (*this)[text.substr(from, to - from)];
      from = to + 1;
    }
    return result;
  }

 private:
  std::map<std::string, ex> known_;
};

bool has_graph(const ScalingCase& each) {
  for (const Step& step : reduce(each.network).steps)
    if (step.kind == Step::Kind::mesh) return true;
  return false;
}

struct Composition {
  using Value = ex;
  Symbols& symbols;
  ex element(const Element& e) const {
    const ex k = symbols[to_text(e.coefficient)], s = symbols["s"];
    if (e.kind == ElementKind::spring) return k;
    if (e.kind == ElementKind::damper) return k * s;
    const ex turn = symbols[to_text(e.second)] * s;
    return k * turn / (1 + turn);
  }
  static ex parallel(const ex& a, const ex& b) { return a + b; }
  static ex series(const ex& a, const ex& b) { return 1 / (1 / a + 1 / b); }
  static ex mesh(const ex& a, const ex& b, const ex& total) { return a * b / total; }
};

GiNaC::matrix nodal(const Wiring& wiring, Symbols& symbols) {
  const auto n = static_cast<unsigned>(wiring.nodes);
  GiNaC::matrix k(n, n);
  for (const Wiring::Edge& edge : wiring.edges) {
    const auto from = static_cast<unsigned>(edge.from), to = static_cast<unsigned>(edge.to);
    const ex stiffness = symbols.product(edge.stiffness);
    k(from, from) += stiffness;
    k(to, to) += stiffness;
    k(from, to) -= stiffness;
    k(to, from) -= stiffness;
  }
  return k;
}

GiNaC::matrix without_first(const GiNaC::matrix& k, unsigned first) {
  const unsigned n = k.rows() - first;
  return GiNaC::ex_to<GiNaC::matrix>(GiNaC::sub_matrix(k, first, n, first, n));
}

// Terminal 1 is held: it goes to the front of the numbering.
GiNaC::matrix held_first(const GiNaC::matrix& k) {
  GiNaC::matrix result = k;
  const unsigned n = k.rows();
  const auto turned = [](unsigned i) { return i < 2 ? 1 - i : i; };
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j) result(i, j) = k(turned(i), turned(j));
  return result;
}

// fmpz_mpoly by hand, freed at the end.
class Polynomials {
 public:
  explicit Polynomials(const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < names.size(); ++i) index_[names[i]] = static_cast<slong>(i);
    fmpz_mpoly_ctx_init(context, static_cast<slong>(names.size()), ORD_LEX);
  }
  ~Polynomials() {
    for (auto& value : values_) fmpz_mpoly_clear(value.get(), context);
    fmpz_mpoly_ctx_clear(context);
  }
  Polynomials(const Polynomials&) = delete;
  Polynomials& operator=(const Polynomials&) = delete;

  using Value = fmpz_mpoly_struct*;
  Value make(long constant = 0) {
    values_.push_back(std::make_unique<fmpz_mpoly_struct>());
    fmpz_mpoly_init(values_.back().get(), context);
    fmpz_mpoly_set_si(values_.back().get(), constant, context);
    return values_.back().get();
  }
  Value variable(const std::string& name) {
    const Value value = make();
    fmpz_mpoly_gen(value, index_.at(name), context);
    return value;
  }
  Value add(Value a, Value b) {
    const Value c = make();
    fmpz_mpoly_add(c, a, b, context);
    return c;
  }
  Value multiply(Value a, Value b) {
    const Value c = make();
    fmpz_mpoly_mul(c, a, b, context);
    return c;
  }

  fmpz_mpoly_ctx_t context;

 private:
  std::map<std::string, slong> index_;
  std::vector<std::unique_ptr<fmpz_mpoly_struct>> values_;
};

struct Fractions {
  struct Value {
    Polynomials::Value over, under;
  };
  Polynomials& ring;
  Value element(const Element& e) {
    const auto k = ring.variable(to_text(e.coefficient));
    if (e.kind == ElementKind::spring) return {k, ring.make(1)};
    if (e.kind == ElementKind::damper) return {ring.multiply(k, ring.variable("s")), ring.make(1)};
    const auto turn = ring.multiply(ring.variable(to_text(e.second)), ring.variable("s"));
    return {ring.multiply(k, turn), ring.add(turn, ring.make(1))};
  }
  Value parallel(const Value& a, const Value& b) {
    return {ring.add(ring.multiply(a.over, b.under), ring.multiply(b.over, a.under)),
            ring.multiply(a.under, b.under)};
  }
  Value series(const Value& a, const Value& b) {
    return {ring.multiply(a.over, b.over),
            ring.add(ring.multiply(a.over, b.under), ring.multiply(b.over, a.under))};
  }
  Value mesh(const Value&, const Value&, const Value&) { return {}; }
};

std::vector<std::string> names_of(const ScalingCase& each) {
  std::vector<std::string> names{"s"};
  for (const Symbol& symbol : symbols_of(each.network)) names.push_back(to_text(symbol));
  return names;
}

}  // namespace

std::optional<double> ginac_composed(const ScalingCase& each) {
  if (has_graph(each)) return std::nullopt;
  const Reduction reduction = reduce(each.network);
  return seconds_of([&] {
    Symbols symbols;
    Composition composition{symbols};
    evaluate(reduction, composition);
  });
}

std::optional<double> ginac_lsolve(const ScalingCase& each) {
  const Wiring wires = wiring(each.network);
  return seconds_of([&] {
    Symbols symbols;
    const GiNaC::matrix k = nodal(wires, symbols);
    GiNaC::lst equations, unknowns;
    std::vector<ex> u{1, 0};
    for (std::size_t i = 2; i < wires.nodes; ++i) {
      u.push_back(symbols["u" + std::to_string(i)]);
      unknowns.append(u.back());
    }
    const auto force = [&](unsigned i) {
      ex sum = 0;
      for (unsigned j = 0; j < wires.nodes; ++j) sum += k(i, j) * u[j];
      return sum;
    };
    for (unsigned i = 2; i < wires.nodes; ++i) equations.append(force(i) == 0);
    const ex solution = GiNaC::lsolve(equations, unknowns);
    force(0).subs(solution).normal();
  });
}

std::optional<double> ginac_determinant(const ScalingCase& each) {
  const Wiring wires = wiring(each.network);
  return seconds_of([&] {
    Symbols symbols;
    const GiNaC::matrix k = held_first(nodal(wires, symbols));
    const ex over = without_first(k, 1).determinant().expand();
    const ex under = wires.nodes == 2 ? ex(1) : without_first(k, 2).determinant().expand();
    (void)(over / under);
  });
}

std::optional<double> flint_by_hand(const ScalingCase& each) {
  if (has_graph(each)) return std::nullopt;
  const Reduction reduction = reduce(each.network);
  const std::vector<std::string> names = names_of(each);
  return seconds_of([&] {
    Polynomials ring(names);
    Fractions fractions{ring};
    evaluate(reduction, fractions);
  });
}

}  // namespace vcrit::scaling
