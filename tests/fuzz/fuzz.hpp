// What every fuzz target shares: the promise about errors, and how a broken one is told.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "base/errors.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace vcrit::fuzz {

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Ends the process, as a sanitizer does, unless `holds`.
inline void check(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

/// Runs `body`; wrong input and scenes outside the model are answers, anything else escapes.
template <class Body>
void answered(Body body) {
  try {
    body();
  } catch (const InputError& error) {
    check(!std::string(error.what()).empty(), "an error has a message");
  } catch (const ModelError& error) {
    check(!std::string(error.what()).empty(), "an error has a message");
  }
}

}  // namespace vcrit::fuzz
