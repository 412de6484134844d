// The sections of a scene and their keys, and what to say of a key that is none of them.
#pragma once

#include <string>
#include <vector>

namespace vcrit::document {

/// The keys of [name], of the top level where the name is empty. Throws Bug for a section whose
/// keys are the user's.
const std::vector<std::string>& keys_of(const std::string& name);

/// What to do in place of writing that key in that section ("contact", "" for the top level): for
/// keys of other sections, and for words that people write who know the matter and not the format.
/// May be empty.
std::string advice_on_key(const std::string& key, const std::string& section);

}  // namespace vcrit::document
