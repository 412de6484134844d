#include "analysis/rational_lines.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "formula/form.hpp"
#include "formula/names.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

namespace {

using GiNaC::ex;

// Terms of a polynomial whose factors are found in some tenth of a second.
constexpr std::size_t most_factored = 400;

// Terms of a factor that stands as it is.
constexpr std::size_t short_factor = 3;

// Terms of polynomials that are written in three ways in some tenths of a second; GiNaC's sums, not
// FLINT's products, take the time.
constexpr std::size_t most_written_thrice = 3000;

using Polynomials = std::map<unsigned long, Polynomial>;

/// The polynomial's coefficients of the powers of a variable.
Polynomials by_powers(const Polynomial& polynomial, const std::string& variable) {
  const std::size_t at = polynomial.ring().index(variable);
  Polynomials result;
  for (std::size_t i = 0; i < polynomial.terms(); ++i) {
    std::vector<unsigned long> exponents = polynomial.exponents(i);
    const unsigned long power = std::exchange(exponents[at], 0);
    result.try_emplace(power, polynomial.ring(), 0)
        .first->second.add_term(polynomial.coefficient(i), exponents);
  }
  return result;
}

FactoredPolynomial factors_of(const Polynomial& polynomial) {
  if (polynomial.terms() <= most_factored) return polynomial_factors(polynomial);
  return {"1", {{polynomial, 1}}};
}

ex factored_expression(const Polynomial& polynomial) {
  const FactoredPolynomial product = factors_of(polynomial);
  ex result = GiNaC::numeric(product.constant.c_str());
  for (const auto& [factor, exponent] : product.factors)
    result *= GiNaC::pow(expression(factor), static_cast<int>(exponent));
  return result;
}

int operations_in_lines(const std::vector<Line>& lines) {
  int sum = 0;
  for (const Line& line : lines)
    sum += operations_in(form_of(line.left).form) + operations_in(form_of(line.right).form);
  return sum;
}

/// The ways to write polynomials in which m occurs as m omega^2 alone.
enum class Way { plain, stiffness, ratio };

/// Polynomials of one ring in the variables of a way.
class InOtherVariables {
 public:
  InOtherVariables(const Ring& ring, Way way, const Swinging* swinging)
      : from_(ring), way_(way), swinging_(swinging), ring_(names(ring, way)) {}

  /// Z or beta as it is written.
  std::string name() const { return way_ == Way::stiffness ? "Z" : "beta"; }
  const Ring& ring() const { return ring_; }

  /// Nothing where m occurs in another way.
  std::optional<Polynomial> operator()(const Polynomial& polynomial) const {
    if (way_ == Way::plain) return polynomial;
    const std::size_t mass = from_.index(swinging_->mass), omega = from_.index("omega");
    Polynomials by_mass;
    for (std::size_t i = 0; i < polynomial.terms(); ++i) {
      std::vector<unsigned long> exponents = polynomial.exponents(i);
      const unsigned long power = std::exchange(exponents[mass], 0);
      if (exponents[omega] < 2 * power) return std::nullopt;
      exponents[omega] -= 2 * power;
      exponents.push_back(0);
      by_mass.try_emplace(power, ring_, 0)
          .first->second.add_term(polynomial.coefficient(i), exponents);
    }
    // Horner's scheme: a product for each power, not for each term.
    const Polynomial inertia = mass_times_square();
    Polynomial result(ring_, 0);
    for (unsigned long power = by_mass.empty() ? 0 : by_mass.rbegin()->first + 1; power-- > 0;) {
      result *= inertia;
      if (const auto known = by_mass.find(power); known != by_mass.end()) result += known->second;
    }
    return result;
  }

 private:
  static std::vector<std::string> names(const Ring& ring, Way way) {
    std::vector<std::string> all = ring.names();
    if (way != Way::plain) all.push_back(own_name(way == Way::stiffness ? "Z" : "beta"));
    return all;
  }

