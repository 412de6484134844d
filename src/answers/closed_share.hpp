// K_n(0)/|K_n(i omega)| for columns of parameters: the part of the indentation below which the
// amplitude keeps the contact closed (4). Under a load 1/|K_n(i omega)|, the part of the load.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "critical/batch.hpp"

namespace vcrit {

class ClosedShare {
 public:
  /// `varying` as for CriticalVelocities, none of them through 0.
  ClosedShare(const Problem& problem, const std::vector<std::string>& varying);

  /// Columns as for CriticalVelocities; one value for each of `out`. Throws InputError likewise.
  void operator()(std::span<const std::span<const double>> columns, std::span<double> out) const;

 private:
  /// omega times a modulus of the normal network, as v* of a contact with a tangential spring of
  /// 1 N/m under a rigid drive, mu0 = du_z = 1.
  struct Modulus {
    CriticalVelocities velocities;
    std::vector<std::size_t> columns;  ///< of those that vary, the ones it depends on
    void operator()(std::span<const std::span<const double>> all, std::span<double> out) const;
  };
  static Modulus modulus(const Problem& problem, const ReducedNetwork& normal,
                         const std::vector<std::string>& varying);

  Modulus oscillating_;
  /// Of the springs alone, nothing where they carry no load; under a load of 1 N/m.
  std::optional<Modulus> at_rest_;
};

}  // namespace vcrit
