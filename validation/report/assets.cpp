#include "report/assets.hpp"

#define VCRIT_ASSET(name) extern "C" const char vcrit_##name[], vcrit_##name##_end[]
VCRIT_ASSET(style);
VCRIT_ASSET(page);
VCRIT_ASSET(scales);
VCRIT_ASSET(drawing);
VCRIT_ASSET(charts);
VCRIT_ASSET(scrubber);
VCRIT_ASSET(cycle);
VCRIT_ASSET(explorer_style);
VCRIT_ASSET(simulator_script);
VCRIT_ASSET(explorer_words);
VCRIT_ASSET(explorer_curves);
VCRIT_ASSET(explorer);
VCRIT_ASSET(index);
VCRIT_ASSET(simulator);
VCRIT_ASSET(page_templates);
#undef VCRIT_ASSET

namespace vcrit::validation::report {

namespace {

std::string_view between(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace

const std::vector<std::string_view>& scripts() {
  static const std::vector<std::string_view> all{
      page_script(), between(vcrit_scales, vcrit_scales_end),
      between(vcrit_drawing, vcrit_drawing_end), between(vcrit_charts, vcrit_charts_end)};
  return all;
}

std::string_view page_script() { return between(vcrit_page, vcrit_page_end); }

std::string_view style() { return between(vcrit_style, vcrit_style_end); }

std::string_view templates() { return between(vcrit_page_templates, vcrit_page_templates_end); }

std::string_view scrubber_script() { return between(vcrit_scrubber, vcrit_scrubber_end); }

std::string_view cycle_script() { return between(vcrit_cycle, vcrit_cycle_end); }

const std::vector<std::string_view>& explorer_scripts() {
  static const std::vector<std::string_view> all{
      scrubber_script(), between(vcrit_simulator_script, vcrit_simulator_script_end),
      between(vcrit_explorer_words, vcrit_explorer_words_end),
      between(vcrit_explorer_curves, vcrit_explorer_curves_end),
      between(vcrit_explorer, vcrit_explorer_end)};
  return all;
}

std::string_view explorer_style() {
  return between(vcrit_explorer_style, vcrit_explorer_style_end);
}

std::string_view simulator() { return between(vcrit_simulator, vcrit_simulator_end); }

std::string_view index_script() { return between(vcrit_index, vcrit_index_end); }

}  // namespace vcrit::validation::report