  /// m omega^2 = k_d - Z = beta k_d
  Polynomial mass_times_square() const {
    const Polynomial spring = Polynomial::variable(ring_, swinging_->spring);
    const Polynomial other = Polynomial::variable(ring_, own_name(name()));
    if (way_ == Way::ratio) return other * spring;
    Polynomial result = spring;
    result -= other;
    return result;
  }

  const Ring& from_;
  Way way_;
  const Swinging* swinging_;
  Ring ring_;
};

/// The line of Z or beta, of positive or signed value as the formula has it.
Line meaning_of(Way way, const Swinging& swinging) {
  const ex spring = symbol({swinging.spring}),
           inertia = symbol({swinging.mass}) * GiNaC::pow(omega(), 2);
  if (way == Way::stiffness) return {"", real_quantity("Z"), spring - inertia};
  return {"", quantity("beta"), inertia / spring};
}

/// Writes polynomials as products whose long factors have names.
class FactorWriter {
 public:
  explicit FactorWriter(std::string by) : by_(std::move(by)) {}

  /// `words` in front of the first line of a name.
  ex write(const Polynomial& polynomial, const std::string& name, const std::string& coefficient,
           const std::string& words) {
    const FactoredPolynomial product = factors_of(polynomial);
    const auto is_long = [](const auto& factor) { return factor.first.terms() > short_factor; };
    const auto named = std::count_if(product.factors.begin(), product.factors.end(), is_long);
    ex result = GiNaC::numeric(product.constant.c_str());
    int number = 0;
    for (const auto& [factor, exponent] : product.factors) {
      const std::string index = named > 1 ? std::to_string(++number) : "";
      const ex value = !is_long(std::pair(factor, exponent))
                           ? expression(factor)
                           : named_line(factor, name + index, coefficient + index, words);
      result *= GiNaC::pow(value, static_cast<int>(exponent));
    }
    return result;
  }

  /// The variable by whose powers the polynomial is written.
  std::string variable(const Polynomial& polynomial) const {
    return polynomial.degree("omega") > 0 || by_.empty() ? "omega" : own_name(by_);
  }

  ex sum(const Polynomial& polynomial, const std::string& coefficient) {
    const std::string name = variable(polynomial);
    const ex unknown = name == "omega" ? omega() : by_ == "Z" ? real_quantity(by_) : quantity(by_);
    ex result = 0;
    std::vector<Line> coefficients;
    for (const auto& [power, value] : by_powers(polynomial, name)) {
      const ex k = quantity(coefficient + "_" + std::to_string(power));
      const bool named = value.terms() > 1;
      if (named) coefficients.push_back({"", k, factored_expression(value)});
      result += (named ? k : expression(value)) * GiNaC::pow(unknown, static_cast<int>(power));
    }
    lines.insert(lines.end(), coefficients.begin(), coefficients.end());
    return result;
  }

  std::vector<Line> lines;

 private:
  ex named_line(const Polynomial& factor, const std::string& name, const std::string& coefficient,
                const std::string& words) {
    const std::size_t at = lines.size();
    const ex value = sum(factor, coefficient);
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(at), {words, quantity(name), value});
    return quantity(name);
  }

  std::string by_;
};

using LineWriter = std::function<std::vector<Line>(const InOtherVariables&, const std::string& by)>;

/// The lines of one way; none where it does not suit the polynomials.
std::vector<Line> lines_in(const InOtherVariables& other, Way way, const Swinging* swinging,
                           const LineWriter& write) {
  std::vector<Line> lines = write(other, way == Way::plain ? "" : other.name());
  if (way != Way::plain && !lines.empty())
    lines.insert(lines.begin() + 1, meaning_of(way, *swinging));
  return lines;
}

