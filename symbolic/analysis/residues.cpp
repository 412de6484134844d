#include "analysis/residues.hpp"

#include <fmt/core.h>

#include "formula/names.hpp"
#include "formula/rational.hpp"
#include "formula/symbols.hpp"

namespace vcrit::symbolic {

namespace {

// `receptance` names the value of a measured R_d, which at -s is another number, its conjugate.
Residue amplitude_at(const SymbolicModel& model, const GiNaC::ex& amplitude,
                     const ResiduePoint& point, Residue s, const char* receptance) {
  NumberAlgebra<Residue> algebra{point, s, {{own_name("R_d"), point(own_name(receptance))}}};
  for (const NamedNetwork& part : model.networks())
    if (amplitude.has(quantity(part.name)))
      algebra.known[own_name(part.name)] = evaluate(part.network.reduction(), algebra);
  return evaluate_rational(amplitude, algebra);
}

// Fingerprints are older than the marks of the program's symbols: what has one now is without it,
// and an element that reads like one of them has it.
std::string told_apart(const std::string& name) {
  if (is_own(name)) return base_name(name);
  return name == "s" || name == "R_d" ? own_name(name) : name;
}

// The finalizer of SplitMix64: every bit of the input moves half the bits of the output.
std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

}  // namespace

Residue::Residue(const GiNaC::numeric& rational) {
  const GiNaC::numeric p(std::to_string(prime).c_str());
  const auto residue = [&p](const GiNaC::numeric& integer) {
    std::ostringstream digits;
    digits << GiNaC::mod(integer, p);
    return Residue(std::stoull(digits.str()));
  };
  *this = residue(rational.numer()) * inverse(residue(rational.denom()));
}

Residue operator+(Residue a, Residue b) { return Residue(a.value_ + b.value_); }

Residue operator*(Residue a, Residue b) {
  __extension__ using Wide = unsigned __int128;
  const Wide product = Wide{a.value_} * b.value_;
  return Residue(static_cast<std::uint64_t>(product & Residue::prime) +
                 static_cast<std::uint64_t>(product >> 61));
}

Residue power(Residue a, std::uint64_t exponent) {
  Residue result(1);
  for (; exponent > 0; exponent /= 2, a = a * a)
    if (exponent % 2 == 1) result = result * a;
  return result;
}

// By Fermat's little theorem.
Residue inverse(Residue a) {
  if (a.value_ == 0) throw NoInverse{};
  return power(a, Residue::prime - 2);
}

GaussianResidue::GaussianResidue(const GiNaC::numeric& number)
    : re(number.real()), im(number.imag()) {}

// |a|^2 is 0 for a = 0 alone.
GaussianResidue inverse(GaussianResidue a) {
  const Residue over = inverse(a.re * a.re + a.im * a.im);
  return {a.re * over, -(a.im * over)};
}

// As the prime is 4 n - 1, a^n is a root of a or of -a.
GaussianResidue square_root(Residue a) {
  const Residue r = power(a, (Residue::prime + 1) / 4);
  return r * r == a ? GaussianResidue(r) : GaussianResidue({}, r);
}

ResiduePoint named_point(std::uint64_t number) {
  return [number](const std::string& symbol) {
    std::uint64_t hash = mixed(number + 0x9e3779b97f4a7c15);
    for (const char c : told_apart(symbol))
      hash = mixed(hash + static_cast<unsigned char>(c) + 0x9e3779b97f4a7c15);
    return Residue(hash);
  };
}

std::optional<Residue> square_at(const SymbolicModel& model, const ResiduePoint& point) try {
  const GiNaC::ex amplitude = model.per_friction();
  const Residue s = point(own_name("s"));
  return -(s * s) * amplitude_at(model, amplitude, point, s, "R_d") *
         amplitude_at(model, amplitude, point, -s, "conjugate R_d");
} catch (const NoInverse&) {
  return std::nullopt;
}

// Each element brings at most the degree 3, k tau s; B holds each network at most twice and beside
// them m s^2 and a ratio; and v*^2 holds B twice. Two quotients are equal where a polynomial of
// both degrees together is 0.
double chance_of_agreement(const SymbolicModel& a, const SymbolicModel& b) {
  double degree = 0;
  for (const SymbolicModel* model : {&a, &b})
    for (const NamedNetwork& part : model->networks())
      degree += 2 * (2 * 3 * static_cast<double>(part.network.reduction().steps.size()) + 10);
  return 2 * degree / static_cast<double>(Residue::prime);
}

std::string fingerprint(const SymbolicModel& model) {
  std::string digits;
  for (std::uint64_t number = 0; digits.size() < 32; ++number)
    if (const auto square = square_at(model, named_point(number)))
      digits += fmt::format("{:016x}", square->value());
  return digits;
}

}  // namespace vcrit::symbolic
