// Tables of a measured drive. What is accepted rises in omega, is finite, and reads back from its
// own numbers.
#include <cmath>

#include "base/numbers.hpp"
#include "fuzz.hpp"
#include "scene/receptance.hpp"

using namespace vcrit;

namespace {

void check_rows(const std::vector<Receptance::Row>& rows) {
  std::string text = "omega,Re,Im\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [omega, re, im, line] = rows[i];
    fuzz::check(line > (i == 0 ? 0 : rows[i - 1].line), "rows come line by line");
    fuzz::check(std::isfinite(re) && std::isfinite(im), "a receptance is finite");
    fuzz::check(omega >= (i == 0 ? 0 : std::nextafter(rows[i - 1].omega, INFINITY)),
                "omega rises from 0 or more");
    text += to_text(omega) + "," + to_text(re) + "," + to_text(im) + "\n";
  }
  fuzz::check(parse_receptance(text, "again.csv").rows == rows, "a table reads back");
}

}  // namespace

void fuzz::read_receptance(const std::string& text) {
  fuzz::answered([&] {
    const Receptance receptance = parse_receptance(text, "drive.csv");
    fuzz::check(receptance.rows.size() >= 2, "a table has two rows");
    check_rows(receptance.rows);
    const Bracket last = bracket(receptance, receptance.rows.back().omega);
    fuzz::check(last.below == receptance.rows.back(), "a row is found");
  });
}
