// Random networks and scenes with values, the same for the same seed.
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "network/graph.hpp"
#include "network/network.hpp"
#include "scene/scene.hpp"

namespace vcrit::test {

class RandomScenes {
 public:
  /// Element values are 10^(+-decades) about 1, omega 10^(+-decades/2).
  RandomScenes(unsigned seed, double decades) : random_(seed), decades_(decades) {}

  /// A scene of networks with up to `most` elements each; every value is given.
  Scene scene(int most) {
    Scene scene;
    scene.file = "random";
    scene.normal = network(count(1, most), "n", scene);
    if (chance(0.5))
      scene.tangential = network(count(1, most), "t", scene);
    else if (chance(0.5))
      scene.tangential = Isotropic{Isotropic::By::poisson, {{"poisson"}, uniform(0, 0.5)}};
    else
      scene.tangential = Isotropic{Isotropic::By::ratio, {{"tangential_ratio"}, uniform(0.5, 1.5)}};
    if (chance(0.7)) scene.drive = network(count(1, most), "d", scene);
    if (scene.drive && chance(0.7)) scene.mass = Quantity{{"m"}, magnitude(decades_)};
    scene.coefficient = {{"mu0"}, uniform(0.05, 1)};
    scene.angular_frequency = {{"omega"}, magnitude(decades_ / 2)};
    scene.amplitude = {{"du_z"}, uniform(0.1, 1)};
    scene.indentation = {{"u_z0"}, 2.0};
    return scene;
  }

  /// A drive of `bodies` springs, dampers and masses each, and a spring at its end: a chain, with
  /// absorbers here and there, or a graph.
  Network drive_with_masses(int bodies, Scene& scene) {
    return chance(0.5) ? chain(bodies, scene) : mass_graph(bodies, scene);
  }

  /// A network of `elements` elements named after `prefix`; their values go into the scene.
  Network network(int elements, const std::string& prefix, Scene& scene) {
    if (elements == 1) return element(prefix, scene);
    if (elements >= 5 && chance(0.4)) return graph(elements, prefix, scene);
    const int left = count(1, elements - 1);
    std::vector<Network> parts{network(left, prefix, scene),
                               network(elements - left, prefix, scene)};
    return chance(0.5) ? series(std::move(parts)) : parallel(std::move(parts));
  }

 private:
  bool chance(double p) { return std::bernoulli_distribution(p)(random_); }
  int count(int from, int to) { return std::uniform_int_distribution(from, to)(random_); }
  double uniform(double from, double to) {
    return std::uniform_real_distribution(from, to)(random_);
  }
  double magnitude(double decades) { return std::pow(10, uniform(-decades, decades)); }

  Network element(const std::string& prefix, Scene& scene) {
    const bool is_spring = chance(0.5);
    const std::string name =
        (is_spring ? "k" : "c") + prefix + std::to_string(scene.elements.size());
    scene.elements.emplace_back(Symbol{name}, magnitude(decades_));
    return is_spring ? spring({name}) : damper({name});
  }

  Network mass_element(Scene& scene) {
    const std::string name = "md" + std::to_string(scene.elements.size());
    scene.elements.emplace_back(Symbol{name}, magnitude(decades_));
    return mass({name});
  }

  // link - (mass | rest of the chain | perhaps an absorber)
  Network chain(int bodies, Scene& scene) {
    const Network link = network(count(1, 3), "d", scene);
    if (bodies == 0) return link;
    std::vector<Network> parts{mass_element(scene), chain(bodies - 1, scene)};
    if (chance(0.3)) parts.push_back(series({element("d", scene), mass_element(scene)}));
    return series({link, parallel(std::move(parts))});
  }

  // A path from terminal to terminal with a mass at each inner node, and chords.
  Network mass_graph(int bodies, Scene& scene) {
    Graph graph;
    for (int n = 0; n < bodies + 2; ++n) graph.nodes.push_back(std::to_string(n));
    const auto add = [&](Network part, int from, int to) {
      graph.parts.push_back(std::move(part));
      graph.wires.push_back({from, to});
    };
    for (int n = 0; n <= bodies; ++n)
      add(network(count(1, 2), "d", scene), n == 0 ? 0 : n + 1, n == bodies ? 1 : n + 2);
    for (int n = 2; n < bodies + 2; ++n) add(mass_element(scene), n, 1);
    for (int chord = 0; chord < bodies; ++chord) {
      const int from = count(0, bodies + 1);
      add(element("d", scene), from, (from + count(1, bodies + 1)) % (bodies + 2));
    }
    return {load_carrying(graph)->graph};
  }

  // A path from terminal to terminal over the inner nodes, and chords at random: whatever carries
  // no load is dropped.
  Network graph(int elements, const std::string& prefix, Scene& scene) {
    const int inner = count(2, std::min(4, elements - 2));
    Graph graph;
    for (int n = 0; n < inner + 2; ++n) graph.nodes.push_back(std::to_string(n));
    const auto add = [&](int from, int to) {
      graph.parts.push_back(element(prefix, scene));
      graph.wires.push_back({from, to});
    };
    add(0, 2);
    for (int n = 2; n < inner + 1; ++n) add(n, n + 1);
    add(inner + 1, 1);
    for (int left = elements - inner - 1; left > 0; --left) {
      const int from = count(0, inner + 1);
      add(from, (from + count(1, inner + 1)) % (inner + 2));
    }
    return {load_carrying(graph)->graph};
  }

  std::mt19937 random_;
  double decades_;
};

}  // namespace vcrit::test
