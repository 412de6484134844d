#include "base/sort_stably.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string>
#include <utility>

BOOST_AUTO_TEST_SUITE(test_sort_stably)

using namespace vcrit;

// More than std::sort leaves in their order by chance.
BOOST_AUTO_TEST_CASE(those_of_one_rank_stay_as_they_stood) {
  std::vector<std::pair<int, std::string>> all;
  for (int i = 0; i < 100; ++i) all.emplace_back(-(i % 3), std::to_string(i));
  sort_stably(all, [](const auto& a, const auto& b) { return a.first < b.first; });
  BOOST_TEST(all.size() == 100u);
  BOOST_TEST(all[0].second == "2");
  BOOST_TEST(all[32].second == "98");
  BOOST_TEST(all[33].second == "1");
  BOOST_TEST(all[99].second == "99");
  BOOST_TEST(std::is_sorted(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first, std::stoi(a.second)) < std::pair(b.first, std::stoi(b.second));
  }));
}

BOOST_AUTO_TEST_SUITE_END()
