// The table of languages, and names that one of them refuses.
#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "base/errors.hpp"
#include "base/joined.hpp"
#include "emit/languages/language.hpp"
#include "emit/names.hpp"

namespace vcrit::symbolic {

#define VCRIT_LANGUAGE(folder) extern const Language folder;
#include "emit/languages/languages.inc"
#undef VCRIT_LANGUAGE

namespace {

[[noreturn]] void refuse_in_language(const Place& place, const std::string& name,
                                     const std::string& why, const Language& language) {
  throw InputError(place,
                   fmt::format("\"{}\", which is {} (language {})", name, why, language.name),
                   "another name, of letters, digits and underscores");
}

}  // namespace

const std::vector<const Language*>& languages() {
  static const std::vector<const Language*> all{
#define VCRIT_LANGUAGE(folder) &folder,
#include "emit/languages/languages.inc"
#undef VCRIT_LANGUAGE
  };
  return all;
}

const std::vector<std::string>& language_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Language* language : languages()) all.emplace_back(language->name);
    return all;
  }();
  return names;
}

const Language& language_of(const GenerateOptions& options) {
  for (const Language* language : languages()) {
    if (language->name != options.language) continue;
    if (options.quantities && !language->has_quantities)
      throw InputError(argument("quantities"), fmt::format("the language {}", options.language),
                       "c++, the only one with other quantities");
    return *language;
  }
  throw InputError(argument("language"), fmt::format("\"{}\"", options.language),
                   fmt::format("one of {}", joined(language_names(), ", ")));
}

bool is_among(std::string_view words, std::string_view name) {
  std::istringstream all{std::string(words)};
  for (std::string word; all >> word;)
    if (word == name) return true;
  return false;
}

void check_library_name(const std::string& name, const Language& language) {
  check_library_name(name);
  if (is_among(language.reserved, name))
    refuse_in_language(argument("name"), name, "a reserved word", language);
  if (is_among(language.taken, name)) refuse_in_language(argument("name"), name, "taken", language);
}

void check_member_names(const Problem& problem, const std::vector<Symbol>& symbols,
                        const Language& language) {
  check_member_names(problem, symbols);
  for (const Symbol& symbol : symbols)
    if (const std::string name = as_called(problem, symbol).name; is_among(language.reserved, name))
      refuse_in_language({problem->source->file}, name, "a reserved word", language);
}

}  // namespace vcrit::symbolic
