// Eq. 24 of one scene written down as a list of operations on columns, for the kernels.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "problem/problem.hpp"

namespace vcrit {

/// A number of each lane, by the place of its column.
using Column = std::size_t;

/// The column of zeros: the loss of a spring, the storage of a damper.
inline constexpr Column zero_column = 0;

struct BatchOperation {
  /// The kernels of the same names.
  enum class Kind {
    multiply,
    divide,
    add,
    maxwell,
    series,
    mesh,
    isotropic,
    modulus_ratio,
    drive_factor
  };
  Kind kind = Kind::multiply;
  std::array<Column, 2> out{};  ///< storage and loss, or twice the one result
  std::array<Column, 6> in{};   ///< as the kernel takes them; mass zero_column: no body
};

struct Operations {
  std::vector<BatchOperation> list;     ///< in the order in which they can run
  std::map<Symbol, Column> parameters;  ///< those that v* depends on
  std::size_t columns = 1;
  Column result = zero_column;
  std::optional<Column> poisson;                    ///< the one parameter that need not be positive
  bool exact_contact = false, exact_drive = false;  ///< K_t, K_d are single springs
};

/// Nothing for a measured drive and one that holds masses: no kernel is accurate enough there. Nor
/// for a mount.
std::optional<Operations> operations_of(const Problem& problem);

}  // namespace vcrit
