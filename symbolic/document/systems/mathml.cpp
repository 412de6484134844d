// Presentation MathML: a table of equations, and one of what the symbols are.
#include "base/plain_text.hpp"
#include "document/systems/system.hpp"

namespace vcrit::symbolic {

namespace {

// XML has neither control characters nor U+FFFE and U+FFFF.
std::string in_xml(std::string_view text) {
  std::string out;
  for (const char c : one_line(text)) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else
      out += c;
    if (out.ends_with("\xEF\xBF\xBE") || out.ends_with("\xEF\xBF\xBF")) out.back() = '\xBD';
  }
  return out;
}

}  // namespace

extern const AlgebraSystem mathml{.name = "mathml",
                                  .result = "v*",
                                  .spelled = with_index,
                                  .another = with_underscore,
                                  .escape = in_xml};

}  // namespace vcrit::symbolic