/// The way in which the polynomials have the fewest terms.
Way way_of_fewest_terms(const std::vector<const Polynomial*>& polynomials,
                        const Swinging* swinging) {
  std::pair best(std::numeric_limits<std::size_t>::max(), Way::plain);
  for (const Way way : {Way::plain, Way::stiffness, Way::ratio}) {
    const InOtherVariables other(polynomials.front()->ring(), way, swinging);
    std::size_t terms = 0;
    for (const Polynomial* polynomial : polynomials) {
      const std::optional<Polynomial> written = other(*polynomial);
      terms = written ? terms + written->terms() : best.first;
      if (terms >= best.first) break;
    }
    if (terms < best.first) best = {terms, way};
  }
  return best.second;
}

/// The polynomials in the shortest of the ways in which `write` gives lines. Long ones are written
/// once: their terms alone decide.
std::vector<Line> shortest_way(const std::vector<const Polynomial*>& polynomials,
                               const std::optional<Swinging>& given, const LineWriter& write) {
  const Ring& ring = polynomials.front()->ring();
  const bool swings = given && ring.holds(given->mass) && ring.holds(given->spring);
  const Swinging* const swinging = swings ? &*given : nullptr;
  std::vector<Way> ways{Way::plain};
  if (swings) ways.insert(ways.end(), {Way::stiffness, Way::ratio});
  std::size_t terms = 0;
  for (const Polynomial* polynomial : polynomials) terms += polynomial->terms();
  if (swings && terms > most_written_thrice) ways = {way_of_fewest_terms(polynomials, swinging)};
  std::vector<Line> best;
  int least = 0;
  for (const Way way : ways) {
    const InOtherVariables other(ring, way, swinging);
    std::vector<Line> lines = lines_in(other, way, swinging, write);
    if (lines.empty()) continue;
    const int length = operations_in_lines(lines);
    if (!best.empty() && length >= least) continue;
    least = length, best = std::move(lines);
  }
  return best;
}

std::vector<Line> square_lines(const RationalForm& form, const InOtherVariables& in,
                               const std::string& by) {
  const auto& [over, under] = form.square;
  const unsigned long above = over.lowest_degree("omega"), below = under.lowest_degree("omega");
  const auto first = in(over.without_power("omega", above)),
             second = in(under.without_power("omega", below));
  if (!first || !second) return {};
  FactorWriter writer(by);
  const ex n = writer.write(*first, "N", "n", "Numerator");
  const ex d = writer.write(*second, "D", "d", "Denominator");
  const int power = static_cast<int>(above) - static_cast<int>(below);
  const ex square =
      GiNaC::pow(symbol({"mu0"}) * symbol({"du_z"}), 2) * GiNaC::pow(omega(), power) * n / d;
  std::vector<Line> lines{{{"As a rational function of ", ex(GiNaC::pow(omega(), 2))},
                           GiNaC::pow(quantity("v*"), 2),
                           square}};
  lines.insert(lines.end(), writer.lines.begin(), writer.lines.end());
  return lines;
}

/// With the sign that the coefficient of the lowest power is printed without a minus.
Polynomial begins_with_plus(const Polynomial& polynomial, const FactorWriter& writer) {
  const Polynomials coefficients = by_powers(polynomial, writer.variable(polynomial));
  const bool minus = leads_with_minus(factored_expression(coefficients.begin()->second));
  return minus ? Polynomial(polynomial.ring(), -1) * polynomial : polynomial;
}

/// Whether all coefficients are of one sign: no root where all symbols are positive.
bool has_one_sign(const Polynomial& polynomial) {
  std::size_t negative = 0;
  for (std::size_t i = 0; i < polynomial.terms(); ++i)
    negative += polynomial.coefficient(i).starts_with('-') ? 1 : 0;
  return negative == 0 || negative == polynomial.terms();
}

