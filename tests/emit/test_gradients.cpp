// Partial derivatives of generated evaluators against those of the derived formula with 50 digits.
#include <boost/test/unit_test.hpp>

#include <random>

#include "derivation/scenes.hpp"
#include "emit/library.hpp"
#include "formula/symbols.hpp"
#include "formula/value.hpp"
#include "support/numbers.hpp"

BOOST_AUTO_TEST_SUITE(test_gradients)

using namespace vcrit;
using test::Call;
using test::scene_of;

namespace {

constexpr unsigned seed = 11;

std::vector<Scene> scenes() {
  return {
      test::kelvin_scene(),
      scene_of("normal = \"kn\"\ntangential = \"kt\"", "kd", "m"),
      scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = \"nu\"", "kd | cd", "m"),
      scene_of("normal = \"k0 | (k1 - c1)\"\ntangential = \"kt | (ka - ca)\""),
      scene_of("normal = \"burgers(k1, c1, k2, c2)\"\ntangential_ratio = \"r\"", "k3 - c3", "m"),
      scene_of("normal = \"prony(k0, k, tau, 8)\"\npoisson = 0.45", "kd | cd", "m"),
      scene_of("normal = \"bridge\"\ntangential = \"kt | ct\"", "kd", "m", test::bridge_network),
      test::scene_of_others()};
}

Scene with_values(Scene scene, std::mt19937& random) {
  const auto give = [&](std::optional<double>& value, double from, double to) {
    if (!value) value = std::pow(10, std::uniform_real_distribution(from, to)(random));
  };
  for (auto& [symbol, value] : scene.elements) give(value, -1, 1);
  for (Quantity* quantity :
       {&scene.coefficient, &scene.angular_frequency, &scene.amplitude, &scene.indentation})
    give(quantity->value, -1, 0);
  if (auto* isotropic = std::get_if<Isotropic>(&scene.tangential))
    give(isotropic->quantity.value, -1, -0.4);
  if (scene.mass) give(scene.mass->value, -1, 1);
  return scene;
}

/// d v*/d symbol: by symbolic differentiation where the formula is one expression, else from the
/// change of v* over 1e-40 of the symbol, which a formula with 150 digits shows to 60 or more.
class Exact {
 public:
  Exact(const Scene& shape, const Scene& scene)
      : derivation_(symbolic::derive(shape)), before_(GiNaC::Digits) {
    GiNaC::Digits = 150;
    for (const auto& [symbol, value] : test::numbers_of(scene))
      values_[symbol] = symbolic::exact_binary(value);
  }
  ~Exact() { GiNaC::Digits = before_; }
  Exact(const Exact&) = delete;
  Exact& operator=(const Exact&) = delete;

  GiNaC::numeric partial(const Symbol& symbol) const {
    if (derivation_.definitions.empty()) {
      const GiNaC::ex derivative = derivation_.critical_velocity.diff(GiNaC::ex_to<GiNaC::symbol>(
          symbol.name == "nu" ? symbolic::poisson_ratio(symbol) : symbolic::symbol(symbol)));
      return symbolic::value_at(derivative, {}, values_);
    }
    const GiNaC::numeric step =
        values_.at(symbol).mul(GiNaC::numeric(10).power(GiNaC::numeric(-40)));
    auto above = values_, below = values_;
    above[symbol] += step;
    below[symbol] -= step;
    return (velocity(above) - velocity(below)).div(step.mul(2));
  }
  GiNaC::numeric velocity() const { return velocity(values_); }

 private:
  GiNaC::numeric velocity(const std::map<Symbol, GiNaC::numeric>& values) const {
    return symbolic::value_at(derivation_.critical_velocity, derivation_.definitions, values);
  }

  symbolic::Derivation derivation_;
  long before_;
  std::map<Symbol, GiNaC::numeric> values_;
};

std::vector<Symbol> member_symbols(const Scene& shape) {
  const symbolic::ParameterList parameters(shape, symbolic::derive(shape));
  std::vector<Symbol> symbols;
  for (const symbolic::Member& member : parameters.members())
    for (int entry = member.length == 0 ? 0 : 1; entry <= member.length; ++entry)
      symbols.push_back({member.name, entry});
  return symbols;
}

}  // namespace

BOOST_AUTO_TEST_CASE(partial_derivatives_of_both_grades) {
  BOOST_TEST_MESSAGE("seed " << seed);
  const test::Libraries libraries(scenes(), test::Asked::values_and_gradients);
  std::mt19937 random(seed);
  std::vector<Call> calls;
  for (std::size_t i = 0; i < libraries.size(); ++i)
    for (int n = 0; n < 5; ++n) {
      Call call;
      call.library = i;
      call.scene = with_values(libraries.scene(i), random);
      calls.push_back(std::move(call));
    }
  BOOST_REQUIRE_EQUAL(libraries.compile(test::compilers(libraries.folder()).front(), {"-O1"}), "");
  libraries.evaluate(calls);
  for (const Call& call : calls) {
    const Scene& shape = libraries.scene(call.library);
    const Exact exact(shape, call.scene);
    const std::vector<Symbol> symbols = member_symbols(shape);
    BOOST_REQUIRE(symbols.size() == call.partials.size());
    const Values values = test::numbers_of(call.scene);
    const double v = exact.velocity().to_double();
    for (std::size_t i = 0; i < symbols.size(); ++i) {
      // Terms of about the size of v*/x, times 1/|D| or 1/|N| near resonance (here above 1e-3 of
      // their parts, as values lie within two decades), cancel. Their sum errs by some hundred
      // roundings of them: 2^-102 in the accurate grade, far below the last rounding to a double;
      // 2^-53 in the fast one.
      const double expected = exact.partial(symbols[i]).to_double();
      const double scale = std::abs(expected) + std::abs(v / values.at(symbols[i]));
      BOOST_TEST_CONTEXT("scene " << call.library << ", " << to_text(symbols[i])) {
        BOOST_TEST(std::abs(call.partials[i] - expected) <=
                   0x1p-52 * std::abs(expected) + 1e-25 * scale);
        BOOST_TEST(std::abs(call.fast_partials[i] - expected) <= 1e-11 * scale);
      }
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
