// Scenes whose drives hold masses, at, beside and off the zeros and poles of K_d, K_d - m omega^2
// and K_t + K_d - m omega^2.
#pragma once

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "derivation/scenes.hpp"
#include "emit/draw.hpp"
#include "support/nodal.hpp"

namespace vcrit::test {

struct MassDrive {
  Scene scene;
  Symbol tuned;  ///< a mass of the drive: K_d is a Moebius function of it
};

inline std::vector<MassDrive> mass_drives() {
  // A bridge of springs with a mass at each inner node: no series and parallel steps reduce it.
  const std::string frame =
      "[networks.frame]\nterminals = [\"a\", \"b\"]\n"
      "edges = [[\"ka\", \"a\", \"1\"], [\"kb | cb\", \"a\", \"2\"], [\"kc\", \"1\", \"2\"], "
      "[\"mass(ma)\", \"1\", \"b\"], [\"kd\", \"1\", \"b\"], [\"mass(mb)\", \"2\", \"b\"], "
      "[\"ke | ce\", \"2\", \"b\"]]\n";
  const std::string elastic = "normal = \"kn\"\ntangential = \"kt\"";
  return {
      {scene_of("normal = \"k0 | (k1 - c1)\"\npoisson = 0.35", "kf - (mass(ms) | km | cm)", "m"),
       {"ms"}},
      {scene_of(kelvin_contact, "kd | k1 - mass(m1)", "m"), {"m1"}},
      {scene_of(elastic, "ka - (mass(ma) | kb - (mass(mb) | kc - (mass(mc) | kd)))", "m"), {"ma"}},
      {scene_of(elastic, "kd | mass(ms) | cd - (mass(mb) | ke)"), {"ms"}},
      {scene_of(kelvin_contact, "frame", "m", frame), {"mb"}},
      {scene_of("normal = \"k0 | (k1 - c1)\"\ntangential = \"kt\"",
                "(ka | (kb - cb)) - (mass(ma) | mass(mb) | kc | kd | (ke - (ce | mass(mc))))", "m"),
       {"ma"}},
  };
}

/// What is to vanish: Q of the drive, D = K_d - m omega^2, or N = K_t + D.
enum class Vanishing { deflection, body, contact };

class MassDraw {
 public:
  explicit MassDraw(unsigned seed) : draw_(seed), random_(seed) {}

  /// Of kind 0 within four decades, of kind 1 within twenty-four.
  Scene values_for(const MassDrive& drive, int kind) { return draw_.values_for(drive.scene, kind); }

  Scene without_mass(const MassDrive& drive) {
    Scene scene = values_for(drive, 0);
    set(scene, drive.tuned, 0);
    return scene;
  }

  /// The tuned mass at that zero or, by 10^-13 to 0.1 of itself, beside it; undamped drives and
  /// contacts have it exactly. Where no positive mass has it, the scene as it was drawn.
  Scene near(const MassDrive& drive, Vanishing what, bool at_it) {
    Scene scene = values_for(drive, 0);
    const Real mass = mass_at(scene, drive.tuned, what);
    if (!(mass > 0)) return scene;
    const double off = std::pow(10, std::uniform_real_distribution(-13.0, -1.0)(random_));
    const double sign = std::bernoulli_distribution(0.5)(random_) ? 1 : -1;
    set(scene, drive.tuned, static_cast<double>(mass) * (at_it ? 1 : 1 + sign * off));
    return scene;
  }

 private:
  static void set(Scene& scene, const Symbol& symbol, double value) {
    for (auto& [name, number] : scene.elements)
      if (name == symbol) number = value;
  }

  /// Re of the mass at which 1/(K_d - target) has its pole, from the values at three masses.
  static Real mass_at(Scene scene, const Symbol& symbol, Vanishing what) {
    const Values values = numbers_of(scene);
    const Real omega(values.at(scene.angular_frequency.symbol));
    Complex target;
    if (scene.mass) target += Complex(Real(values.at(scene.mass->symbol)) * omega * omega, Real(0));
    if (what == Vanishing::contact) {
      const auto* own = std::get_if<Network>(&scene.tangential);
      if (own == nullptr) return 0;
      target -= Nodal(values, omega).stiffness(*own);
    }
    const double start = values.at(symbol);
    const double masses[] = {0.5 * start, start, 2 * start};
    Complex k[3];
    for (int i = 0; i < 3; ++i) {
      set(scene, symbol, masses[i]);
      const Values changed = numbers_of(scene);
      k[i] = Nodal(changed, omega).stiffness(*scene.drive);
      if (what != Vanishing::deflection) k[i] = Complex(Real(1), Real(0)) / (k[i] - target);
    }
    const auto whole = [](double x) { return Complex(Real(x), Real(0)); };
    const Complex ratio =
        (k[0] - k[1]) / (k[1] - k[2]) * whole(masses[2] - masses[1]) / whole(masses[1] - masses[0]);
    // Without a pole, of a mass at the body's end, K_d is a line.
    const Complex bend = whole(1) - ratio;
    if (abs(Real(bend.real())) + abs(Real(bend.imag())) < Real(1e-60)) return 0;
    const Complex pole = (whole(masses[2]) - ratio * whole(masses[0])) / bend;
    return Real(pole.real());
  }

  Draw draw_;
  std::mt19937 random_;
};

/// Drawn values and scenes at or beside each of the three, in turn; `index` is the place in
/// mass_drives().
struct MassCase {
  std::size_t index;
  Scene scene;
  Real exact;
};

inline std::vector<MassCase> mass_cases(const std::vector<MassDrive>& drives, unsigned seed,
                                        int rounds) {
  MassDraw draw(seed);
  std::vector<MassCase> cases;
  for (std::size_t i = 0; i < drives.size(); ++i)
    for (int round = 0; round < rounds; ++round) {
      std::vector<Scene> scenes{draw.values_for(drives[i], 0), draw.values_for(drives[i], 1),
                                draw.without_mass(drives[i])};
      for (const Vanishing what : {Vanishing::deflection, Vanishing::body, Vanishing::contact})
        for (const bool at_it : {false, true}) scenes.push_back(draw.near(drives[i], what, at_it));
      for (Scene& scene : scenes) cases.push_back({i, scene, critical_velocity_by_nodes(scene)});
    }
  return cases;
}

}  // namespace vcrit::test
