#include "shortest/storage_loss.hpp"

#include <algorithm>
#include <limits>

#include "formula/algebra_lock.hpp"
#include "formula/names.hpp"
#include "network/reduction.hpp"
#include "shortest/alphabet.hpp"
#include "shortest/complex.hpp"
#include "shortest/proof.hpp"
#include "shortest/search.hpp"

namespace vcrit::symbolic {

namespace {

using namespace shortest;

class WrittenOut {
 public:
  WrittenOut(Alphabet& alphabet, const Thrift& thrift)
      : alphabet_(alphabet),
        all_(alphabet.expressions()),
        complex_(all_),
        presentations_(alphabet.presentations(thrift)) {}

  /// Throws TooLarge.
  ShortestForm form() {
    all_.allow(work_of_beginning);
    return shortest_with_lines(velocities());
  }

  /// K''/K' in steps with K' and K''. Throws TooLarge.
  StorageAndLoss of(const std::string& name, const Network& network) {
    all_.allow(work_of_beginning);
    const ComplexEx k = written_out(name, network);
    const bool finite = !k.re.is_zero();
    ShortestForm form = shortest_with_lines({finite ? all_.divide(k.im, k.re) : k.im});
    const auto alone = [&](const Ex& part) { return alphabet_.written(part).velocity; };
    StorageAndLoss found{std::move(form.definitions), alone(k.re), alone(k.im), std::nullopt};
    if (finite) found.loss_factor = std::move(form.velocity);
    return found;
  }

 private:
  ShortestForm shortest_with_lines(const std::vector<Ex>& starts) {
    all_.allow(2 * search_effort.work);
    std::vector<ExLines> whole;
    for (const Ex& start : starts) {
      whole.emplace_back();
      for (const NamedLine& each : lines_) whole.back().push_back(each.meaning);
      whole.back().push_back(start);
    }
    ExLines best = shortest_of(all_, whole, search_effort);
    for (std::size_t i = 0; i < lines_.size(); ++i) lines_[i].meaning = best[i];
    return alphabet_.written(best.back(), lines_);
  }

  const Parts& parts() const { return alphabet_.parts(); }

  std::vector<Ex> velocities() {
    std::vector<Ex> found = velocities_of_contact();
    if (parts().mount == nullptr) return found;
    const ComplexEx m = written_out("K_m", *parts().mount);
    const auto known = known_network(*parts().normal);
    const ComplexEx n = known ? *known : written_out("K_n", *parts().normal);
    ComplexEx whole = complex_.add(m, n);
    if (parts().mount_mass)
      whole.re =
          all_.subtract(whole.re, all_.multiply(*parts().mount_mass, all_.power(parts().omega, 2)));
    for (Ex& each : found)
      each = all_.product({{each, 1}, {complex_.modulus(m), 1}, {complex_.modulus(whole), -1}});
    return found;
  }

  std::vector<Ex> velocities_of_contact() {
    if (parts().tangential != nullptr) return {all_.multiply(parts().prefactor, own_tangential())};
    if (parts().drive == nullptr) return {all_.multiply(parts().prefactor, parts().ratio)};
    const ComplexEx k = written_out("K_n", *parts().normal), d = drive();
    const Ex under = complex_.modulus(d), g = parts().ratio;
    const Ex first = complex_.modulus(complex_.add(k, complex_.multiply(d, g)));
    const Ex other = complex_.modulus(complex_.add(complex_.multiply(k, all_.power(g, -1)), d));
    return {all_.product({{parts().prefactor, 1}, {first, 1}, {under, -1}}),
            all_.product({{parts().prefactor, 1}, {g, 1}, {other, 1}, {under, -1}})};
  }

  Ex own_tangential() {
    const ComplexEx n = written_out("K_n", *parts().normal),
                    t = written_out("K_t", *parts().tangential);
    const Ex contact = all_.divide(complex_.modulus(n), complex_.modulus(t));
    if (parts().drive == nullptr) return contact;
    const ComplexEx d = drive();
    return all_.product(
        {{contact, 1}, {complex_.modulus(complex_.add(t, d)), 1}, {complex_.modulus(d), -1}});
  }

