// Random systems for RapidCheck out of random networks; omega = 1.
#pragma once

#include "random_networks.hpp"
#include "simulation/steady/onset.hpp"
#include "simulation/system/system.hpp"
#include "stiffness/relaxation.hpp"

namespace vcrit::properties {

/// Element values in 10^-decades .. 10^decades. `mass` 0: no body; without `drive`: rigid.
struct Draw {
  Pieces contact;
  rc::Maybe<Pieces> drive;
  double mass = 0, amplitude = 0.5, friction = 1, normal_force = 1;
};

/// What is between 0 and 1, to three digits.
inline rc::Gen<double> share() {
  return rc::gen::map(rc::gen::inRange(1, 1000), [](int n) { return n / 1000.0; });
}

inline rc::Gen<Draw> draws(int decades) {
  return rc::gen::build<Draw>(
      rc::gen::set(&Draw::contact, pieces(decades, 6)),
      rc::gen::set(&Draw::drive, rc::gen::maybe(pieces(decades, 5))),
      rc::gen::set(&Draw::mass, rc::gen::oneOf(rc::gen::just(0.0), magnitude(1))),
      rc::gen::set(&Draw::amplitude, share()), rc::gen::set(&Draw::friction, share()),
      rc::gen::set(&Draw::normal_force, magnitude(3)));
}

inline Relaxation form_of(const Pieces& pieces) {
  const Wired wired = tree_of(pieces);
  return relaxation_form(wired.network, wired.values);
}

inline simulation::System system_of(const Draw& draw) {
  simulation::System system;
  system.contact = form_of(draw.contact);
  if (draw.drive) system.drive = form_of(*draw.drive);
  if (draw.drive && draw.mass > 0) system.mass = draw.mass;
  system.omega = 1;
  system.friction = draw.friction;
  system.mean_normal_force = draw.normal_force;
  system.normal_force_amplitude = std::polar(draw.normal_force * draw.amplitude, draw.mass);
  return system;
}

/// Of a velocity to the threshold of sliding: 1e-4 .. 1, and close to 1.
inline rc::Gen<double> ratio_below_one() {
  return rc::gen::oneOf(
      rc::gen::map(rc::gen::inRange(1, 65), [](int n) { return std::pow(10, -n / 16.0); }),
      rc::gen::map(rc::gen::inRange(2, 30), [](int n) { return 1 - std::pow(2, -n); }));
}

/// A share of the threshold. Left out is what the simulator declines by name: body and drive in
/// undamped resonance, and creep that leaves no digits of the contact's swing.
inline double drive_velocity(const simulation::System& system, double ratio) {
  const simulation::Onset onset = simulation::sliding_threshold(system);
  const double contact = onset.contact_velocity, drive = onset.drive_velocity;
  RC_PRE(std::isfinite(drive) && contact > 0);
  RC_PRE(drive - contact < 0.9e7 * contact);
  return ratio * drive;
}

inline void showValue(const Draw& draw, std::ostream& out) {
  out << "contact ";
  rc::show(draw.contact, out);
  out << "\ndrive ";
  rc::show(draw.drive, out);
  out << "\nmass " << draw.mass << ", amplitude " << draw.amplitude << ", mu0 " << draw.friction
      << ", <F_n> " << draw.normal_force;
}

}  // namespace vcrit::properties
