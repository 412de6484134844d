// Properties over random cases by RapidCheck. The seed is fixed so that a run can be repeated, and
// printed; RC_PARAMS="seed=1 max_success=10000" in the environment takes its place.
#pragma once

#include <rapidcheck/boost_test.h>

#include <cstdlib>

namespace vcrit::properties {

struct FixedSeed {
  FixedSeed() { setenv("RC_PARAMS", "seed=20240607 max_success=300", 0); }
};
BOOST_TEST_GLOBAL_FIXTURE(FixedSeed);

}  // namespace vcrit::properties
