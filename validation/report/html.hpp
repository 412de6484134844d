// Text made safe for scripts in the page and for a shell; as markup: record/html_text.hpp.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace vcrit::validation::report {

/// JSON as the content of a <script type="application/json">: no character that could end it.
std::string json_for_page(const nlohmann::ordered_json& value);

/// One word of a command line, quoted if a shell would read it otherwise.
std::string shell_word(const std::string& word);

}  // namespace vcrit::validation::report
