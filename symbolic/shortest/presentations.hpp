// The ways in which an expert would write the stiffness of a network before doing algebra: storage
// and loss, a quotient with a common denominator, compliances of what is one behind the other.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "network/network.hpp"
#include "shortest/complex.hpp"

namespace vcrit::symbolic::shortest {

/// Parts of a network of which those of one kind are one: springs side by side, dampers one behind
/// the other, ...
struct Gathered {
  std::optional<Ex> spring, damper, mass;
  std::vector<Network> others;
};

/// How many presentations are looked at and kept.
struct Thrift {
  std::size_t combinations = 48;  ///< of those of the parts of a sum
  std::size_t kept = 3;           ///< of each sort
};

class Presentations {
 public:
  using Choices = std::vector<std::vector<ComplexQuotient>>;
  using Lookup = std::function<Ex(const Symbol&)>;
  /// `dampers_named`: W = omega c is a letter, which nothing looks into.
  Presentations(Expressions& all, Ex omega, Lookup symbol, const Thrift& thrift,
                bool dampers_named = true)
      : all_(all),
        complex_(all),
        omega_(omega),
        symbol_(std::move(symbol)),
        thrift_(thrift),
        dampers_named_(dampers_named) {}

  /// Of the stiffness, a few, those most promising first.
  std::vector<ComplexQuotient> of(const Network& network);
  /// Of the stiffness with something beside it.
  std::vector<ComplexQuotient> beside(const Network& network, const ComplexQuotient& other);
  /// Of the compliance with another behind it.
  std::vector<ComplexQuotient> behind(const Network& network, const ComplexQuotient& other);
  /// Of sums, of each of which any presentation may be taken.
  std::vector<ComplexQuotient> sums(const Choices& parts, const std::vector<int>& groups);
  ComplexQuotient sum(const std::vector<ComplexQuotient>& parts, bool one_denominator);
  /// K - m omega^2 of a drive and a mass, if there is one: of springs and dampers side by side
  /// Z + i V.
  std::vector<ComplexQuotient> swinging(const Network& drive, const std::optional<Ex>& mass);
  /// m omega^2
  Ex inertia(const Ex& mass);

 private:
  std::vector<ComplexQuotient> of(const Element& element);
  std::vector<ComplexQuotient> of(const Series& series);
  std::vector<ComplexQuotient> of(const Parallel& parallel);
  std::vector<ComplexQuotient> of(const Graph& graph);
  ComplexQuotient damper(const Ex& c, const char* letter);
  std::vector<ComplexQuotient> maxwell(const Ex& k, const Ex& turn);
  /// The parts of a sum, and which of them are alike.
  struct Terms {
    Choices choices;
    std::vector<int> groups;
  };
  Terms side_by_side(const std::vector<Network>& parts);
  Terms one_behind_another(const std::vector<Network>& parts);
  Gathered gathered(const std::vector<Network>& parts, bool inverse);
  std::optional<Ex> joined(const std::vector<Ex>& values, bool inverse);
  Ex named(const char* letter, const Ex& meaning);
  Ex number(const Amount& amount);
  std::vector<ComplexQuotient> best(std::vector<ComplexQuotient> all);
  void offer(std::vector<ComplexQuotient>& all, const ComplexQuotient& quotient);
  std::vector<ComplexQuotient> found_sums(const Choices& parts, const std::vector<int>& groups);

  /// Sums that were asked for: a network is written again with each way to write another one.
  struct Summed {
    Choices parts;
    std::vector<int> groups;
    std::vector<ComplexQuotient> found;
    std::size_t work = 0;  ///< that it took to find them: spent by each that asks
  };
  Expressions& all_;
  ComplexAlgebra complex_;
  Ex omega_;
  Lookup symbol_;
  Thrift thrift_;
  bool dampers_named_;
  std::vector<Summed> summed_;
};

/// Networks of the same form have the same number.
std::vector<int> alike(const std::vector<Network>& parts);

}  // namespace vcrit::symbolic::shortest
