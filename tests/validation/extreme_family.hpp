// One family of scenes at coarse extremes, by honest witnesses or by planted faults.
#pragma once

#include <algorithm>
#include <string>

#include "extremes/examine.hpp"
#include "run/compiler.hpp"

namespace vcrit::validation::example {

inline const extremes::Family& family(const std::string& key) {
  const auto& all = extremes::families();
  return *std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.key == key; });
}

/// Compiled once.
inline const extremes::Subjects& honest() {
  static const extremes::Subjects subjects =
      extremes::subjects_of(symbolic::derive(problem_of(family("elastic"))), find_compiler());
  return subjects;
}

inline extremes::FamilyResult elastic(const extremes::Subjects& subjects) {
  return examine(family("elastic"), symbolic::derive(problem_of(family("elastic"))), subjects,
                 {4, 5, 2}, [](const std::string&) {});
}

/// The answers of one way changed: change(way, cells).
template <class Change>
extremes::Subjects faulty(const std::string& way, const Change& change) {
  extremes::Subjects subjects = honest();
  subjects.evaluate = [way, change](const accuracy::Cells& cells) {
    auto all = honest().evaluate(cells);
    for (extremes::Claimed& claimed : all)
      if (claimed.way == way) change(claimed, cells);
    return all;
  };
  return subjects;
}

inline extremes::Extremes extremes_of(const extremes::FamilyResult& result) {
  return {"a compiler", {result}};
}

}  // namespace vcrit::validation::example
