// Tables of measured stiffness. What is accepted rises in omega, is finite with loss and storage at
// least 0, and reads back from its own numbers.
#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "fuzz.hpp"
#include "scene/stiffness_data.hpp"

using namespace vcrit;

namespace {

std::string line_of(const StiffnessRow& row, bool errors) {
  std::string line = to_text(row.omega) + "," + to_text(row.storage) + "," + to_text(row.loss);
  if (errors) line += "," + to_text(row.storage_error) + "," + to_text(row.loss_error);
  return line + "\n";
}

void check_row(const StiffnessRow& row, bool errors) {
  fuzz::check(std::isfinite(row.omega) && row.omega > 0, "omega is finite and above 0");
  fuzz::check(std::isfinite(row.storage) && std::isfinite(row.loss), "both parts are finite");
  fuzz::check(row.storage != 0 || row.loss != 0, "one of them is not 0");
  const double lowest = -noise_below_zero * std::hypot(row.storage, row.loss);
  fuzz::check(errors || std::min(row.storage, row.loss) >= lowest, "no more than noise is below 0");
  if (!errors) return;
  fuzz::check(std::isfinite(row.storage_error) && row.storage_error > 0, "an error is above 0");
  fuzz::check(std::isfinite(row.loss_error) && row.loss_error > 0, "an error is above 0");
}

}  // namespace

void fuzz::read_fit_data(const std::string& text) {
  fuzz::answered([&] {
    const StiffnessTable table = parse_stiffness_table(text, "data.csv");
    fuzz::check(table.rows.size() >= least_rows, "a table has three rows");
    std::string numbers = "angular_frequency,storage,loss";
    numbers += table.has_errors ? ",storage_error,loss_error\n" : "\n";
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      check_row(table.rows[i], table.has_errors);
      fuzz::check(i == 0 || table.rows[i].omega > table.rows[i - 1].omega, "omega rises");
      numbers += line_of(table.rows[i], table.has_errors);
    }
    std::string again;
    for (const StiffnessRow& row : parse_stiffness_table(numbers, "again.csv").rows)
      again += line_of(row, table.has_errors);
    fuzz::check(numbers.ends_with(again), "a table reads back");
  });
}
