// The rows of tests/data/stickslip_reference.csv, which the benchmark reads, too.
#pragma once

#include "benchmark/cases.hpp"

namespace vcrit::reference {

using Row = benchmark::Case;

inline std::vector<Row> reference_rows() {
  return benchmark::read_cases(VCRIT_TEST_DATA "/stickslip_reference.csv");
}

}  // namespace vcrit::reference
