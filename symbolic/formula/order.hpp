// GiNaC orders the parts of an expression by where their types lie in memory: otherwise in each
// run.
#pragma once

#include <ginac/ginac.h>

#include <vector>

namespace vcrit::symbolic {

/// The terms of a sum, the factors of a product, in the order of their texts: for what depends on
/// which one comes first.
std::vector<GiNaC::ex> in_order_of_text(const GiNaC::ex& sum_or_product);

}  // namespace vcrit::symbolic
