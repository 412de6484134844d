// Text from a record and templates in the language of Mustache (mustache.github.io), for pages and
// documents. What it does beyond and against that language:
//
//   {{velocity | quantity m/s}}   a number by a format: one with a name, or one of fmt (.4g, +.3f);
//                                 an argument @unit is what the record says under "unit"
//   {{#rows}}{{@number}}{{/rows}} the number in a list, from 0; {{@place}} counts from 1, and
//                                 {{@last}} is true in its last item
//   {{#rows.@any}}, {{rows.@count}}  whether a list has items, and how many
//   a key that the record has not is a Bug: a misspelt one cannot vanish in silence
//   every text is escaped, whatever the braces; {{{ }}} and {{& }} are refused. Only Markup
//   (record/fields.hpp) stands as it is
//   a template ends without its last line break, so that it may stand within a line
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace vcrit::record {

/// A number as people read it; `argument` is what stands behind the format's name.
using NumberFormat = std::string (*)(double value, const std::string& argument);

class Templates {
 public:
  /// `packed`: name, zero, text, zero, the same again. `escape` makes a text safe where it is
  /// going.
  Templates(std::string_view packed, std::string (*escape)(std::string_view),
            std::map<std::string, NumberFormat> formats = {});

  /// Throws Bug for a template or a partial that is not there, a key that the record has not, and
  /// what is no Mustache.
  std::string render(const std::string& name, const nlohmann::ordered_json& record) const;

 private:
  friend class Lookup;
  std::map<std::string, std::string, std::less<>> texts_;
  std::string (*escape_)(std::string_view);
  std::map<std::string, NumberFormat> formats_;
};

}  // namespace vcrit::record
