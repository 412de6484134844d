// Arguments in what libraries say, spelled as the caller's users write them.
#include "base/arguments.hpp"

#include <boost/test/unit_test.hpp>

#include <string>

BOOST_AUTO_TEST_SUITE(test_arguments)

using namespace vcrit;

namespace {

std::string marked(const std::string& argument) { return "<" + argument + ">"; }

}  // namespace

BOOST_AUTO_TEST_CASE(keys_are_spelled) {
  BOOST_TEST(spelled("`velocity_ratio` has no meaning, give `velocity`", marked) ==
             "<velocity_ratio> has no meaning, give <velocity>");
  BOOST_TEST(spelled("by `set NAME=VALUE`", marked) == "by <set NAME=VALUE>");
  BOOST_TEST(spelled("nothing to spell", marked) == "nothing to spell");
  BOOST_TEST(spelled("", marked) == "");
}

BOOST_AUTO_TEST_CASE(commands_and_other_texts_stay) {
  for (const char* text : {"`vcrit fit DATA.csv --out SCENE.toml` fits", "`[contact]`", "``",
                           "`K1`", "a lone ` and `", "`to"})
    BOOST_TEST(spelled(text, marked) == text);
}

BOOST_AUTO_TEST_CASE(of_wrong_input_all_but_what_was_found) {
  const InputError error =
      spelled(InputError(argument("set k1"), "`to`", "one of `from`", "or `to`"), marked);
  BOOST_TEST(error.what() == std::string("<set k1>: found `to`; expected one of <from>; or <to>"));
  BOOST_TEST(error.place().argument == "<set k1>");
  BOOST_TEST(error.found() == "`to`");
  BOOST_TEST(error.expected() == "one of <from>");
  BOOST_TEST(error.advice() == "or <to>");
  const InputError in_file = spelled(InputError({"`to`", 3, 4}, "a", "b"), marked);
  BOOST_TEST(in_file.what() == std::string("`to`:3:4: found a; expected b"));
}

BOOST_AUTO_TEST_CASE(of_a_scene_outside_the_model_words_and_advice) {
  const ModelError error = spelled(ModelError("v* is 0; no `from`", "give `to`"), marked);
  BOOST_TEST(error.what() == std::string("v* is 0; no <from>; give <to>"));
  BOOST_TEST(error.advice() == "give <to>");
  BOOST_TEST(spelled(ModelError("no `from`"), marked).what() == std::string("no <from>"));
}

BOOST_AUTO_TEST_SUITE_END()
