// Measured dynamic stiffness: storage and loss over frequency, read from a table.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace vcrit::fit {

struct Row {
  double omega = 0;                          ///< rad/s, > 0
  double storage = 0, loss = 0;              ///< Re K and Im K, N/m, >= 0, not both 0
  double storage_error = 0, loss_error = 0;  ///< one standard deviation each, N/m, > 0 where known
};

struct Data {
  std::string file;       ///< as the user named it
  std::vector<Row> rows;  ///< at least two, omega increasing
  bool has_errors = false;
};

/// A table in CSV with a header row: `frequency` (Hz) or `angular_frequency` (rad/s), `storage`,
/// `loss` and, both or none, `storage_error` and `loss_error` (N/m), in any order. A unit may stand
/// behind a name, as in "frequency (kHz)" or "storage [N/um]". Frequencies rise or fall throughout.
/// Throws InputError with file and line.
Data read_data(const std::string& file);
/// The same from text.
Data parse_data(const std::string& text, const std::string& file);

}  // namespace vcrit::fit
