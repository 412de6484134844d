// What the named rheologies are called and stand for.
#pragma once

#include <string>

namespace vcrit::validation::report {

struct RheologyWords {
  std::string called;   ///< the name in the literature
  std::string meaning;  ///< a sentence or two, text
};

/// Throws Bug for a name that is not in the catalogue.
const RheologyWords& words_of(const std::string& rheology);

}  // namespace vcrit::validation::report
