// Every way to K(s) that needs no other program gives an answer on networks of its kind. Nothing is
// timed.
#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "harness/network_json.hpp"
#include "record/json_text.hpp"
#include "scaling/peers.hpp"

BOOST_AUTO_TEST_SUITE(test_scaling)

using namespace vcrit;
using namespace vcrit::scaling;

namespace {

bool is_script(const ScalingPeer& peer) {
  return peer.name.starts_with("SymPy") || peer.name.starts_with("Maxima");
}

/// Composition by hand and FLINT by hand are not for graphs.
bool is_for_trees(const ScalingPeer& peer) {
  return peer.name == "GiNaC, composed" || peer.name == "FLINT, by hand";
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_way_answers) {
  for (const auto& peers : {nested_peers(), expanded_peers()})
    for (const ScalingPeer& peer : peers)
      for (const ScalingCase& each : {ladder(6), prony(3), bridge()}) {
        if (is_script(peer)) continue;
        const bool asked = !is_for_trees(peer) || each.name != "bridge";
        BOOST_TEST(peer.seconds(each).has_value() == asked, peer.name << ", " << each.name);
      }
  for (const auto seconds : {whole_derivation, all_limits, all_sensitivities})
    BOOST_TEST(seconds(bridge()) > 0);
}

// k1 | (k2 - c1), and the mesh of a graph: what scripts in Python are told.
BOOST_AUTO_TEST_CASE(a_network_is_told_step_by_step) {
  const Network network = parallel(
      {spring({"k1"}), series({spring({"k2"}), damper({"c1"})}), maxwell({"k3"}, {"tau"})});
  const auto steps = bench::network_json(network);
  const auto is_there = [&](const nlohmann::ordered_json& step) {
    return std::find(steps.begin(), steps.end(), step) != steps.end();
  };
  BOOST_TEST(steps.size() == 7U);
  for (const char* element :
       {R"(["spring","k1"])", R"(["damper","c1"])", R"(["maxwell","k3","tau"])"})
    BOOST_TEST(is_there(record::read_json(element)), element);
  BOOST_TEST(steps.back()[0] == "parallel");
  BOOST_TEST(record::json_text(bench::network_json(bridge().network)).find("mesh") !=
             std::string::npos);
}

BOOST_AUTO_TEST_SUITE_END()
