#include "emit/evaluation_code.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>

#include "base/numbers.hpp"
#include "emit/network_code.hpp"
#include "formula/symbols.hpp"
#include "network/reduction.hpp"

namespace vcrit::symbolic {

namespace {

using Component = std::optional<std::string>;

/// K_t/K_n of an isotropic contact as an expression of type T, and its roundings.
struct RatioCode {
  std::string expression;
  int roundings = 1;
};

/// A number as high + low, twice the digits of a double.
std::string literal(const GiNaC::numeric& value) {
  const double high = value.to_double();
  const double low = (value - exact_binary(high)).to_double();
  const auto text = [](double x) {
    const std::string digits = to_text(x);
    return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
  };
  return low == 0 ? "T(" + text(high) + ")" : fmt::format("(T({}) + {})", text(high), text(low));
}

RatioCode ratio_code(const Isotropic& isotropic, const ParameterList& parameters) {
  const bool poisson = isotropic.by == Isotropic::By::poisson;
  if (isotropic.quantity.value) {
    // What the program's other commands compute with: the double that was read.
    const GiNaC::numeric given = exact_binary(*isotropic.quantity.value);
    return {literal(poisson ? 2 * (1 - given) / (2 - given) : given), 1};
  }
  const std::string symbol = parameters.reference(isotropic.quantity.symbol);
  if (!poisson) return {"T(" + symbol + ")", 0};
  return {fmt::format("(2.0 * (1.0 - T({0})) / (2.0 - T({0})))", symbol), 4};
}

/// One complex quantity of the formula, in the first quadrant unless it comes from a mesh or has
/// the inertia in it.
struct Quantity {
  Component re, im;
  Roundings roundings;
};

std::string square(const Quantity& k) {
  const auto times_itself = [](const std::string& x) { return fmt::format("{0} * {0}", x); };
  if (!k.im) return times_itself(*k.re);
  if (!k.re) return times_itself(*k.im);
  return times_itself(*k.re) + " + " + times_itself(*k.im);
}

class Writer {
 public:
  Writer(const Scene& scene, const ParameterList& parameters)
      : scene_(scene), parameters_(parameters) {}

  EvaluationCode write() {
    code_.has_mass = scene_.mass.has_value();
    for (const char* name : {"p.mu0", "p.omega", "p.du_z"}) code_.ranges.emplace_back(name);
    say("const T w(p.omega);");
    const auto* isotropic = std::get_if<Isotropic>(&scene_.tangential);
    if (isotropic != nullptr) write_ratio(*isotropic);
    if (scene_.drive)
      with_drive(isotropic != nullptr);
    else if (isotropic != nullptr)
      finish("", {constant_roundings + ratio_roundings_, ""});
    else
      without_drive();
    return std::move(code_);
  }

 private:
  // Roundings of what follows the networks: the four squares 4, quotients and their product 1.5,
  // the root 1, mu0 omega du_z and its product 3; with the ratio one more. Rounded up.
  static constexpr int constant_roundings = 11;
  // D = K_d - m omega^2 itself 3, and N as many.
  static constexpr int difference_roundings = 6;

  void say(const std::string& line, int operations = 0) {
    code_.lines.push_back(line);
    code_.operations += operations;
  }

  void write_ratio(const Isotropic& isotropic) {
    const RatioCode ratio = ratio_code(isotropic, parameters_);
    say("const T ratio = " + ratio.expression + ";", ratio.roundings);
    ratio_roundings_ = ratio.roundings;
    if (isotropic.quantity.value) {
      code_.ranges.push_back(to_text(tangential_ratio(isotropic)));
      return;
    }
    const std::string symbol = parameters_.reference(isotropic.quantity.symbol);
    const bool poisson = isotropic.by == Isotropic::By::poisson;
    code_.ranges.push_back(poisson ? "1.0 - " + symbol : symbol);
    if (poisson) code_.ranges.push_back("1.0 + " + symbol);
  }

  Quantity network(const Network& network, const std::string& prefix) {
    const NetworkCode code = network_code(reduce(network), prefix, [this](const Symbol& symbol) {
      return parameters_.reference(symbol);
    });
    for (const std::string& line : code.lines) say(line);
    code_.operations += code.operations;
    code_.ranges.insert(code_.ranges.end(), code.ranges.begin(), code.ranges.end());
    code_.meshed = code_.meshed || code.meshed;
    return {code.re, code.im, code.roundings};
  }

  Quantity scaled(const Quantity& k) {
    const auto times = [this](const Component& part, const char* name) -> Component {
      if (!part) return std::nullopt;
      say(fmt::format("const T {} = ratio * {};", name, *part), 1);
      return name;
    };
    const Component re = times(k.re, "t_re"), im = times(k.im, "t_im");
    return {re, im, k.roundings + Roundings{ratio_roundings_ + 1, ""}};
  }

  /// The absolute value, a double.
  std::string size(const Quantity& k) {
    // T(p.k) is the double p.k.
    const auto head = [](const std::string& x) {
      return x.starts_with("T(") ? x.substr(2, x.size() - 3) : "double(" + x + ")";
    };
    if (!k.im || !k.re) return head(k.re ? *k.re : *k.im);
    code_.has_length = true;
    return fmt::format("length({}, {})", head(*k.re), head(*k.im));
  }

