#include "shortest/proof.hpp"

#include "analysis/residues.hpp"
#include "base/errors.hpp"
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
  explicit DerivedAt(const Point& point) : point_(point) {}

  Number square(const Model& model) const {
    NumberAlgebra<Number> algebra;
    algebra.point = [this](const std::string& name) { return Number(point_(name)); };
    algebra.s = Number({}, Residue(1)) * algebra.point("omega");
    for (const Part& part : model.networks())
      algebra.known[own_name(part.name)] = evaluate(part.network.reduction(), algebra);
    for (const Line& identity : model.identities())
      algebra.known[GiNaC::ex_to<GiNaC::symbol>(identity.left).get_name()] =
          evaluate_rational(identity.right, algebra);
    const Number amplitude = evaluate_rational(model.balance().contact_amplitude, algebra);
    const Number omega = algebra.point("omega");
    return omega * omega * amplitude * conjugate(amplitude);
  }

 private:
  const Point& point_;
};

/// A form at a point. As a residue need not have a root, it is the form's square that is evaluated
/// where there are roots and absolute values.
class FormAt {
 public:
  explicit FormAt(const Point& point) : point_(point) {}

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

  const Point& point_;
  std::map<std::string, Residue> known_;
};

bool same_squares(const ShortestForm& form, const Model& model, const Point& point) {
  FormAt at(point);
  for (const ShortestForm::Definition& definition : form.definitions) at.define(definition);
  return GaussianResidue(at.square(form.velocity)) == DerivedAt(point).square(model);
}

}  // namespace

void prove(const ShortestForm& form, const Model& model) {
  int compared = 0;
  for (std::uint64_t number = 0; number < most_points && compared < points_to_compare; ++number) {
    try {
      ensure(same_squares(form, model, named_point(number)),
             "the shortest form is the derived formula");
      ++compared;
    } catch (const NoInverse&) {
      continue;
    }
  }
  ensure(compared == points_to_compare, "a formula is finite at nearly all points");
}

std::optional<ShortestForm> proved_shortest_form(const Derivation& derivation) {
  std::optional<ShortestForm> form = shortest_form(derivation.problem);
  if (form) prove(*form, *derivation.model);
  return form;
}

}  // namespace vcrit::symbolic
