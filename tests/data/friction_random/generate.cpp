// Writes friction_random.csv: steady stick-slip states of random scenes, to 25 digits.
//
// It shares nothing with the program. Every spring-damper branch is a state of its own in one
// linear system for slip and one for stick; both are exponentiated by scaling and squaring in many
// digits, which leaves a tower of exact steps 2 pi/2^k. A piece of motion is walked in such steps,
// from far below its fastest time constant on, eight to an octave and later evenly; where an event
// function changes sign, or rises and falls between two points, the steps are halved down to the
// tower's end, and a Taylor series does the rest. Energies come from the same steps: the integral
// of a quadratic form doubles as W(2h) = W(h) + P^T W(h) P. The steady state is the fixed point of
// the period map by Newton's method. All is done twice, with 80 and 110 digits, the second search
// starting where the first ended; a row is written if both agree to 1e-28 and energy is conserved
// as well.
//
// Units: omega = 1, mu0 <F_n> = 1, friction bound 1 + amplitude cos t. Columns, inputs as
// hexadecimal doubles:
//   id; contact and drive: spring:damper{:stiffness:time of a Maxwell branch}, or `rigid`; mass,
//   empty without; amplitude; velocity of the drive; velocity_ratio, roughly, to the one at which
//   sliding begins; friction_ratio; friction_heat, damper_heat: dissipated in one period; events.
//
// From this folder (ten minutes on one core; the second line shows how far it is from values that
// another program computed):
//   g++ -std=c++20 -O2 -fopenmp -isystem /usr/include/eigen3 generate.cpp -o /tmp/generate
//   /tmp/generate ../stickslip_reference.csv
//   /tmp/generate > ../friction_random.csv
#include "steady.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <random>
#include <sstream>

namespace {

using reference::Branches;
using reference::Scene;
using reference::Steady;
using Low = reference::Digits<80>;
using High = reference::Digits<110>;

constexpr int scenes = 320;

// Of random bits alone: the standard's distributions differ between libraries.
class Random {
 public:
  explicit Random(unsigned seed) : bits_(seed) {}
  double uniform(double from, double to) {
    return from + (to - from) * std::ldexp(static_cast<double>(bits_() >> 11), -53);
  }
  double decades(double from, double to) { return std::pow(10, uniform(from, to)); }
  bool chance(double share) { return uniform(0, 1) < share; }

