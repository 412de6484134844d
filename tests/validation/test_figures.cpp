// Figures in both forms: what is drawn is what was given, and text stays text.
#include "figures/figure.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "base/files.hpp"
#include "figures/axis_scale.hpp"
#include "figures/figure_json.hpp"
#include "figures/gnuplot.hpp"
#include "figures/svg.hpp"
#include "run/compiler.hpp"

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

// There is no place for -1 on a logarithmic axis, and none for what is no number anywhere.
BOOST_AUTO_TEST_CASE(gaps_are_null_and_the_rest_is_there) {
  const ordered_json series = figure_json(everything())["series"];
  BOOST_TEST(series[0]["points"].dump() == "[[1.0,0.0],[10.0,null],[100.0,1.0]]");
  BOOST_TEST(series[1]["points"].dump() == R"([[null,0.5,"negative"],[10.0,0.5,"here"]])");
  BOOST_TEST(series[2]["points"].dump() == "[[10.0,0.2],[100.0,0.4]]");
}

BOOST_AUTO_TEST_CASE(numbers_have_seven_digits) {
  Figure figure = everything();
  figure.series = {{"", Style::line, {{1 / 3.0, 2e10 / 3, ""}}, 0}};
  BOOST_TEST(figure_json(figure)["series"][0]["points"].dump() == "[[0.3333333,6666667000.0]]");
}

BOOST_AUTO_TEST_CASE(series_have_their_name_style_and_colour) {
  Figure figure = everything();
  std::vector<std::string> names;
  for (const Style style :
       {Style::line, Style::dashed, Style::dotted, Style::circles, Style::dots, Style::crosses,
        Style::squares, Style::triangles, Style::diamonds, Style::bars}) {
    figure.series = {{"<a>", style, {{1, 0, ""}, {10, 1, ""}}, 3}};
    const ordered_json series = figure_json(figure)["series"][0];
    BOOST_TEST(series["name"] == "<a>");
    BOOST_TEST(series["colour"] == palette(3));
    BOOST_TEST(series.contains("edges") == (style == Style::bars));
    names.push_back(series["style"]);
  }
  const std::vector<std::string> expected{"line",    "dashed",  "dotted",    "circles",  "dots",
                                          "crosses", "squares", "triangles", "diamonds", "bars"};
  BOOST_TEST(names == expected, boost::test_tools::per_element());
}

// Without colour, too: lines of any two colours, and points of any two of six numbers.
BOOST_AUTO_TEST_CASE(series_are_told_apart_in_grey) {
  std::set<std::string> dashes, shapes;
  for (const int colour : {0, 1, 2, 3, 4}) dashes.insert(dashes_of(Style::line, colour));
  for (std::size_t number = 0; number < 6; ++number) shapes.insert(name_of(shape_of(number)));
  BOOST_TEST(dashes.size() == 5u);
  BOOST_TEST(shapes.size() == 6u);
  BOOST_TEST(figure_json(everything())["series"][0]["dashes"] == "none");
}

// A picture in a page has no title of its own, and says for others what it shows.
BOOST_AUTO_TEST_CASE(a_still_is_the_figure_without_its_title) {
  Figure figure = everything();
  figure.map.reset();
  figure.series.pop_back();
  figure.title = "Friction over speed";
  figure.caption = "By simulation.";
  const std::string picture = still(figure);
  BOOST_TEST(picture.starts_with(
      "<svg class=\"still\" role=\"img\" aria-label=\"Friction over speed. By simulation.\""));
  BOOST_TEST(picture.find(">Friction over speed</text>") == picture.npos);
  BOOST_TEST(svg({figure}).find(">Friction over speed</text>") != picture.npos);
  BOOST_TEST(picture.find("stroke=\"#123f6d\"") != picture.npos);
}

// Where rules stand close words go across one of them, but not onto each other.
BOOST_AUTO_TEST_CASE(words_of_rules_stand_on_no_other_words) {
  Figure figure;
  figure.name = "close";
  figure.x = {"frequency", false, std::pair{0.0, 1.0}, {}};
  figure.y = {"v*", false, std::pair{0.0, 1.0}, {}};
  figure.rules = {{0.50, "this scene", false},
                  {0.44, "antiresonance", false},
                  {0.38, "resonance", false},
                  {0.41, "antiresonance", false}};
  const std::string picture = svg({figure});
  const std::regex words(
      "<text x=\"([0-9.]+)\" y=\"([0-9.]+)\">(this scene|(anti)?resonance)</text>");
  std::vector<std::array<double, 3>> found;  // x, y, length
  for (std::sregex_iterator each(picture.begin(), picture.end(), words), end; each != end; ++each)
    found.push_back({std::stod((*each)[1]), std::stod((*each)[2]),
                     7.0 * static_cast<double>((*each)[3].length())});
  BOOST_REQUIRE(found.size() == 4u);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const bool beside =
          found[i][0] + found[i][2] <= found[j][0] || found[j][0] + found[j][2] <= found[i][0];
      BOOST_TEST((beside || std::abs(found[i][1] - found[j][1]) >= 16));
    }
}

