// v* as a product above a line over one below it. A mount multiplies by |Q_n|, by which |K_n|
// divides: left in both, it would make both of them larger, and the range of doubles shorter.
#pragma once

#include <algorithm>
#include <vector>

namespace vcrit::symbolic {

/// Divides by a number that is never 0: takes it from `above`, where it stands there, else puts it
/// `below`. A Factor is a number of the program, its ComplexNode `value`.
template <class Factor>
void divide_by(std::vector<Factor>& above, std::vector<Factor>& below, const Factor& divisor) {
  const auto same = std::find_if(above.begin(), above.end(), [&](const Factor& factor) {
    return factor.value.re == divisor.value.re && factor.value.im == divisor.value.im;
  });
  if (same == above.end())
    below.push_back(divisor);
  else
    above.erase(same);
}

}  // namespace vcrit::symbolic
