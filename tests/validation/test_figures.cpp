// Figures in both forms: what is drawn is what was given, and text stays text.
#include "figures/figure.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>

#include "base/files.hpp"
#include "compiler.hpp"
#include "figures/gnuplot.hpp"
#include "figures/vega_lite.hpp"

BOOST_AUTO_TEST_SUITE(test_figures)

using namespace vcrit;
using namespace vcrit::validation;
using namespace vcrit::validation::figures;
using nlohmann::ordered_json;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Figure everything() {
  Figure figure;
  figure.name = "everything";
  figure.title = "Title\nwith `two` 'lines'";
  figure.x = {"frequency, Hz", true, std::pair{1.0, 1000.0}, {}};
  figure.y = {"it's", false, {}, {{0, "none"}, {1, "one"}}};
  figure.series = {{"a", Style::line, {{1, 0, ""}, {10, nan, ""}, {100, 1, ""}}, 0},
                   {"a", Style::circles, {{-1, 0.5, "negative"}, {10, 0.5, "here"}}, 0},
                   {"", Style::bars, {{10, 0.2, ""}, {100, 0.4, ""}}, 3}};
  figure.bands = {{2, 5, "stick"}};
  figure.rules = {{30, "`rm`", false}, {0.7, "level", true}};
  Map map;
  map.value = {"value", false, {}, {}};
  map.x = {1, 10, 100};
  map.y = {0, 1};
  map.values = {1, 2, 3, 4, nan, 6};
  figure.map = map;
  return figure;
}

const ordered_json& layer_with(const ordered_json& spec, const std::string& mark) {
  for (const ordered_json& layer : spec["layer"])
    if (layer["mark"]["type"] == mark) return layer;
  throw std::runtime_error("no " + mark);
}

}  // namespace

// Middles 1, 10, 100: halfway by ratio, and as far beyond the outer ones.
BOOST_AUTO_TEST_CASE(edges_lie_halfway) {
  const std::vector<double> expected{1 / std::sqrt(10), std::sqrt(10), std::sqrt(1000),
                                     100 * std::sqrt(10)};
  const std::vector<double> found = edges({1, 10, 100}, true);
  BOOST_REQUIRE(found.size() == 4u);
  // Two roots, a product and a quotient: 4 roundings.
  for (std::size_t i = 0; i < 4; ++i)
    BOOST_TEST(std::abs(found[i] / expected[i] - 1) < 4 * 0x1p-52);
  const std::vector<double> even = edges({1, 2, 4}, false), by_hand{0.5, 1.5, 3, 5};
  BOOST_TEST(even == by_hand, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(gaps_are_null_and_the_rest_is_there) {
  const ordered_json spec = vega_lite(everything());
  const ordered_json& line = layer_with(spec, "line")["data"]["values"];
  BOOST_TEST(line.size() == 3u);
  BOOST_TEST(line[1]["y"].is_null());
  BOOST_TEST(line[2]["x"] == 100);
  const ordered_json& circles = layer_with(spec, "point")["data"]["values"];
  BOOST_TEST(circles[0]["x"].is_null());  // no place for -1 on a logarithmic axis
  BOOST_TEST(circles[1]["words"] == "here");
}

// Rows 0 and 1 have edges -0.5, 0.5, 1.5; columns 1, 10, 100 those halfway by ratio.
BOOST_AUTO_TEST_CASE(a_map_is_its_edges_and_values) {
  const ordered_json spec = vega_lite(everything());
  const ordered_json& grid = spec["layer"][0]["data"]["grid"];
  BOOST_TEST(grid["x"].dump() == "[0.3162278,3.162278,31.62278,316.2278]");
  BOOST_TEST(grid["y"].dump() == "[-0.5,0.5,1.5]");
  BOOST_TEST(grid["v"].dump() == "[1.0,2.0,3.0,4.0,null,6.0]");
}

// Values with words are classes: each has its colour of the palette, and its words in the legend.
BOOST_AUTO_TEST_CASE(a_map_of_classes) {
  Figure figure = everything();
  figure.map->value.ticks = {{0, "stick"}, {2, "apart"}};
  figure.map->values = {0, 2, 0, 2, 0, 0};
  const ordered_json fill = vega_lite(figure)["layer"][0]["encoding"]["fill"];
  BOOST_TEST(fill["type"] == "ordinal");
  BOOST_TEST(fill["scale"]["domain"].dump() == "[0.0,2.0]");
  BOOST_TEST(fill["scale"]["range"][1] == palette(2));
  BOOST_TEST(fill["legend"]["labelExpr"].get<std::string>().find("apart") != std::string::npos);
  const std::string script = gnuplot(figure);
  BOOST_TEST(script.find("set palette maxcolors 3 ") != std::string::npos);
  BOOST_TEST(script.find("set cbrange [-0.5:2.5]") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(one_entry_of_the_legend_for_one_name) {
  const ordered_json spec = vega_lite(everything());
  BOOST_TEST(layer_with(spec, "line")["encoding"]["color"]["scale"]["domain"].dump() == "[\"a\"]");
}

BOOST_AUTO_TEST_CASE(axes_have_their_scale_range_and_words) {
  const ordered_json spec = vega_lite(everything());
  const ordered_json& encoding = layer_with(spec, "line")["encoding"];
  BOOST_TEST(encoding["x"]["scale"]["type"] == "log");
  BOOST_TEST(encoding["x"]["scale"]["domain"].dump() == "[1.0,1000.0]");
  BOOST_TEST(encoding["x"]["title"] == "frequency, Hz");
  BOOST_TEST(encoding["y"]["axis"]["values"].dump() == "[0.0,1.0]");
}

// Nothing in a script can begin a line or a substitution of its own.
BOOST_AUTO_TEST_CASE(text_in_a_script_stays_text) {
  const std::string script = gnuplot(everything());
  BOOST_TEST(script.rfind("# 'Title with `two` ''lines'''\n", 0) == 0u);
  BOOST_TEST(script.find("set ylabel 'it''s'\n") != script.npos);
  BOOST_TEST(script.find("set label '`rm`' at") != script.npos);
}

BOOST_AUTO_TEST_CASE(gnuplot_takes_the_script) {
  const auto program = find_program("gnuplot");
  BOOST_REQUIRE(program.has_value());  // ./dev test installs it
  const PrivateFolder folder;
  write_file(folder.path() / "figure.gp", gnuplot(everything()));
  const ProgramResult result =
      run_program({*program, "figure.gp"}, folder.path(), std::chrono::minutes(1));
  BOOST_TEST(result.succeeded(), result.output);
  const std::string svg = read_file(folder.path() / "everything.svg");
  BOOST_TEST(svg.find("<svg") != svg.npos);
  BOOST_TEST(svg.find("frequency, Hz") != svg.npos);
  BOOST_TEST(read_file(folder.path() / "everything.pdf").rfind("%PDF", 0) == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
