// Sorting of what is dear to move. std::sort and std::stable_sort move it in a dozen loops, which
// takes a compiler a second for a type of several texts; the nodes of a list stay where they are.
#pragma once

#include <algorithm>
#include <iterator>
#include <list>
#include <vector>

namespace vcrit {

/// In order; those of which neither is before the other stay as they stood.
template <class T, class Before>
void sort_stably(std::vector<T>& all, Before before) {
  std::list<T> chain(std::make_move_iterator(all.begin()), std::make_move_iterator(all.end()));
  chain.sort(before);
  std::move(chain.begin(), chain.end(), all.begin());
}

}  // namespace vcrit
