#include "program/measured_drive.hpp"

#include <algorithm>
#include <cmath>

namespace vcrit::symbolic {

namespace {

// Of 2^-60 m/N. D and N hold T, which is no smaller than the rows are apart: whatever a smaller Q
// loses below the doubles, or all of it, is far less than a rounding of them.
constexpr double least_receptance = 60;
// A difference, a product and a sum.
constexpr int table_roundings = 3;

struct TableRanges {
  ExponentRange width, receptance;
};

TableRanges ranges_of_table(const std::vector<Receptance::Row>& rows) {
  double narrowest = rows[1].omega - rows[0].omega, widest = narrowest, largest = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    largest = std::max({largest, std::abs(rows[i].re), std::abs(rows[i].im)});
    if (i == 0) continue;
    narrowest = std::min(narrowest, rows[i].omega - rows[i - 1].omega);
    widest = std::max(widest, rows[i].omega - rows[i - 1].omega);
  }
  const ExponentRange width{std::log2(narrowest) - 1, std::log2(widest) + 1};
  // Two components, and two rows.
  const double high = largest > 0 ? std::log2(largest) + 2 : 0;
  return {width, {-least_receptance, std::max(high, -least_receptance)}};
}

std::vector<double> numbers_of_table(const Receptance& receptance) {
  std::vector<double> numbers;
  for (const Receptance::Row& row : receptance.rows)
    numbers.insert(numbers.end(), {row.omega, row.re, row.im});
  return numbers;
}

}  // namespace

DrivePair measured_pair(Program& program, NodeId omega, const Receptance& receptance) {
  const NodeId place = program.place(omega, numbers_of_table(receptance));
  const auto entry = [&](int column) { return program.entry(place, column); };
  const NodeId below = entry(0), above = entry(3);
  const NodeId up = program.subtract(omega, below), down = program.subtract(above, omega);
  const auto between = [&](int column) {
    return program.multiply_add(entry(column), down, program.multiply(entry(column + 3), up));
  };
  const auto size_at = [&](int row) {
    return program.add(program.size(entry(row + 1)), program.size(entry(row + 2)));
  };
  DrivePair pair;
  pair.t = real(program, program.subtract(above, below));
  pair.q = {between(1), between(2)};
  pair.t_size = program.size(pair.t.re);
  pair.q_size = program.add(program.multiply(size_at(0), program.size(down)),
                            program.multiply(size_at(3), program.size(up)));
  const TableRanges ranges = ranges_of_table(receptance.rows);
  pair.t_range = ranges.width;
  pair.q_range = ranges.receptance + ranges.width;
  pair.elements = {-ranges.receptance.high, least_receptance};
  pair.errors = table_roundings;
  return pair;
}

}  // namespace vcrit::symbolic
