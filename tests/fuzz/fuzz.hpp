// The fuzz targets, and what they share: the promise about errors, and how a broken one is told.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "base/errors.hpp"

namespace vcrit::fuzz {

// Each reads any text, and ends the process where what the head of its file promises is broken.
void read_scene(const std::string& text);
void read_expression(const std::string& text);
void read_setting(const std::string& text);
void read_quantity(const std::string& text);
void read_receptance(const std::string& text);
void read_profile(const std::string& text);
void read_fit_data(const std::string& text);
void read_axis(const std::string& text);

/// Whether a call ends with a number of four digits or more: prony(k0, k, tau, 100000). Many
/// branches take long and show nothing that few do not.
inline bool many_branches(const std::string& text) {
  const std::string digits = "0123456789";
  for (auto end = text.find(')'); end != text.npos; end = text.find(')', end + 1)) {
    const auto last = text.find_last_not_of(" \t\n", end - (end > 0 ? 1 : 0));
    if (last == text.npos) continue;
    const auto before = text.find_last_not_of(digits, last);
    if (before != text.npos && last - before >= 4) return true;
  }
  return false;
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
