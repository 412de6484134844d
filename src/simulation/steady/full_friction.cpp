// Of a contact that never opens. x(t) = b - F >= 0 is what friction falls short of its bound by, w
// the contact's velocity,
//
//   w = v - s(t) + (Y x)(t),   s(t) = v* cos t from its slowest instant,
//
// where Y, the response of body, drive and contact to a force on the contact point, is passive:
// <x Yx> >= 0. As x w <= 0 at every instant (0 in stick and slip, negative in slip backward),
//
//   v <x> <= <x s>.
//
// A swing of the n-th harmonic lowers the maximum of cos t: with a = sin(pi/(2 n))/n and the right
// sign, cos t <= E + a cos(n t) for all t, where E = cos(pi/(2 n)) (base/free_swings.hpp). So
//
//   (v - E v*) <x> <= v* a |<x e^{-int}>| = v* a |<w e^{-int}>|/|Y_n| <= v* a <|w|>/|Y_n|,
//
// since of w nothing but Y x has the n-th harmonic. By the balance of power the heat of friction is
// at most the work of the drive, (1 - amplitude) <|w|> <= <b |w|> <= (v + creep) <F> <= v + creep.
#include "simulation/steady/full_friction.hpp"

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"

namespace vcrit::simulation {

namespace {

using Complex = std::complex<double>;

// Velocity of the contact point over the body for a force on it.
Complex contact_response(const ContactModes& contact, Complex s) {
  Complex response = s * contact.glassy + contact.fluidity;
  for (Index j = 0; j < contact.unit_rates.size(); ++j)
    response += s * contact.unit_fluidity[j] / (contact.unit_rates[j] + s);
  return response;
}

// With the harmonic at which the body swings on its drive, or near which.
double most_missing(const Model& model, double velocity, double n) {
  if (n < 2) return 1;
  const double quarter = pi / (2 * n), critical = std::abs(model.sliding_velocity);
  const double excess = velocity - std::cos(quarter) * critical;
  if (!(excess > 0)) return 1;
  const Complex s(0, n);
  const double response = std::abs(model.body->mobility(s) + contact_response(model.contact, s));
  // The second part is the rounding of springs and inertia that cancel.
  const double resistance = 1 / response + 8 * epsilon * n * model.body->mass;
  const double moving = (velocity + model.creep) / (1 - model.amplitude);
  const double missing = critical * std::sin(quarter) / n * moving * resistance / excess;
  return missing < 1 ? missing + 8 * epsilon : 1;
}

}  // namespace

double most_missing_friction(const Model& model, double velocity) {
  double least = 1;
  if (model.opening || !model.body || !(model.amplitude < 1)) return least;
  for (const ModePair& pair : model.slip.modes.spectrum.pairs)
    if (pair.q < 0)
      least = std::min(least, most_missing(model, velocity, std::round(std::sqrt(-pair.q))));
  return least;
}

}  // namespace vcrit::simulation
