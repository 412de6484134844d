// Measured dynamic stiffness: storage and loss over frequency, read from a table.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace vcrit {

struct StiffnessRow {
  double omega = 0;              ///< rad/s, > 0
  double storage = 0, loss = 0;  ///< Re K and Im K, N/m, not both 0; see noise_below_zero
  double storage_error = 0, loss_error = 0;  ///< one standard deviation each, N/m, > 0 where known
  int line = 0;                              ///< in the file, 0: unknown
  double storage_step = 0, loss_step = 0;    ///< a unit of the last digit written, N/m, 0: unknown
};

struct StiffnessTable {
  std::string file;                ///< as the user named it
  std::vector<StiffnessRow> rows;  ///< at least three, omega increasing
  bool has_errors = false;
  std::vector<std::string> notes = {};  ///< what the user should know of how the table was read
};

/// A spring and a damper go through any two rows: with fewer than three nothing is left to tell
/// noise by.
constexpr std::size_t least_rows = 3;

/// Noise makes small parts negative. They are fitted as they are, since without them the mean would
/// be too large; but no more than so many of the errors given is noise, or as many of the largest
/// noise that a measurement may have, a tenth of |K|.
constexpr double errors_below_zero = 4, noise_below_zero = errors_below_zero * 0.1;

/// A flat circular punch on a half-space, which makes a stiffness of Young's modulus.
struct Punch {
  double radius = 0;   ///< m
  double poisson = 0;  ///< of the half-space, constant
  /// 2 a/(1 - nu^2): the normal stiffness over Young's modulus, m.
  double length() const { return 2 * radius / (1 - poisson * poisson); }
};

/// None without a radius. Throws InputError, naming `punch_radius` or `poisson`.
std::optional<Punch> punch_of(const std::string& radius, const std::string& poisson);

/// A table in CSV with a header row: `frequency` (Hz) or `angular_frequency` (rad/s), `storage`,
/// `loss` or `tan_delta` and, both or none, `storage_error` and `loss_error` (N/m), in any order. A
/// unit may stand behind a name, as in "frequency (kHz)" or "storage [N/um]"; what has none is in
/// SI, and a note says so. Moduli ("storage [MPa]") are taken below the punch, which they need.
/// Frequencies rise or fall throughout.
/// Throws InputError with file and line.
StiffnessTable read_stiffness_table(const std::string& file,
                                    const std::optional<Punch>& punch = {});
/// The same from text.
StiffnessTable parse_stiffness_table(const std::string& text, const std::string& file,
                                     const std::optional<Punch>& punch = {});

}  // namespace vcrit
