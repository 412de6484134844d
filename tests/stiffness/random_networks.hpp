// Random networks with random values, from a fixed seed.
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "network/network.hpp"

namespace vcrit::reference {

class RandomNetworks {
 public:
  /// Element coefficients and times spread over 10^-decades .. 10^decades.
  RandomNetworks(unsigned seed, double decades) : random_(seed), decades_(decades) {}

  Network tree(int elements) {
    if (elements <= 1) return element();
    const int left = 1 + static_cast<int>(random_() % static_cast<unsigned>(elements - 1));
    std::vector<Network> parts;
    parts.push_back(tree(left));
    parts.push_back(tree(elements - left));
    return random_() % 2 == 0 ? series(std::move(parts)) : parallel(std::move(parts));
  }

  /// A ladder of rungs, each node joined to the next two, so that no step is series-parallel.
  Network graph(int inner) {
    Graph g{{"a", "b"}, {}, {}};
    for (int i = 0; i < inner; ++i) g.nodes.push_back(std::to_string(i));
    std::vector<int> order{0};
    for (int i = 0; i < inner; ++i) order.push_back(i + 2);
    order.push_back(1);
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size() && j <= i + 2; ++j) {
        g.parts.push_back(tree(1 + static_cast<int>(random_() % 3)));
        g.wires.push_back({order[i], order[j]});
      }
    return {std::move(g)};
  }

  double value() {
    return std::pow(10.0, std::uniform_real_distribution<double>(-decades_, decades_)(random_));
  }
  std::mt19937& random() { return random_; }
  const Values& values() const { return values_; }

 private:
  Network element() {
    const std::string number = std::to_string(values_.size());
    const Symbol k{"k" + number, 0}, c{"c" + number, 0}, tau{"t" + number, 0};
    switch (random_() % 5) {
      case 0:
      case 1:
        values_[k] = value();
        return spring(k);
      case 2:
      case 3:
        values_[c] = value();
        return damper(c);
      default:
        values_[k] = value();
        values_[tau] = value();
        return maxwell(k, tau);
    }
  }

  std::mt19937 random_;
  double decades_;
  Values values_;
};

}  // namespace vcrit::reference
