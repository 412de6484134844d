// Drawings hold every element once, connect, and stay within their frame.
#include "report/network_drawing.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <filesystem>

#include "report/document.hpp"
#include "report/graph_layout.hpp"
#include "report/system_drawing.hpp"
#include "support/scene_text.hpp"
#include "validation/example_report.hpp"

BOOST_AUTO_TEST_SUITE(test_network_drawing)

using namespace vcrit;
using namespace vcrit::validation::report;
namespace example = vcrit::validation::example;

namespace {

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

std::string svg_of(const Picture& picture) { return rendered("drawing", record::page_of(picture)); }

std::string svg_of(const Network& network) { return svg_of({draw(network), "a network"}); }

std::vector<std::string> words_of(const Label& label) {
  std::vector<std::string> words;
  for (const Word& word : label) words.push_back(word.text);
  return words;
}

constexpr const char* spring_mark = "class=\"spring\"";
constexpr const char* damper_mark = "class=\"damper\"";

Network k(const char* name) { return spring({name}); }
Network c(const char* name) { return damper({name}); }

Graph bridge() {
  return {{"a", "b", "1", "2"},
          {k("k1"), c("c1"), k("k2"), c("c2"), k("k3")},
          {{0, 2}, {0, 3}, {2, 3}, {2, 1}, {3, 1}}};
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_element_is_drawn_once) {
  const Network network =
      parallel({k("k0"), series({k("k1"), c("c1")}), maxwell({"k", 2}, {"tau", 2})});
  const std::string svg = svg_of(network);
  BOOST_TEST(occurrences(svg, spring_mark) == 3u);  // the Maxwell branch has one of each
  BOOST_TEST(occurrences(svg, damper_mark) == 2u);
  BOOST_TEST(occurrences(svg, "<text") == 4u);
}

BOOST_AUTO_TEST_CASE(series_is_longer_and_parallel_is_higher) {
  const Drawing one = draw(k("k1"));
  const Drawing line = draw(series({k("k1"), k("k2")}));
  const Drawing stack = draw(parallel({k("k1"), k("k2")}));
  BOOST_TEST(line.width > 2 * one.width);
  BOOST_TEST(line.above == one.above);
  BOOST_TEST(stack.above + stack.below > 2 * (one.above + one.below) - 1);
  BOOST_TEST(stack.width > one.width);
}

BOOST_AUTO_TEST_CASE(a_bridge_shows_all_edges_and_nodes) {
  const std::string svg = svg_of(Network{bridge()});
  BOOST_TEST(occurrences(svg, spring_mark) == 3u);
  BOOST_TEST(occurrences(svg, damper_mark) == 2u);
  BOOST_TEST(occurrences(svg, "class=\"node\"") == 4u);
}

BOOST_AUTO_TEST_CASE(nodes_of_a_bridge_have_room_for_their_edges) {
  const double spacing = 100;
  const GraphLayout layout = lay_out(bridge(), spacing);
  BOOST_TEST(layout.nodes[0].x == 0);
  BOOST_TEST(layout.nodes[1].x == layout.width);
  for (const Wire& wire : bridge().wires) {
    const LayoutPoint from = layout.nodes[static_cast<std::size_t>(wire.from)];
    const LayoutPoint to = layout.nodes[static_cast<std::size_t>(wire.to)];
    BOOST_TEST(std::hypot(from.x - to.x, from.y - to.y) >= spacing);
  }
}

BOOST_AUTO_TEST_CASE(a_direct_edge_does_not_run_through_an_inner_node) {
  const Graph graph{{"a", "b", "1"}, {k("k1"), k("k2"), k("k3")}, {{0, 2}, {2, 1}, {0, 1}}};
  BOOST_TEST(std::abs(lay_out(graph, 100).nodes[2].y) > 20);
}

// The other edges of a bridge and one beside its middle: all parts stand where nothing else does.
BOOST_AUTO_TEST_CASE(edges_between_the_same_nodes_stand_beside_each_other) {
  Graph doubled = bridge();
  doubled.parts.push_back(k("k9"));
  doubled.wires.push_back({doubled.wires[2].to, doubled.wires[2].from});
  Graph nested = bridge();
  nested.parts[2] = parallel({nested.parts[2], k("k9")});
  BOOST_TEST(svg_of(Network{doubled}) == svg_of(Network{nested}));
}

BOOST_AUTO_TEST_CASE(an_edge_between_both_terminals_stands_beside_the_others) {
  Graph direct = bridge();
  direct.parts.push_back(k("k9"));
  direct.wires.push_back({0, 1});
  BOOST_TEST(svg_of(Network{direct}) == svg_of(parallel({Network{bridge()}, k("k9")})));
}

BOOST_AUTO_TEST_CASE(names_keep_their_indices) {
  const std::vector<std::string> k0{"k", "0", "\u200b"}, tau10{"τ", "10", "\u200b"}, m{"m"};
  BOOST_TEST(words_of(label({"k0"})) == k0, boost::test_tools::per_element());
  BOOST_TEST(words_of(label({"tau", 10})) == tau10, boost::test_tools::per_element());
  BOOST_TEST(words_of(label({"m"})) == m, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(only_what_the_scene_has_is_drawn) {
  const std::string all = svg_of(draw_system(parse_scene(example::driven_scene, "all.toml")));
  BOOST_TEST(all.find("drive") != std::string::npos);
  BOOST_TEST(all.find("body") != std::string::npos);
  BOOST_TEST(occurrences(all, spring_mark) == 5u);  // the bridge's three, once, and the drive's two
  const std::string rigid = svg_of(draw_system(parse_scene(example::rigid_scene, "rigid.toml")));
  BOOST_TEST(rigid.find("drive") == std::string::npos);
  BOOST_TEST(rigid.find("body") == std::string::npos);
  BOOST_TEST(occurrences(rigid, spring_mark) == 2u);  // along the normal and along the surface
}

BOOST_AUTO_TEST_CASE(an_isotropic_contact_shows_its_ratio) {
  const std::string svg = svg_of(draw_system(parse_scene(example::driven_scene, "all.toml")));
  BOOST_TEST(svg.find("0.8 × the same network") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(a_system_says_its_numbers) {
  const std::string svg = svg_of(draw_system(parse_scene(example::rigid_scene, "rigid.toml")));
  for (const char* words : {" = 0.3", "(t) = 0.3 + 0.1 cos ωt µm", " = 11.5 N/µm", " = 9.47 N/µm"})
    BOOST_TEST(svg.find(words) != std::string::npos, words);
  BOOST_TEST(svg.find("may open") == std::string::npos);
}

// 14 units are at least 11 pixels on a phone of 390 pixels, 8 on either side of the drawing left
// free.
BOOST_AUTO_TEST_CASE(a_drawing_can_be_read_on_a_phone) {
  constexpr double narrowest = 390 - 2 * 8, units = 14, pixels = 11;
  for (const auto& entry : std::filesystem::directory_iterator(VCRIT_SCENES)) {
    if (entry.path().extension() != ".toml") continue;
    const Picture picture = draw_system(read_scene(entry.path().string()));
    const auto page = record::page_of(picture);
    BOOST_TEST(page.at("width").get<double>() <= narrowest * units / pixels, entry.path());
  }
}

// What would be too wide has its drive above, then its numbers below, all of them.
BOOST_AUTO_TEST_CASE(a_wide_system_is_drawn_in_less_room) {
  const auto drawn = [](const test::Toml& drive, const test::Toml& tangential) {
    return svg_of(draw_system(vcrit::test::scene_of({.normal = "kn | (k1 - c1)",
                                                     .tangential = tangential,
                                                     .network = drive,
                                                     .frequency = 2e4,
                                                     .amplitude = 1e-7,
                                                     .indentation = 5e-7,
                                                     .coefficient = 0.25,
                                                     .elements = {{"kn", 8e6},
                                                                  {"k1", 4e6},
                                                                  {"c1", 30},
                                                                  {"kd", 2e6},
                                                                  {"cd", 5},
                                                                  {"kt", 3e6},
                                                                  {"ct", 7}}})));
  };
  const std::vector<std::string> numbers{"= 8 N/µm", "= 4 N/µm", "= 30 N.s/m", "= 2 N/µm", "0.25"};
  for (const auto& [drive, tangential] :
       {std::pair("kd", test::Toml()), std::pair("kd - cd", test::Toml()),
        std::pair("kd - cd", test::Toml("kt - ct"))}) {
    const std::string svg = drawn(drive, tangential);
    for (const std::string& number : numbers)
      BOOST_TEST(occurrences(svg, number) == 1U, drive << ", " << number);
  }
}

// A generalized Kelvin element names its spring twice, and two networks may have one spring.
BOOST_AUTO_TEST_CASE(a_number_is_listed_once) {
  const std::string svg =
      svg_of(draw_system(vcrit::test::scene_of({.normal = "kn | generalized_kelvin(k, tau, 2)",
                                                .tangential = "kn | (k1 - c1)",
                                                .network = "kd - cd",
                                                .elements = {{"kn", 8e6},
                                                             {"k", std::vector{3e6, 5e6}},
                                                             {"tau", std::vector{2e-6, 9e-6}},
                                                             {"k1", 4e6},
                                                             {"c1", 30},
                                                             {"kd", 2e6},
                                                             {"cd", 7}}})));
  for (const char* number : {"= 8 N/µm", "= 3 N/µm", "= 5 N/µm", "= 2 µs", "= 4 N/µm"})
    BOOST_TEST(occurrences(svg, number) == 1U, number);
}

// Its line is 8 below the upper edge of the foot; the body's lower edge is at 0.
BOOST_AUTO_TEST_CASE(a_high_network_along_the_surface_stays_below_the_body) {
  const Picture picture = draw_system(vcrit::test::scene_of(
      {.normal = "kn",
       .tangential = "k1 | k2 | k3 | k4",
       .elements = {{"kn", 8e6}, {"k1", 4e6}, {"k2", 4e6}, {"k3", 4e6}, {"k4", 4e6}}}));
  const double above = draw(parallel({k("k1"), k("k2"), k("k3"), k("k4")})).above;
  const auto& shapes = picture.drawing.shapes;
  const auto foot = std::find_if(shapes.begin(), shapes.end(), [](const DrawnShape& shape) {
    return shape.style == "solid" && shape.d.find('h') != std::string::npos;
  });
  BOOST_REQUIRE((foot != shapes.end()));
  BOOST_TEST(std::stod(foot->d.substr(foot->d.find(' '))) + 8 >= above);
}

// A network that stands has its words beside it, and they are read without tilting one's head.
BOOST_AUTO_TEST_CASE(words_of_a_standing_network_are_upright) {
  const Drawing one = draw(k("k1"), {true, {}});
  BOOST_TEST(one.above > one.below);
  const auto words =
      std::find_if(one.shapes.begin(), one.shapes.end(),
                   [](const DrawnShape& shape) { return shape.form == DrawnShape::Form::text; });
  BOOST_REQUIRE((words != one.shapes.end()));
  BOOST_TEST(words->transform.starts_with("rotate(-90 "));
  BOOST_TEST(words->anchor == "start");
  BOOST_TEST(standing(one).front().transform.starts_with("rotate(90)"));
}

BOOST_AUTO_TEST_CASE(of_many_branches_some_are_drawn) {
  std::vector<Network> parts{k("k0")};
  for (int i = 1; i <= 100; ++i) parts.push_back(maxwell({"k", i}, {"tau", i}));
  const std::string svg = svg_of(parallel(parts));
  BOOST_TEST(occurrences(svg, spring_mark) == 5u);
  BOOST_TEST(svg.find("and 96 more") != std::string::npos);
  parts.resize(6);
  BOOST_TEST(occurrences(svg_of(parallel(parts)), spring_mark) == 6u);
}

BOOST_AUTO_TEST_SUITE_END()