  /// K_d' - m omega^2 + i K_d''; of springs and dampers side by side Z + i V as elsewhere.
  ComplexEx drive() {
    const auto known = known_network(*parts().drive);
    ComplexEx d = known ? *known : written_out("K_d", *parts().drive);
    if (!parts().mass) return d;
    const bool spring = is_plain_symbol(d.re) && !is_line(d.re);
    const Ex inertia = all_.multiply(*parts().mass, all_.power(parts().omega, 2));
    const Ex z = all_.subtract(d.re, inertia);
    d.re = spring ? all_.named("Z", z, operations(all_, z), false) : z;
    return d;
  }

  std::optional<ComplexEx> known_network(const Network& network) const {
    for (const auto& [known, value] : known_)
      if (*known == network) return value;
    return std::nullopt;
  }

  ComplexEx written_out(const std::string& name, const Network& network) {
    const ComplexEx best = shortest_parts(network);
    const ComplexEx value{named_part(name + "'", best.re), named_part(name + "''", best.im)};
    known_.emplace_back(&network, value);
    return value;
  }

  ComplexEx shortest_parts(const Network& network) {
    ComplexEx best;
    int least = std::numeric_limits<int>::max();
    for (const ComplexQuotient& way : presentations_.of(network))
      for (const ComplexQuotient& each : complex_.cartesians(way)) {
        const int length = operations(all_, ExLines{each.over.re, each.over.im});
        if (length < least) least = length, best = each.over;
      }
    return best;
  }

  bool is_plain_symbol(const Ex& ex) const {
    return ex.factor.is_one() && all_[ex.node].kind == ExpressionKind::symbol &&
           all_.meaning(ex.node).is_zero();
  }

  bool is_line(const Ex& ex) const {
    return std::any_of(lines_.begin(), lines_.end(),
                       [&](const NamedLine& each) { return each.symbol == ex; });
  }

  /// A symbol with a line, but for 0 and what is a symbol anyway.
  Ex named_part(const std::string& name, Ex part) {
    if (part.is_number() || is_plain_symbol(part)) return part;
    if (part.factor.is_one() && all_[part.node].kind == ExpressionKind::symbol)
      part = all_.meaning(part.node);
    for (const NamedLine& each : lines_)
      if (each.meaning == part) return each.symbol;
    const Ex symbol = alphabet_.stiffness(own_name(name), all_.is_positive(part));
    lines_.push_back({symbol, part});
    return symbol;
  }

  Alphabet& alphabet_;
  Expressions& all_;
  ComplexAlgebra complex_;
  Presentations presentations_;
  std::vector<NamedLine> lines_;
  std::vector<std::pair<const Network*, ComplexEx>> known_;
};

/// K(i omega) at a point.
GaussianResidue stiffness_at(const ReducedNetwork& network, const ResiduePoint& point) {
  NumberAlgebra<GaussianResidue> algebra;
  algebra.point = [&point](const std::string& name) { return GaussianResidue(point(name)); };
  algebra.s = GaussianResidue({}, Residue(1)) * algebra.point("omega");
  return evaluate(network.reduction(), algebra);
}

void prove_parts(const StorageAndLoss& found, const ReducedNetwork& network) {
  prove_at_points({found.steps, found.storage, "", 0}, [&](const ResiduePoint& point) {
    const Residue storage = stiffness_at(network, point).re;
    return GaussianResidue(storage * storage);
  });
  prove_at_points({found.steps, found.loss, "", 0}, [&](const ResiduePoint& point) {
    const Residue loss = stiffness_at(network, point).im;
    return GaussianResidue(loss * loss);
  });
}

}  // namespace

std::optional<StorageAndLoss> storage_and_loss_of(const Problem& problem,
                                                  const ReducedNetwork& network,
                                                  const std::string& name) {
  const AlgebraLock lock;
  for (const Thrift& thrift : thrifts) {
    try {
      Alphabet alphabet(problem);
      StorageAndLoss found = WrittenOut(alphabet, thrift).of(name, network.network());
      prove_parts(found, network);
      return found;
    } catch (const TooLarge&) {
      continue;
    }
  }
  return std::nullopt;
}

FoundForm find_storage_loss_form(const Problem& problem) {
  const AlgebraLock lock;
  if (problem->receptance() != nullptr)
    return {{}, "a measured drive has no network, whose storage and loss could be written out"};
  return first_that_fits([&](const Thrift& thrift) -> FoundForm {
    Alphabet alphabet(problem);
    return {WrittenOut(alphabet, thrift).form(), ""};
  });
}

}  // namespace vcrit::symbolic