  Component sum(const Component& a, const Component& b, const std::string& name) {
    if (!a || !b) return a ? a : b;
    say(fmt::format("const T {} = {} + {};", name, *a, *b), 1);
    return name;
  }

  Component minus_inertia(const Component& a, const Component& b, const std::string& name) {
    const std::string zero = "T(0.0)";
    say(fmt::format("const T {} = less({}, {}, inertia);", name, a.value_or(zero),
                    b.value_or(zero)),
        2);
    return name;
  }

  Quantity drive_network(const Quantity& normal, const Quantity& tangential) {
    if (*scene_.drive == scene_.normal) return normal;
    const auto* network = std::get_if<Network>(&scene_.tangential);
    if (network != nullptr && *scene_.drive == *network) return tangential;
    return this->network(*scene_.drive, "d");
  }

  /// "roundings * size", the error of a part of D or N; empty for none.
  static std::string error(const Roundings& roundings, const std::string& size) {
    if (roundings.constant == 0 && roundings.variable.empty()) return "";
    if (roundings.constant == 1 && roundings.variable.empty()) return size;
    const std::string factor = expression(roundings);
    return (roundings.variable.empty() ? factor : "(" + factor + ")") + " * " + size;
  }

  static std::string sum_of(const std::vector<std::string>& terms) {
    std::vector<std::string> there;
    for (const std::string& term : terms)
      if (!term.empty()) there.push_back(term);
    return there.empty() ? "0.0" : fmt::format("{}", fmt::join(there, " + "));
  }

  void with_drive(bool isotropic) {
    const Quantity normal = network(scene_.normal, "n");
    const Quantity t =
        isotropic ? scaled(normal) : network(std::get<Network>(scene_.tangential), "t");
    const Quantity d = drive_network(normal, t);
    Quantity body = d, whole;
    std::string inertia;
    if (scene_.mass) {
      const std::string m = parameters_.reference(scene_.mass->symbol);
      say("// D = K_d - m omega^2 and N = K_t + K_d - m omega^2");
      say(fmt::format("const Twofold inertia = product({}, p.omega) * p.omega;", m), 2);
      code_.ranges.push_back(m + " * p.omega * p.omega");
      body.re = minus_inertia(std::nullopt, d.re, "D_re");
      whole.re = minus_inertia(t.re, d.re, "N_re");
      inertia = "2.0 * inertia.high";
    } else {
      say("// D = K_d and N = K_t + K_d");
      whole.re = sum(t.re, d.re, "N_re");
    }
    whole.im = sum(t.im, d.im, "N_im");
    say(fmt::format("const T D2 = {};", square(body)), 3);
    say(fmt::format("const T N2 = {};", square(whole)), 3);
    if (scene_.mass) {
      say("if (double(N2) == 0.0 || double(D2) == 0.0)  // (anti)resonance: 0, infinite, or 0/0");
      say("  return {std::sqrt(double(N2) / double(D2)), "
          "std::numeric_limits<double>::infinity()};");
    }
    write_errors(t, d, inertia);
    const Roundings both{constant_roundings + difference_roundings, "error_D + error_N"};
    if (isotropic) return finish("N2 / D2", both + Roundings{ratio_roundings_, ""});
    finish(fmt::format("N2 / D2 * {}", contact_quotient(normal, t)),
           both + normal.roundings + t.roundings);
  }

  void write_errors(const Quantity& t, const Quantity& d, const std::string& inertia) {
    const std::string t_size = size(t), d_size = size(d);
    const Roundings one{1, ""};
    say(fmt::format("const double error_D = ({}) / std::sqrt(double(D2));",
                    sum_of({error(d.roundings, d_size), inertia})));
    say(fmt::format(
        "const double error_N = ({}) / std::sqrt(double(N2));",
        sum_of({error(t.roundings + one, t_size), error(d.roundings + one, d_size), inertia})));
  }

  std::string contact_quotient(const Quantity& normal, const Quantity& tangential) {
    code_.operations += 7;
    return fmt::format("(({}) / ({}))", square(normal), square(tangential));
  }

  void without_drive() {
    const Quantity normal = network(scene_.normal, "n");
    const Quantity tangential = network(std::get<Network>(scene_.tangential), "t");
    finish(contact_quotient(normal, tangential),
           Roundings{constant_roundings, ""} + normal.roundings + tangential.roundings);
  }

  void finish(const std::string& radicand, const Roundings& roundings) {
    std::string value = "w * p.mu0 * p.du_z";
    code_.operations += 3;
    if (std::holds_alternative<Isotropic>(scene_.tangential)) value += " / ratio";
    if (!radicand.empty()) value = fmt::format("sqrt({}) * ({})", radicand, value);
    code_.operations += radicand.empty() ? 0 : 5;
    say(fmt::format("return {{double({}), {}}};", value, expression(roundings)));
  }

  const Scene& scene_;
  const ParameterList& parameters_;
  EvaluationCode code_;
  int ratio_roundings_ = 0;
};

}  // namespace

EvaluationCode evaluation_code(const Scene& scene, const ParameterList& parameters) {
  return Writer(scene, parameters).write();
}

}  // namespace vcrit::symbolic
