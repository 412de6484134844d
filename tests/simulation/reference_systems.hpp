// The rows of tests/data/stickslip_reference.csv, which the benchmark reads, too.
#pragma once

#include "simulators/cases.hpp"
#include "support/table.hpp"

namespace vcrit::reference {

using Row = simulators::Case;

inline std::vector<Row> reference_rows() {
  const std::string table = "stickslip_reference.csv";
  std::vector<Row> rows = simulators::read_cases(VCRIT_TEST_DATA "/" + table);
  test::require_rows(rows.size(), 45, table);
  return rows;
}

}  // namespace vcrit::reference
