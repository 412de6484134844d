// The header of a table of measurements: which column holds what, in which unit.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/csv.hpp"
#include "scene/stiffness_data.hpp"

namespace vcrit {

enum MeasuredQuantity {
  frequency,
  angular_frequency,
  storage,
  loss,
  tan_delta,  ///< loss over storage, in place of the loss
  storage_error,
  loss_error,
  measured_quantities
};

struct StiffnessColumn {
  std::size_t index = 0;
  double factor = 1;  ///< to SI, of a modulus to the stiffness below the punch
  bool has_unit = false;
};

struct StiffnessColumns {
  std::array<std::optional<StiffnessColumn>, measured_quantities> of;
  bool moduli = false;  ///< storage and loss were moduli

  const std::optional<StiffnessColumn>& operator[](MeasuredQuantity quantity) const {
    return of[quantity];
  }
};

/// "the columns frequency or angular_frequency, storage, ...", with an example.
std::string expected_columns();

/// Throws InputError for a column that nothing is known by, one that is missing or there twice, and
/// a unit that does not fit; a modulus needs a punch.
StiffnessColumns stiffness_columns_of(const CsvLines& header, const std::optional<Punch>& punch);

/// What the header leaves open and is taken as SI; nothing where all have units.
std::optional<std::string> assumed_units(const StiffnessColumns& columns);

}  // namespace vcrit
