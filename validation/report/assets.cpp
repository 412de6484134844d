#include "report/assets.hpp"

#define VCRIT_SCRIPT(symbol, name, version) \
  extern "C" const char vcrit_##symbol[], vcrit_##symbol##_end[];
#include "asset_scripts.inc"
#undef VCRIT_SCRIPT
extern "C" const char vcrit_style[], vcrit_style_end[], vcrit_explorer[], vcrit_explorer_end[];

namespace vcrit::validation::report {

namespace {

std::string_view between(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace

const std::vector<Script>& scripts() {
  static const std::vector<Script> all{
#define VCRIT_SCRIPT(symbol, name, version) \
  {name, version, between(vcrit_##symbol, vcrit_##symbol##_end)},
#include "asset_scripts.inc"
#undef VCRIT_SCRIPT
  };
  return all;
}

std::string_view style() { return between(vcrit_style, vcrit_style_end); }

std::string_view explorer_script() { return between(vcrit_explorer, vcrit_explorer_end); }

}  // namespace vcrit::validation::report
