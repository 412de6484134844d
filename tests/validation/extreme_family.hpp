// One family of scenes at coarse extremes, by honest witnesses or by planted faults.
#pragma once

#include <algorithm>
#include <string>

#include "compiler.hpp"
#include "extremes/examine.hpp"

namespace vcrit::validation::example {

inline const extremes::Family& family(const std::string& key) {
  const auto& all = extremes::families();
  return *std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.key == key; });
}

/// Compiled once.
inline const extremes::Witnesses& honest() {
  static const Scene scene = scene_of(family("elastic"));
  static const extremes::Witnesses witnesses = extremes::witnesses_of(scene, find_compiler());
  return witnesses;
}

inline extremes::FamilyResult elastic(const extremes::Witnesses& witnesses) {
  const Scene scene = scene_of(family("elastic"));
  return examine(family("elastic"), scene, witnesses, {4, 5, 2}, [](const std::string&) {});
}

/// The answers of one way changed: change(way, cells).
template <class Change>
extremes::Witnesses faulty(const std::string& way, const Change& change) {
  extremes::Witnesses witnesses = honest();
  witnesses.evaluate = [way, change](const accuracy::Cells& cells) {
    auto all = honest().evaluate(cells);
    for (extremes::Claimed& claimed : all)
      if (claimed.way == way) change(claimed, cells);
    return all;
  };
  return witnesses;
}

inline extremes::Extremes extremes_of(const extremes::FamilyResult& result) {
  return {"a compiler", {result}};
}

}  // namespace vcrit::validation::example
