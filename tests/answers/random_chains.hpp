// Chains of masses at random, whose receptance is a recursion from the far end: for campaigns that
// no factor was set on.
#pragma once

#include <fmt/core.h>

#include <cmath>
#include <complex>
#include <random>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "support/scene_text.hpp"

namespace vcrit::test {

/// Pads (a spring beside a damper) and masses from the body to the wall, pads.size() = m.size()
/// + 1.
struct RandomChain {
  std::string id;
  std::vector<double> k, c, m;
  double body = 0, velocity_part = 0;
  Scene scene;

  std::complex<double> receptance(double omega) const {
    const std::complex<double> s(0, omega);
    std::complex<double> end = k.back() + c.back() * s;
    for (std::size_t i = m.size(); i-- > 0;) {
      const std::complex<double> pad = k[i] + c[i] * s, behind = end + m[i] * s * s;
      end = pad * behind / (pad + behind);
    }
    return 1.0 / end;
  }
};

/// Of 2 to 5 masses, one of them the body; omega = 1. Springs span a decade and a half, dampers two
/// from the ones of mounted metal parts on, and a quarter of the chains have a pad without damper.
inline RandomChain random_chain(int number) {
  std::mt19937_64 engine(static_cast<unsigned>(1000 + number));
  const auto uniform = [&] { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53; };
  const auto between = [&](double low, double high) {
    return low * std::pow(high / low, uniform());
  };
  RandomChain chain;
  const int masses = 1 + number % 4;
  chain.id = fmt::format("random chain {} of {} masses", number, masses + 1);
  for (int i = 0; i <= masses; ++i) {
    chain.k.push_back(between(0.3, 8));
    chain.c.push_back(between(0.005, 0.5));
    if (i < masses) chain.m.push_back(between(0.2, 3));
  }
  if (uniform() < 0.25) chain.c[static_cast<std::size_t>(uniform() * (masses + 1))] = 0;
  const bool viscous = uniform() < 0.5;
  SceneText text{.normal = "kn",
                 .tangential = viscous ? "k0 | c0" : "k0",
                 .mass = chain.body = between(0.1, 2),
                 .angular_frequency = 1,
                 .amplitude = 0.4 + 0.55 * uniform(),
                 .indentation = 1,
                 .coefficient = 0.2 + 0.3 * uniform(),
                 .elements = {{"kn", 1}, {"k0", between(0.3, 3)}}};
  if (viscous) text.elements.emplace_back("c0", between(0.05, 2));
  chain.velocity_part = 0.1 + 0.85 * uniform();
  std::string drive;
  for (std::size_t i = chain.k.size(); i-- > 0;) {
    std::string pad = fmt::format("kd{}", i + 1);
    text.elements.emplace_back(pad, chain.k[i]);
    if (chain.c[i] > 0) {
      text.elements.emplace_back(fmt::format("cd{}", i + 1), chain.c[i]);
      pad = fmt::format("({0} | cd{1})", pad, i + 1);
    }
    if (i == chain.m.size()) {
      drive = pad;
      continue;
    }
    text.elements.emplace_back(fmt::format("m{}", i + 1), chain.m[i]);
    drive = fmt::format("{} - (mass(m{}) | ({}))", pad, i + 1, drive);
  }
  text.network = drive;
  chain.scene = scene_of(text);
  return chain;
}

}  // namespace vcrit::test