 private:
  std::mt19937_64 bits_;
};

// decades: of the relaxation times in periods, to both sides.
Branches<double> network(Random& random, bool spring, bool damper, int branches, double decades) {
  Branches<double> result;
  if (spring) result.spring = random.decades(-2, 2);
  if (damper) result.damper = random.decades(-3, 2);
  for (int j = 0; j < branches; ++j)
    result.maxwell.push_back(
        {random.decades(-2, 2), 2 * std::acos(-1.0) * random.decades(-decades, decades)});
  if (!spring && !damper && branches == 0) result.spring = random.decades(-2, 2);
  return result;
}

std::complex<double> stiffness(const Branches<double>& network) {
  std::complex<double> sum(network.spring, network.damper);
  for (const auto& [k, tau] : network.maxwell) sum += k * tau / std::complex<double>(tau, -1);
  return sum;
}

double fluidity(const Branches<double>& network) {
  if (network.spring > 0) return 0;
  double viscosity = network.damper;
  for (const auto& [k, tau] : network.maxwell) viscosity += k * tau;
  return 1 / viscosity;
}

// Where steady sliding of the drive begins, to the precision of doubles: it only sets the scale.
double threshold(const Scene<double>& scene) {
  std::complex<double> compliance = 1.0 / stiffness(scene.contact);
  double creep = fluidity(scene.contact);
  if (scene.drive) {
    compliance += 1.0 / (stiffness(*scene.drive) - scene.mass);
    creep += fluidity(*scene.drive);
  }
  return scene.amplitude * std::abs(compliance) + creep;
}

double velocity_ratio(Random& random) {
  const double kind = random.uniform(0, 1);
  if (kind < 0.5) return random.decades(-4, 0);
  if (kind < 0.75) return 1 - random.decades(-6, -1);
  return random.uniform(0.05, 1);
}

double amplitude(Random& random) {
  if (random.chance(0.2)) return 1 - random.decades(-3, -1);
  return random.chance(0.3) ? random.decades(-3, 0) : random.uniform(0.05, 0.999);
}

struct Drawn {
  Scene<double> scene;
  double ratio;
};

Drawn random_scene(int id) {
  Random random(static_cast<unsigned>(7000 + id));
  const double decades = std::array{1.0, 4.0, 9.0}[static_cast<std::size_t>(id % 3)];
  const auto branches = [&](double most) { return static_cast<int>(random.uniform(0, most + 1)); };
  Scene<double> scene;
  const bool spring = random.chance(0.85), damper = random.chance(0.5);
  scene.contact = network(random, spring, damper, branches(4), decades);
  switch (static_cast<int>(random.uniform(0, 5))) {
    case 0:
      break;
    case 1:
      scene.drive = network(random, true, false, 0, decades);
      break;
    case 2:
      scene.drive = network(random, true, true, 0, decades);
      break;
    case 3:
      scene.drive = network(random, true, random.chance(0.5), 1 + branches(3), decades);
      break;
    default:
      scene.drive = network(random, false, random.chance(0.5), branches(3), decades);
  }
  if (scene.drive && random.chance(0.7)) scene.mass = random.decades(-2, 1.5);
  scene.amplitude = amplitude(random);
  const double ratio = velocity_ratio(random);
  scene.velocity = ratio * threshold(scene);
  return {scene, ratio};
}

std::string text(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%a", value);
  return buffer;
}

std::string text(const Branches<double>& network) {
  std::string result = text(network.spring) + ":" + text(network.damper);
  for (const auto& [k, tau] : network.maxwell) result += ":" + text(k) + ":" + text(tau);
  return result;
}

std::string digits(const High& value) { return value.str(25, std::ios::scientific); }

// Largest difference of the two precisions, and what is left of the energy, relative to the work.
High largest_error(const Steady<Low>& low, const Steady<High>& high, const High& velocity) {
  const High work = velocity * high.impulse;
  const auto difference = [&](const Low& a, const High& b) { return High(abs(High(a) - b)); };
  High worst = abs(work - high.friction_heat - high.damper_heat) / work;
  worst = std::max(worst, High(difference(low.ratio, high.ratio) / high.ratio));
  worst = std::max(worst, High(difference(low.friction_heat, high.friction_heat) / work));
  return std::max(worst, High(difference(low.damper_heat, high.damper_heat) / work));
}

std::string row(int id) {
  const auto [scene, ratio] = random_scene(id);
  reference::Motion<Low> low(reference::converted<Low>(scene));
  const Steady<Low> first = low.steady();
  reference::Motion<High> high(reference::converted<High>(scene));
  const Steady<High> second = high.steady(reference::converted<High>(first.start));
  const High error = largest_error(first, second, scene.velocity);
  if (!(error < High("1e-28")))
    throw std::runtime_error("an error of " + error.str(3) + " is left");
  std::ostringstream out;
  out << id << ',' << text(scene.contact) << ',' << (scene.drive ? text(*scene.drive) : "rigid")
      << ',' << (scene.mass > 0 ? text(scene.mass) : "") << ',' << text(scene.amplitude) << ','
      << text(scene.velocity) << ',' << ratio << ',' << digits(second.ratio) << ','
      << digits(second.friction_heat) << ',' << digits(second.damper_heat) << ',' << second.events
      << '\n';
  return out.str();
}

// A scene without a row is named on stderr.
void write_table() {
  std::vector<std::string> rows(scenes);
#pragma omp parallel for schedule(dynamic)
  for (int id = 0; id < scenes; ++id) {
    try {
      rows[static_cast<std::size_t>(id)] = row(id);
    } catch (const std::exception& error) {
#pragma omp critical
      std::cerr << "scene " << id << ": " << error.what() << '\n';
    }
  }
  std::cout << "id,contact,drive,mass,amplitude,velocity,velocity_ratio,friction_ratio,"
               "friction_heat,damper_heat,events\n";
  for (const std::string& line : rows) std::cout << line;
}

// The rows of stickslip_reference.csv, whose numbers are decimal fractions of many digits.
void compare(const std::string& name) {
  std::ifstream file(name);
  std::string line, cell;
  std::vector<std::string> header;
  Low worst = 0;
  for (int count = 0; std::getline(file, line); ++count) {
    std::istringstream cells(line);
    std::map<std::string, std::string> value;
    for (std::size_t i = 0; std::getline(cells, cell, ','); ++i) {
      if (count == 0)
        header.push_back(cell);
      else
        value[header.at(i)] = cell;
    }
    if (count == 0) continue;
    Scene<Low> scene;
    scene.contact = {Low(value["k0"]), Low(value["c"]), {}};
    if (!value["k1"].empty())
      scene.contact.maxwell.push_back(
          {Low(value["k1"]), 2 * acos(Low(-1)) * Low(value["tau_periods"])});
    // Forces in units of mu0 <F_n>: velocities times 1/mu0.
    if (value["k_d"] != "inf") {
      scene.drive = Branches<Low>{Low(value["k_d"]), Low(value["c_d"]), {}};
      scene.mass = Low(value["m"]);
    }
    scene.amplitude = Low(value["F_n_amplitude"]);
    scene.velocity = Low(value["velocity"]) / Low(value["mu0"]);
    const Steady<Low> steady = reference::Motion<Low>(scene).steady();
    const Low difference = abs(steady.ratio - Low(value["friction_ratio"]));
    worst = std::max(worst, difference);
    std::cout << difference.str(3) << "  " << line << std::endl;
  }
  std::cout << "largest difference " << worst.str(3) << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1)
    compare(argv[1]);
  else
    write_table();
}
