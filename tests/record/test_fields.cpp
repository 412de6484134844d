// A record says its members once: for files, where what is absent has no key, and for templates,
// where every key is there.
#include "record/fields.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

namespace vcrit::record {

namespace {

enum class Colour { red, green };
const char* to_text(Colour colour) { return colour == Colour::red ? "red" : "green"; }

struct Part {
  double length = 0;
};

struct Example {
  std::string name;
  std::optional<double> mass;
  std::vector<Part> parts;
  Colour colour = Colour::red;
  bool measured = false;
  double value = 0;
};

struct Written {
  std::filesystem::path file;
  int rows = 0;
};

}  // namespace

void fields(Fields& f, const Part& part) { f("length", part.length); }

void fields(Fields& f, const Example& example) {
  f("name", example.name).some("mass", example.mass).some("parts", example.parts);
  f("colour", example.colour).when(example.measured, "value", example.value);
  f.page("sign", Markup{"<b>"});
}

void fields(Fields& f, const Written& written) {
  f("file", written.file);
  f.group("size", [&](Fields& size) { size("rows", written.rows).page("words", "few"); });
}

}  // namespace vcrit::record

BOOST_AUTO_TEST_SUITE(test_fields)

using namespace vcrit::record;

BOOST_AUTO_TEST_CASE(what_is_absent_has_no_key_in_a_file) {
  BOOST_TEST(json_of(Example{}).dump() == R"({"name":"","colour":"red"})");
  const Example full{"a", 2.5, {{1}, {2}}, Colour::green, true, 7};
  BOOST_TEST(json_of(full).dump() ==
             R"({"name":"a","mass":2.5,"parts":[{"length":1.0},{"length":2.0}],)"
             R"("colour":"green","value":7.0})");
}

BOOST_AUTO_TEST_CASE(a_page_has_every_key) {
  const Json page = page_of(Example{});
  for (const char* key : {"name", "mass", "parts", "colour", "value", "sign"})
    BOOST_TEST(page.contains(key), key);
  BOOST_TEST(page["mass"].is_null());
  BOOST_TEST(page["sign"].is_binary());
}

BOOST_AUTO_TEST_CASE(an_object_within_needs_no_type) {
  BOOST_TEST(json_of(Written{"a/b.csv", 3}).dump() == R"({"file":"a/b.csv","size":{"rows":3}})");
  BOOST_TEST(page_of(Written{})["size"].contains("words"));
}

BOOST_AUTO_TEST_CASE(what_json_has_no_number_for_is_a_word) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Part> parts{{infinity}, {-infinity}, {std::nan("")}};
  BOOST_TEST(json_of(parts).dump() == R"([{"length":"inf"},{"length":"-inf"},{"length":"nan"}])");
  BOOST_TEST(json_of(std::numeric_limits<double>::denorm_min()).dump() == "5e-324");
}

BOOST_AUTO_TEST_SUITE_END()
