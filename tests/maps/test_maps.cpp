// Streamed sweeps: the file holds what the sweep in memory gives, whether it was written at one go
// or in pieces.
#include <tbb/global_control.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <fstream>
#include <sstream>
#include <vector>

#include "base/numbers.hpp"
#include "maps/arrays.hpp"
#include "maps/netcdf_file.hpp"
#include "maps/part.hpp"
#include "maps/stream.hpp"
#include "scene/scene.hpp"
#include "support/program.hpp"
#include "support/scene_text.hpp"

BOOST_AUTO_TEST_SUITE(test_maps)

namespace {

using namespace vcrit;
namespace fs = std::filesystem;

Sweep sweep_over(const std::vector<std::string>& axes, const std::vector<std::string>& quantities,
                 const std::string& scene = "zener.toml") {
  Sweep sweep{read_scene(VCRIT_SCENES "/" + scene), {}, {}, {}, {}};
  for (const std::string& axis : axes) sweep.axes.push_back(parse_axis(axis, sweep.problem));
  for (const std::string& quantity : quantities)
    sweep.quantities.push_back(parse_swept_quantity(quantity, sweep.problem));
  return sweep;
}

// Many blocks of every kind of value.
Sweep motion_map() {
  return sweep_over(
      {"amplitude=lin:0.1 um:0.6 um:9", "k1=lin:1e6:9e6:20", "velocity_ratio=lin:0.2:1.2:80"},
      {"friction_ratio", "regime", "critical_velocity"});
}

maps::Streamed streamed(const Sweep& sweep, const fs::path& file, bool resume = false,
                        std::size_t stop_after = 0) {
  maps::Ranks ranks;
  const Sweeping sweeping(sweep);
  maps::StreamOptions options;
  options.resume = resume;
  options.open_array = maps::array_opener();
  if (stop_after > 0)
    options.told = [left = stop_after](const maps::StreamProgress&) mutable {
      if (--left == 0) throw std::runtime_error("stopped");
    };
  return maps::stream(sweeping, file, options, ranks);
}

// Stops it again and again, a few blocks later each time.
void in_pieces(const Sweep& sweep, const fs::path& file) {
  for (std::size_t blocks = 1;; ++blocks) try {
      streamed(sweep, file, true, blocks);
      return;
    } catch (const std::runtime_error& error) {
      BOOST_TEST_REQUIRE(std::string(error.what()) == "stopped");
      BOOST_TEST_REQUIRE(!fs::exists(file));
      BOOST_TEST_REQUIRE(fs::exists(maps::part_of(file)));
    }
}

std::string message(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

std::vector<double> read_array(const fs::path& path, const std::string& name, std::size_t size) {
  netcdf::File file = netcdf::File::open(path, NC_NOWRITE);
  int group = file.id(), array = -1;
  if (name == "blocks") netcdf::call(nc_inq_grp_ncid, file.id(), "progress", &group);
  netcdf::call(nc_inq_varid, group, name.c_str(), &array);
  std::vector<double> values(size);
  netcdf::call(nc_get_var_double, group, array, values.data());
  file.close();
  return values;
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// In memory; the thread sanitizer does not understand TBB's hand-over to others.
SweptTable swept_by_one_thread(const Sweep& sweep) {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  return swept(sweep);
}

BOOST_AUTO_TEST_CASE(an_array_holds_the_sweep) {
  const test::PrivateFolder folder;
  const fs::path file = folder.path() / "map.h5";
  const Sweep sweep = motion_map();
  const SweptTable table = swept_by_one_thread(sweep);
  const maps::Streamed result = streamed(sweep, file);
  BOOST_TEST(result.rows == table.rows);
  BOOST_TEST(result.found == table.rows);
  BOOST_TEST(result.outside == table.outside);
  BOOST_TEST(table.outside > 0U);
  for (std::size_t q = 0; q < 3; ++q) {
    const auto values = read_array(file, table.columns[3 + q], table.rows);
    for (std::size_t row = 0; row < table.rows; ++row)
      BOOST_TEST_REQUIRE(same(values[row], table.values[6 * row + 3 + q]));
  }
  for (std::size_t a = 0; a < 3; ++a)
    BOOST_TEST(read_array(file, sweep.axes[a].name, sweep.axes[a].values.size()) ==
               sweep.axes[a].values);
}

BOOST_AUTO_TEST_CASE(a_table_holds_the_sweep) {
  const test::PrivateFolder folder;
  const fs::path file = folder.path() / "new" / "map.csv";
  const Sweep sweep = motion_map();
  const SweptTable table = swept_by_one_thread(sweep);
  streamed(sweep, file);
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  BOOST_TEST(line == "amplitude,k1,velocity_ratio,friction_ratio,regime,critical_velocity");
  for (std::size_t row = 0; row < table.rows; ++row) {
    std::getline(in, line);
    std::istringstream cells(line);
    for (std::size_t c = 0; c < 6; ++c) {
      std::string cell;
      std::getline(cells, cell, ',');
      const double value = table.values[6 * row + c];
      if (c == 4)
        BOOST_TEST_REQUIRE(
            cell ==
            (value == 0 ? "" : words(sweep.quantities[1]).at(static_cast<std::size_t>(value) - 1)));
      else
        BOOST_TEST_REQUIRE(same(*to_double(cell), value));
    }
  }
  BOOST_TEST(!std::getline(in, line));
  BOOST_TEST(!fs::exists(file.string() + ".part"));
  BOOST_TEST(!fs::exists(file.string() + ".part.sweep"));
}

BOOST_AUTO_TEST_CASE(pieces_make_the_same_bytes) {
  const test::PrivateFolder folder;
  const Sweep sweep = motion_map();
  for (const char* ending : {".csv", ".h5"}) {
    const fs::path whole = folder.path() / (std::string("whole") + ending);
    const fs::path pieces = folder.path() / (std::string("pieces") + ending);
    streamed(sweep, whole);
    in_pieces(sweep, pieces);
    BOOST_TEST_CONTEXT(ending) BOOST_TEST((test::contents(whole) == test::contents(pieces)));
  }
}

// A kill may tear the last line of a table.
BOOST_AUTO_TEST_CASE(a_torn_table_is_gone_on_with) {
  const test::PrivateFolder folder;
  const fs::path whole = folder.path() / "whole.csv", torn = folder.path() / "torn.csv";
  const Sweep sweep = motion_map();
  streamed(sweep, whole);
  const std::string text = test::contents(whole);
  for (const std::size_t size : {std::size_t{0}, std::size_t{3}, std::size_t{70}, text.size() / 3,
                                 text.size() / 2, text.size() - 1, text.size()}) {
    std::ofstream(maps::part_of(torn), std::ios::binary) << text.substr(0, size);
    std::ofstream(maps::part_of(torn).string() + ".sweep", std::ios::binary)
        << maps::signature(sweep);
    streamed(sweep, torn, true);
    BOOST_TEST_CONTEXT(size << " bytes") BOOST_TEST((test::contents(torn) == text));
  }
}

BOOST_AUTO_TEST_CASE(what_an_unfinished_array_lacks_is_declared_missing) {
  const test::PrivateFolder folder;
  const fs::path file = folder.path() / "map.h5";
  const Sweep sweep = motion_map();
  BOOST_CHECK_THROW(streamed(sweep, file, false, 3), std::runtime_error);
  const std::size_t blocks = Sweeping(sweep).grid().blocks();
  const auto done = read_array(maps::part_of(file), "blocks", blocks);
  BOOST_TEST(std::count(done.begin(), done.end(), 1.0) >= 3);
  const auto values = read_array(maps::part_of(file), "critical_velocity", 9 * 20 * 80);
  for (std::size_t block = 0; block < blocks; ++block)
    BOOST_TEST((values[Sweeping(sweep).grid().block(block).first] != 0) == (done[block] == 1));
  const auto missing = [](const fs::path& path) {
    netcdf::File opened = netcdf::File::open(path, NC_NOWRITE);
    const int array = opened.array("critical_velocity");
    const bool declared =
        nc_inq_att(opened.id(), array, netcdf::fill_value, nullptr, nullptr) == NC_NOERR;
    opened.close();
    return declared;
  };
  BOOST_TEST(missing(maps::part_of(file)));
  streamed(sweep, file, true);
  BOOST_TEST(!missing(file));
}

BOOST_AUTO_TEST_CASE(another_sweep_is_refused) {
  const test::PrivateFolder folder;
  const Sweep sweep = motion_map();
  Sweep other = sweep;
  other.axes[1].values[7] += 1;
  for (const char* name : {"map.csv", "map.h5"}) {
    const fs::path file = folder.path() / name;
    BOOST_CHECK_THROW(streamed(sweep, file, false, 1), std::runtime_error);
    BOOST_TEST(has(message([&] { streamed(other, file, true); }), "of another sweep"));
    BOOST_TEST(has(message([&] { streamed(sweep, file); }), "`resume` to go on"));
    streamed(sweep, file, true);
  }
}

// Rows that were begun below names do not go on below names and units. Arrays have units anyway.
BOOST_AUTO_TEST_CASE(another_header_is_another_table) {
  const test::PrivateFolder folder;
  Sweep names = motion_map(), units = names;
  units.units_in_header = true;
  const fs::path table = folder.path() / "map.csv", array = folder.path() / "map.h5";
  for (const auto& [begun, other] : {std::pair(names, units), {units, names}}) {
    BOOST_CHECK_THROW(streamed(begun, table, false, 1), std::runtime_error);
    BOOST_TEST(has(message([&] { streamed(other, table, true); }), "and header"));
    streamed(begun, table, true);
  }
  BOOST_CHECK_THROW(streamed(names, array, false, 1), std::runtime_error);
  streamed(units, array, true);
}

// The table of a measured drive is no part of the scene's text.
BOOST_AUTO_TEST_CASE(another_receptance_is_another_sweep) {
  const Sweep sweep =
      sweep_over({"frequency=lin:16 kHz:26 kHz:9"}, {"critical_velocity"}, "measured_drive.toml");
  Sweep other = sweep;
  Scene scene = read_scene(VCRIT_SCENES "/measured_drive.toml");
  scene.receptance->rows[3].im *= 1.01;
  other.problem = scene;
  BOOST_TEST(maps::signature(other) != maps::signature(sweep));
  BOOST_TEST(maps::signature(sweep).find(" (commit ") != std::string::npos);
}

// A group of the file has that name.
BOOST_AUTO_TEST_CASE(an_element_named_progress_is_swept_as_a_table) {
  const test::PrivateFolder folder;
  Sweep sweep = sweep_over({}, {"critical_velocity"});
  sweep.problem = test::scene_of({.normal = "spring(progress) | c1",
                                  .tangential = "k2",
                                  .amplitude = 1e-3,
                                  .indentation = 5e-3,
                                  .elements = {{"progress", 7}, {"c1", 2}, {"k2", 5}}});
  sweep.axes.push_back(parse_axis("progress=lin:7:9:20", sweep.problem));
  BOOST_TEST(has(message([&] { streamed(sweep, folder.path() / "map.nc"); }), "over progress"));
  BOOST_TEST(fs::is_empty(folder.path()));
  BOOST_TEST(message([&] { streamed(sweep, folder.path() / "map.csv"); }) == "accepted");
}

// k[1] is the variable k_1, and so is an element of that name.
BOOST_AUTO_TEST_CASE(two_axes_of_one_name_in_the_file_are_swept_as_a_table) {
  const test::PrivateFolder folder;
  Sweep sweep = sweep_over({}, {"critical_velocity"});
  const std::vector<double> one{1};
  sweep.problem =
      test::scene_of({.normal = "prony(k_1, k, tau) | c1",
                      .tangential = "k2",
                      .amplitude = 1e-3,
                      .indentation = 5e-3,
                      .elements = {{"k_1", 7}, {"k", one}, {"tau", one}, {"c1", 2}, {"k2", 5}}});
  for (const char* axis : {"k[1]=lin:1:2:3", "k_1=lin:7:9:4"})
    sweep.axes.push_back(parse_axis(axis, sweep.problem));
  BOOST_TEST(has(message([&] { streamed(sweep, folder.path() / "map.nc"); }), "over k_1"));
  BOOST_TEST(fs::is_empty(folder.path()));
  BOOST_TEST(message([&] { streamed(sweep, folder.path() / "map.csv"); }) == "accepted");
}

BOOST_AUTO_TEST_CASE(mistakes_are_named_and_leave_nothing) {
  const test::PrivateFolder folder;
  const Sweep sweep = sweep_over({"k1=lin:1e6:9e6:20"}, {"critical_velocity"});
  BOOST_TEST(has(message([&] { streamed(sweep, folder.path() / "map.xls"); }), "ending in .csv"));
  const fs::path in_a_file = folder.path() / "file" / "map";
  std::ofstream(folder.path() / "file") << "text";
  for (const char* ending : {".csv", ".h5"})
    BOOST_TEST(has(message([&] { streamed(sweep, in_a_file.string() + ending); }), "file/map"));
  Sweep outside = sweep_over({"amplitude=lin:1 mm:2 mm:20"}, {"friction_ratio"});
  outside.velocity = 1;
  for (const char* name : {"map.csv", "map.h5"})
    BOOST_CHECK_THROW(streamed(outside, folder.path() / name), ModelError);
  BOOST_TEST(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 1);
}

}  // namespace

BOOST_AUTO_TEST_SUITE_END()
