// Tables of an indenter's profile. What is accepted begins at its tip, goes outwards, never falls,
// is finite, and reads back from its own numbers.
#include <cmath>

#include "base/numbers.hpp"
#include "fuzz.hpp"
#include "scene/profile.hpp"

using namespace vcrit;

namespace {

void check_rows(const std::vector<Profile::Row>& rows) {
  fuzz::check(rows.front() == Profile::Row{}, "the tip is first");
  std::string text = "r,f\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [r, f] = rows[i];
    fuzz::check(std::isfinite(r) && std::isfinite(f), "a profile is finite");
    if (i > 0) fuzz::check(r > rows[i - 1].r && f >= rows[i - 1].f, "r rises and f does not fall");
    text += to_text(r) + "," + to_text(f) + "\n";
  }
  fuzz::check(parse_profile(text, "again.csv").rows == rows, "a table reads back");
}

}  // namespace

void fuzz::read_profile(const std::string& text) {
  fuzz::answered([&] {
    const Profile profile = parse_profile(text, "profile.csv");
    fuzz::check(profile.rows.size() >= 2, "a table has two rows");
    check_rows(profile.rows);
  });
}