/// Roots are those of the factors that hold the frequency.
std::vector<Line> root_lines(const Polynomial& slope, const InOtherVariables& in,
                             const std::string& by) {
  const std::optional<Polynomial> whole = in(slope);
  if (!whole) return {};
  FactorWriter writer(by);
  const FactoredPolynomial product = factors_of(*whole);
  std::vector<const Polynomial*> factors;
  for (const auto& [factor, exponent] : product.factors) {
    const bool holds =
        factor.degree("omega") > 0 || (!by.empty() && factor.degree(own_name(by)) > 0);
    if (holds && factor.terms() > 1) factors.push_back(&factor);
  }
  ex left = 1;
  const bool alone = factors.size() == 1;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const std::string letter = alone ? "a" : "a" + std::to_string(i + 1);
    left *= factors[i]->terms() <= short_factor
                ? expression(*factors[i])
                : writer.sum(begins_with_plus(*factors[i], writer), letter);
  }
  std::vector<Line> lines{
      {{quantity("v*"), " has its extrema, at frequencies above 0, where"}, left, 0}};
  lines.insert(lines.end(), writer.lines.begin(), writer.lines.end());
  return lines;
}

}  // namespace

std::optional<Swinging> swinging(const Problem& problem) {
  if (!problem->mass || problem->drive_network() == nullptr) return std::nullopt;
  const Network& drive = problem->drive_network()->network();
  const auto* parallel = std::get_if<Parallel>(&drive.form);
  std::vector<std::string> springs;
  for (const Network& part : parallel != nullptr ? parallel->parts : std::vector{drive}) {
    const auto* element = std::get_if<Element>(&part.form);
    if (element != nullptr && element->kind == ElementKind::spring)
      springs.push_back(to_text(element->coefficient));
  }
  if (springs.size() != 1) return std::nullopt;
  return Swinging{to_text(problem->mass->symbol), springs.front()};
}

std::optional<Line> ratio_line(const Problem& problem) {
  const auto* isotropic = std::get_if<Isotropic>(&problem->tangential);
  if (isotropic == nullptr) return std::nullopt;
  const bool known = isotropic->quantity.value.has_value();
  if (known ? problem->rigid() : isotropic->by != Isotropic::By::poisson) return std::nullopt;
  const ex ratio = isotropic_ratio(*isotropic);
  if (ratio.is_equal(1)) return std::nullopt;
  return Line{"", positive_quantity("g"), (1 / ratio).normal()};
}

Change in_ratio(const Problem& problem) {
  Change change;
  if (ratio_line(problem)) change.ratio = 1 / positive_quantity("g");
  return change;
}

ex expression(const Polynomial& polynomial) {
  std::vector<ex> variables;
  for (const std::string& name : polynomial.ring().names())
    variables.push_back(name == own_name("g")   ? positive_quantity("g")
                        : name == own_name("Z") ? real_quantity("Z")
                        : is_own(name)          ? quantity(base_name(name))
                                                : symbol({name}));
  GiNaC::exvector terms;
  for (std::size_t i = 0; i < polynomial.terms(); ++i) {
    ex term = GiNaC::numeric(polynomial.coefficient(i).c_str());
    const auto exponents = polynomial.exponents(i);
    for (std::size_t v = 0; v < variables.size(); ++v)
      if (exponents[v] > 0) term *= GiNaC::pow(variables[v], static_cast<int>(exponents[v]));
    terms.push_back(term);
  }
  return GiNaC::add(terms);
}

std::vector<Line> lines_of(const RationalForm& form, const std::optional<Swinging>& swinging) {
  return shortest_way({&form.square.over, &form.square.under}, swinging,
                      [&](const InOtherVariables& in, const std::string& by) {
                        return square_lines(form, in, by);
                      });
}

std::vector<Line> extrema_lines_of(const RationalForm& form,
                                   const std::optional<Swinging>& swinging) {
  const Polynomial slope = stationary(form);
  if (slope.degree("omega") == 0 || has_one_sign(slope)) return {};
  return shortest_way({&slope}, swinging, [&](const InOtherVariables& in, const std::string& by) {
    return root_lines(slope, in, by);
  });
}

}  // namespace vcrit::symbolic
