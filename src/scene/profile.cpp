#include "scene/profile.hpp"

#include <fmt/core.h>

#include <cmath>
#include <filesystem>

#include "base/csv.hpp"
#include "base/files.hpp"
#include "base/identifiers.hpp"
#include "scene/members.hpp"

namespace vcrit {

namespace {

constexpr const char* profile_header = "r,f";

// Seconds for one speed; the profile takes the square of it.
constexpr std::size_t most_profile_rows = 2000;

/// last: the row before, none for the first one.
void refuse_profile_order(const Profile::Row* last, const Profile::Row& row, const Place& place) {
  if (last == nullptr) {
    if (row != Profile::Row{})
      throw InputError(place, fmt::format("r = {}, f = {} first", row.r, row.f),
                       "0,0: the tip of the indenter");
    return;
  }
  if (!(row.r > last->r))
    throw InputError(place, fmt::format("r = {} after {}", row.r, last->r),
                     "r increasing from row to row");
  if (!(row.f >= last->f))
    throw InputError(place, fmt::format("f = {} after {}", row.f, last->f),
                     "f that never decreases: one contact area without holes");
}

void refuse_too_few(const Profile& profile, const Place& place) {
  if (profile.rows.size() < 2)
    throw InputError(place, profile.rows.empty() ? "no row of numbers" : "one row of numbers",
                     "at least two rows: the tip and the outer radius");
}

/// The shape that is meant by a word in place of a file.
std::string advice_on_shape(const std::string& word) {
  for (const char* round : {"sphere", "spherical", "ball", "hertz", "round"})
    if (word == round)
      return "close to the contact a sphere is a parabola of its radius: shape = \"parabola\"";
  const auto meant = nearest(word, {"flat", "cone", "parabola", "power"});
  return meant ? fmt::format("did you mean \"{}\"?", *meant) : "";
}

}  // namespace

Profile read_profile(const std::string& file, const Place& place) {
  if (!std::filesystem::is_regular_file(file))
    throw InputError(
        place, fmt::format("shape = \"{}\", which is no file", file),
        fmt::format("flat, cone, parabola, power, or a table in CSV with the header {}",
                    profile_header),
        advice_on_shape(std::filesystem::path(file).filename()));
  return parse_profile(read_file(file), file);
}

Profile parse_profile(const std::string& text, const std::string& file) {
  Profile profile{file, {}};
  CsvLines lines(text, file);
  lines.take_header(profile_header);
  while (lines.next()) {
    const auto numbers = lines.numbers(2, "two numbers: r, f");
    const Profile::Row row{numbers[0], numbers[1]};
    refuse_profile_order(profile.rows.empty() ? nullptr : &profile.rows.back(), row, lines.place());
    if (profile.rows.size() == most_profile_rows)
      throw InputError(lines.place(), fmt::format("more than {} rows", most_profile_rows),
                       "at most so many: each is a place where the contact changes");
    profile.rows.push_back(row);
  }
  refuse_too_few(profile, lines.place());
  return profile;
}

void check_profile(const Profile& profile, const Place& place) {
  refuse_too_few(profile, place);
  const Profile::Row* last = nullptr;
  for (const Profile::Row& row : profile.rows) {
    refuse_profile_order(last, row, place);
    if (!std::isfinite(row.r) || !std::isfinite(row.f))
      throw InputError(place, fmt::format("r = {}, f = {}", row.r, row.f), "finite numbers");
    last = &row;
  }
}

}  // namespace vcrit
