#include "paper/shapes.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>

#include "critical/critical_velocity.hpp"
#include "indenter/friction.hpp"
#include "paper/comparing.hpp"
#include "problem/problem.hpp"

namespace vcrit::validation::paper {

namespace {

// Any; with |E(i omega)| < E0 + E1 below, of which E0 carries an indentation of 1, the centre stays
// closed: 0.2 x 3 < 2.
constexpr double shape_poisson = 0.3;
constexpr double shape_friction = 0.3, shape_omega = 2, shape_amplitude = 0.2;

struct Form {
  const char *name, *sizes;
};
constexpr std::array forms{Form{"a flat punch", "shape = \"flat\"\nradius = 1"},
                           Form{"a cone", "shape = \"cone\"\nangle = \"20 deg\""},
                           Form{"a parabola", "shape = \"parabola\"\nradius = 5"}};

Problem indented(const std::string& sizes, double nu) {
  return parse_problem(
      fmt::format("[contact]\nnormal = \"zener(E0, E1, c1)\"\npoisson = {}\n[indenter]\n{}\n"
                  "[oscillation]\nangular_frequency = {}\namplitude = {}\nindentation = 1\n"
                  "[friction]\ncoefficient = {}\n[elements]\nE0 = 2\nE1 = 1\nc1 = 0.8\n",
                  nu, sizes, shape_omega, shape_amplitude, shape_friction),
      "paper");
}

/// mu0 omega du_z (2 - nu)/(2 (1 - nu)), by hand.
Comparison velocity_of(const Form& form) {
  const auto found =
      indenter::sliding_threshold(indenter::HalfSpace(indented(form.sizes, shape_poisson)));
  return comparison(
      {"shape", fmt::format("lowest speed at which all of {} slides", form.name),
       "μ₀ ω du_z (2 − ν)/(2(1 − ν))", "the simulator’s threshold, which is refined to 10⁻¹²",
       Comparison::Measure::relative},
      {shape_friction * shape_omega * shape_amplitude * (2 - shape_poisson) /
           (2 * (1 - shape_poisson)),
       found.contact_velocity, 4e-12, ""});
}

/// Of a parabola whose centre stays closed: the share of the contact's width that opens. With
/// g = x^2/R the edge is at sqrt(R (u_z0 + du_z)), the closed part ends at sqrt(R (u_z0 - swing)),
/// where swing = du_z |E(i omega)|/E(0).
Comparison rim_of_parabola() {
  const indenter::HalfSpace half_space(indented(forms[2].sizes, shape_poisson));
  const double x = shape_omega * 0.8, loss = x / (1 + x * x), storage = 2 + x * x / (1 + x * x);
  const double swing = shape_amplitude * std::hypot(storage, loss) / 2;
  return comparison({"rim", "share of a parabola’s width that opens in each period, centre closed",
                     "1 − √((1 − D |E(iω)|/E(0))/(1 + D))", "some twenty roundings"},
                    {1 - std::sqrt((1 - swing) / (1 + shape_amplitude)),
                     1 - half_space.closed_radius() / half_space.edge(), 5e-15, ""});
}

/// K_t/K_n as Eq. (24) has it under a rigid drive: mu0 omega du_z/v*.
Comparison stiffness_ratio(double nu, double expected) {
  const double velocity = vcrit::critical_velocity(indented(forms[0].sizes, nu));
  return comparison(
      {"stiffness_ratio", fmt::format("K_t/K_n at ν = {}, from v*", nu), "2(1 − ν)/(2 − ν)",
       "ten digits given"},
      {expected, shape_friction * shape_omega * shape_amplitude / velocity, 0.5e-10, ""});
}

/// Dundurs' constant of an elastic body on a rigid one: how far normal and tangential problem are
/// coupled, which the method leaves out.
Comparison coupling() {
  return comparison({"coupling", "Dundurs’ β on a rigid base at ν = 0.3", "2/7", "four roundings"},
                    {2.0 / 7, (1 - 2 * shape_poisson) / (2 * (1 - shape_poisson)), 1e-15, ""});
}

}  // namespace

PaperPart press_shapes() {
  PaperPart part;
  for (const Form& form : forms) part.comparisons.push_back(velocity_of(form));
  part.comparisons.push_back(rim_of_parabola());
  part.comparisons.push_back(coupling());
  part.comparisons.push_back(stiffness_ratio(0.3, 0.8235294118));
  part.comparisons.push_back(stiffness_ratio(0.48, 0.6842105263));
  return part;
}

}  // namespace vcrit::validation::paper
