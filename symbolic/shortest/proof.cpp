#include "shortest/proof.hpp"

#include "analysis/residues.hpp"
#include "base/errors.hpp"
#include "formula/form.hpp"
#include "formula/rational.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

namespace {

constexpr int points_to_compare = 3;
// Nobody divides by 0 at so many.
constexpr std::uint64_t most_points = 100;

using Number = GaussianResidue;

/// v*^2 of the derivation at a point.
class DerivedAt {
 public:
  explicit DerivedAt(const ResiduePoint& point) : point_(point) {}

  Number square(const SymbolicModel& model) const {
    NumberAlgebra<Number> algebra;
    algebra.point = [this](const std::string& name) { return Number(point_(name)); };
    algebra.s = Number({}, Residue(1)) * algebra.point("omega");
    for (const NamedNetwork& part : model.networks())
      algebra.known[own_name(part.name)] = evaluate(part.network.reduction(), algebra);
    for (const Line& identity : model.identities())
      algebra.known[GiNaC::ex_to<GiNaC::symbol>(identity.left).get_name()] =
          evaluate_rational(identity.right, algebra);
    const Number amplitude = evaluate_rational(model.balance().contact_amplitude, algebra);
    const Number omega = algebra.point("omega");
    return omega * omega * amplitude * conjugate(amplitude);
  }

 private:
  const ResiduePoint& point_;
};

/// A form at a point. As a residue need not have a root, it is the form's square that is evaluated
/// where there are roots and absolute values.
class FormAt {
 public:
  explicit FormAt(const ResiduePoint& point) : point_(point) {}

  void define(const Line& group) {
    const NumberAlgebra<Residue> algebra{point_, {}};
    known_[GiNaC::ex_to<GiNaC::symbol>(group.left).get_name()] =
        evaluate_rational(group.right, algebra);
  }

  void define(const ShortestForm::Definition& definition) {
    known_[definition.name.text] = value(definition.meaning);
  }

  Residue square(const Form& form) const {
    switch (form.kind) {
      case Form::Kind::root:
        return value(form.over[0]);
      case Form::Kind::call: {
        const Residue inside = value(form.terms[0].form);
        return inside * inside;
      }
      case Form::Kind::power:
        return power(square(form.over[0]), static_cast<std::uint64_t>(form.exponent));
      case Form::Kind::product: {
        Residue over(1), under(1);
        for (const Form& factor : form.over) over = over * square(factor);
        for (const Form& factor : form.under) under = under * square(factor);
        return over * inverse(under);
      }
      default:
        break;
    }
    const Residue plain = value(form);
    return plain * plain;
  }

 private:
  Residue value(const Form& form) const {
    switch (form.kind) {
      case Form::Kind::number:
        return Residue(GiNaC::numeric(form.text.c_str()));
      case Form::Kind::name: {
        const auto known = known_.find(form.text);
        return known == known_.end() ? point_(form.text) : known->second;
      }
      case Form::Kind::sum: {
        Residue sum;
        for (const Signed& term : form.terms) {
          const Residue each = value(term.form);
          sum = sum + (term.minus ? -each : each);
        }
        return sum;
      }
      case Form::Kind::product: {
        Residue over(1), under(1);
        for (const Form& factor : form.over) over = over * value(factor);
        for (const Form& factor : form.under) under = under * value(factor);
        return over * inverse(under);
      }
      case Form::Kind::power:
        return power(value(form.over[0]), static_cast<std::uint64_t>(form.exponent));
      default:
        break;
    }
    throw Bug("roots are factors of v* alone");
  }

  const ResiduePoint& point_;
  std::map<std::string, Residue> known_;
};

/// A rational function of names that are defined, at a point.
struct DefinedAlgebra {
  using Value = Residue;
  const ResiduePoint& point;
  const std::vector<Line>& definitions;

  Value number(const GiNaC::numeric& value) const { return Residue(value); }
  Value name(const std::string& name) const {
    for (const Line& line : definitions)
      if (GiNaC::is_a<GiNaC::symbol>(line.left) &&
          GiNaC::ex_to<GiNaC::symbol>(line.left).get_name() == name)
        return evaluate_rational(line.right, *this);
    return point(name);
  }
  Value add(Value a, Value b) const { return a + b; }
  Value multiply(Value a, Value b) const { return a * b; }
  Value invert(Value a) const { return inverse(a); }
};

using SquareAt = std::function<GaussianResidue(const ResiduePoint&)>;

void compare_at_points(const SquareAt& printed, const SquareAt& derived) {
  int compared = 0;
  for (std::uint64_t number = 0; number < most_points && compared < points_to_compare; ++number) {
    const ResiduePoint point = named_point(number);
    try {
      ensure(printed(point) == derived(point), "what is printed is the derived formula");
      ++compared;
    } catch (const NoInverse&) {
      continue;
    }
  }
  ensure(compared == points_to_compare, "a formula is finite at nearly all points");
}

SquareAt derived_square(const SymbolicModel& model) {
  return [&model](const ResiduePoint& point) { return DerivedAt(point).square(model); };
}

SquareAt printed_square(const ShortestForm& form, const std::vector<Line>& groups) {
  return [&form, &groups](const ResiduePoint& point) {
    FormAt at(point);
    for (const Line& group : groups) at.define(group);
    for (const ShortestForm::Definition& definition : form.definitions) at.define(definition);
    return at.square(form.velocity);
  };
}

}  // namespace

void prove(const ShortestForm& form, const SymbolicModel& model, const std::vector<Line>& groups) {
  compare_at_points(printed_square(form, groups), derived_square(model));
}

void prove(const GiNaC::ex& velocity, const SymbolicModel& model) {
  const Form form = form_of(velocity).form;
  compare_at_points([&form](const ResiduePoint& point) { return FormAt(point).square(form); },
                    derived_square(model));
}

void prove_square(const GiNaC::ex& square, const std::vector<Line>& definitions,
                  const SymbolicModel& model) {
  compare_at_points(
      [&](const ResiduePoint& point) {
        return evaluate_rational(square, DefinedAlgebra{point, definitions});
      },
      derived_square(model));
}

void prove_at_points(const ShortestForm& form, const SquareAt& square) {
  compare_at_points(printed_square(form, {}), square);
}

FoundForm proved(FoundForm found, const Derivation& derivation, const std::vector<Line>& groups) {
  if (found.form) prove(*found.form, *derivation.model, groups);
  return found;
}

std::optional<ShortestForm> proved_shortest_form(const Derivation& derivation) {
  return proved(find_shortest_form(derivation.problem), derivation).form;
}

}  // namespace vcrit::symbolic
