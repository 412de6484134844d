// A network and how it is reduced to one stiffness, found once.
#pragma once

#include <memory>

#include "network/network.hpp"
#include "network/reduction.hpp"

namespace vcrit {

/// Cheap to copy: copies share the network and its reduction. May be asked from several threads at
/// once.
class ReducedNetwork {
 public:
  explicit ReducedNetwork(Network network);

  const Network& network() const;
  /// Made when it is first asked for. Throws InputError where reduce() does.
  const Reduction& reduction() const;
  /// Of a drive; networks of a contact have none.
  bool has_masses() const;

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
};

/// How many reductions of problems this process has made. Tests count them.
std::size_t reductions_made();

}  // namespace vcrit
