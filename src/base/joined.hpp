// Texts one after another. fmt::join does the same and is compiled in every file that asks for it.
#pragma once

#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace vcrit {

/// All of them, with the separator between two.
std::string joined(const std::vector<std::string>& texts, std::string_view separator);
template <class Texts>
std::string joined(const Texts& texts, std::string_view separator) {
  return joined(std::vector<std::string>(std::begin(texts), std::end(texts)), separator);
}

}  // namespace vcrit