// 0.5 of y are 1 N; a figure without such an axis has nothing of it.
BOOST_AUTO_TEST_CASE(an_axis_at_the_right_has_its_own_unit) {
  Figure figure;
  figure.name = "right";
  figure.y = {"ratio", false, std::pair{0.0, 1.0}, {}};
  figure.series = {{"", Style::line, {{0, 0.5, ""}, {1, 1, ""}}, 0}};
  const std::string before = still(figure);
  BOOST_TEST(before.find("class=\"right\"") == std::string::npos);
  BOOST_TEST(!figure_json(figure).contains("right"));
  BOOST_TEST(gnuplot(figure).find("y2") == std::string::npos);
  figure.right = FigureAxis{"force, N", false, std::pair{0.0, 2.0}, {}};
  const std::string after = still(figure);
  BOOST_TEST(after.find(">force, N</text>") != std::string::npos);
  // "1" of the right axis stands at half the height, 320 pixels, as 0.5 of the left one does.
  BOOST_TEST(after.find("y=\"160.0\" dy=\"4\">1</text>") != std::string::npos);
  BOOST_TEST(figure_json(figure)["right"]["range"].dump() == "[0.0,2.0]");
  BOOST_TEST(gnuplot(figure).find("set y2range [0:2]") != std::string::npos);
  BOOST_TEST(gnuplot(figure).find("set y2tics") != std::string::npos);
}

// Middles 10 and 100: halfway by ratio.
BOOST_AUTO_TEST_CASE(bars_have_edges) {
  BOOST_TEST(figure_json(everything())["series"][2]["edges"].dump() ==
             "[3.162278,31.62278,316.2278]");
}

BOOST_AUTO_TEST_CASE(bands_and_rules_are_there) {
  const ordered_json record = figure_json(everything());
  BOOST_TEST(record["bands"][0]["from"] == 2);
  BOOST_TEST(record["bands"][0]["to"] == 5);
  BOOST_TEST(record["bands"][0]["words"] == "stick");
  BOOST_TEST(record["rules"][0]["at"] == 30);
  BOOST_TEST(record["rules"][0]["horizontal"] == false);
  BOOST_TEST(record["rules"][0]["words"] == "`rm`");
  BOOST_TEST(record["rules"][1]["at"] == 0.7);
  BOOST_TEST(record["rules"][1]["horizontal"] == true);
}

// Rows 0 and 1 have edges -0.5, 0.5, 1.5; columns 1, 10, 100 those halfway by ratio.
BOOST_AUTO_TEST_CASE(a_map_is_its_edges_and_values) {
  const ordered_json map = figure_json(everything())["map"];
  BOOST_TEST(map["value"]["title"] == "value");
  BOOST_TEST(map["x"].dump() == "[0.3162278,3.162278,31.62278,316.2278]");
  BOOST_TEST(map["y"].dump() == "[-0.5,0.5,1.5]");
  BOOST_TEST(map["values"].dump() == "[1.0,2.0,3.0,4.0,null,6.0]");
  BOOST_TEST(!map.contains("colours"));
}

// Values with words are classes: each has a colour of its own.
BOOST_AUTO_TEST_CASE(a_map_of_classes) {
  Figure figure = everything();
  figure.map->value.ticks = {{0, "stick"}, {2, "apart"}};
  figure.map->values = {0, 2, 0, 2, 0, 0};
  const ordered_json map = figure_json(figure)["map"];
  BOOST_TEST(map["value"]["ticks"].dump() == R"([[0.0,"stick"],[2.0,"apart"]])");
  BOOST_TEST(map["colours"].dump() == ordered_json({palette(0), "#dfe2e6"}).dump());
  const std::string script = gnuplot(figure);
  BOOST_TEST(script.find("set palette maxcolors 3 ") != std::string::npos);
  BOOST_TEST(script.find("set cbrange [-0.5:2.5]") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(axes_have_their_scale_range_and_words) {
  const ordered_json record = figure_json(everything());
  BOOST_TEST(record["x"].dump() ==
             R"({"title":"frequency, Hz","logarithmic":true,"range":[1.0,1000.0]})");
  BOOST_TEST(record["y"]["logarithmic"] == false);
  BOOST_TEST(record["y"]["ticks"].dump() == R"([[0.0,"none"],[1.0,"one"]])");
}

// A map fills its picture; without one the data say what an axis without a range shows.
BOOST_AUTO_TEST_CASE(a_map_gives_axes_their_range) {
  Figure figure = everything();
  figure.x.range.reset();
  BOOST_TEST(figure_json(figure)["x"]["range"].dump() == "[0.3162278,316.2278]");
  BOOST_TEST(figure_json(figure)["y"]["range"].dump() == "[-0.5,1.5]");
  figure.map.reset();
  BOOST_TEST(!figure_json(figure)["x"].contains("range"));
}

// Some had steps of 0, and ticks without end.
BOOST_AUTO_TEST_CASE(values_that_no_label_tells_apart_have_ticks_around_them) {
  for (const bool logarithmic : {true, false})
    for (const double value : {1e6, 1.0, 0.3, 1e-9, 1e20, 1e300})
      for (const double spread : {0.0, 1e-16, 1e-12, 4e-9, 1e-8, 1e-3}) {
        const AxisScale scale({"y", logarithmic, {}, {}}, {value, value * (1 + spread)}, 5);
        BOOST_TEST(!scale.ticks().empty());
        BOOST_TEST(scale.ticks().size() < 30u);
        // A rounding of the value is 6e-8 of the least spread that is drawn.
        const double place = scale.place(value);
        BOOST_TEST((place >= -1e-7 && place <= 1 + 1e-7));
      }
}

BOOST_AUTO_TEST_CASE(text_in_a_record_stays_text) {
  const ordered_json record = figure_json(everything());
  BOOST_TEST(record["name"] == "everything");
  BOOST_TEST(record["title"] == "Title\nwith `two` 'lines'");
  BOOST_TEST(record["height"] == 320);
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
