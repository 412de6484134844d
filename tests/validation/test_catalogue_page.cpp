// The page about the named rheologies stands alone and is complete.
#include "report/catalogue_page.hpp"

#include <boost/test/unit_test.hpp>
#include <set>

#include "network/catalogue.hpp"
#include "report/assets.hpp"
#include "report/document.hpp"
#include "support/patterns.hpp"

BOOST_AUTO_TEST_SUITE(test_catalogue_page)

using namespace vcrit;
using namespace vcrit::validation::report;

namespace {

const std::string& html() {
  static const std::string text = catalogue_page();
  return text;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// The part of the page about one rheology.
std::string section(const std::string& name) {
  const auto begin = html().find("<section class=\"scene\" id=\"" + name + "\">");
  BOOST_REQUIRE(begin != std::string::npos);
  return html().substr(begin, html().find("</section>", begin) - begin);
}

/// The page without the style, whose ">" is no tag.
std::string markup() {
  std::string text = html();
  return text.erase(text.find(style()), style().size());
}

/// Elements that are open where `tag` closes another; empty if all close in their order.
std::string first_unbalanced(const std::string& text) {
  static const std::set<std::string> empty{"meta", "!DOCTYPE"};
  std::vector<std::string> open;
  for (const auto& tag : test::matches(text, "<(/?)([A-Za-z0-9!]+)[^>]*?(/?)>")) {
    const std::string& name = tag[2];
    if (empty.contains(name) || !tag[3].empty()) continue;
    if (tag[1].empty()) {
      open.push_back(name);
    } else {
      if (open.empty() || open.back() != name) return name;
      open.pop_back();
    }
  }
  return open.empty() ? "" : open.back();
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_rheology_has_its_section_and_is_in_the_index) {
  for (const Rheology& rheology : catalogue()) {
    BOOST_TEST_CONTEXT(rheology.name) {
      const std::string text = section(rheology.name);
      BOOST_TEST(has(html(), "<a href=\"#" + rheology.name + "\">"));
      BOOST_TEST(count(text, "<svg") == 1);
      const int contacts = rheology.name == "mass" ? 0 : 1;
      BOOST_TEST(count(text, "<h3>Critical velocity") == 1 + contacts);
      BOOST_TEST(count(text, "<h3>At rest and at once") == contacts);
      for (const char* part : {"<h3>Dynamic stiffness", "<h3>Limits"})
        BOOST_TEST(count(text, part) == 1, part);
    }
  }
  BOOST_TEST(count(html(), "<section") == static_cast<int>(catalogue().size()));
}

// tau_1 = (... tau_1 ...) stood there, where one is a relaxation time and the other is given.
BOOST_AUTO_TEST_CASE(relaxation_times_are_told_from_retardation_times) {
  BOOST_TEST(has(section("generalized_kelvin"), ">own</mi>"));
  BOOST_TEST(!has(section("prony"), ">own</mi>"));  // its times are those given
}

BOOST_AUTO_TEST_CASE(other_names_are_said) {
  BOOST_TEST(has(section("zener"), "Also written <code>sls(k0, k1, c1)</code>."));
  BOOST_TEST(
      has(section("prony"), "Also written <code>generalized_maxwell(k0, k, tau, 3)</code>."));
  BOOST_TEST(!has(section("kelvin"), "Also written"));
}

BOOST_AUTO_TEST_CASE(what_flows_is_marked) {
  const std::string mark = "As normal contact not admissible";
  for (const char* name : {"damper", "maxwell", "jeffreys", "burgers", "ladder"})
    BOOST_TEST(has(section(name), mark), name);
  for (const char* name : {"spring", "lossy", "kelvin", "zener", "poynting_thomson", "prony"})
    BOOST_TEST(!has(section(name), mark), name);
}

BOOST_AUTO_TEST_CASE(what_relaxes_has_a_spectrum) {
  for (const char* name : {"maxwell", "zener", "poynting_thomson", "jeffreys", "burgers", "prony"})
    BOOST_TEST(has(section(name), "<h3>Relaxation spectrum"), name);
  for (const char* name : {"spring", "damper", "lossy", "kelvin"})
    BOOST_TEST(!has(section(name), "<h3>Relaxation spectrum"), name);
}

// The name of MathML's namespace is no address that is called. The one script makes formulas fit on
// paper, where a wide one would make the whole page smaller.
BOOST_AUTO_TEST_CASE(nothing_is_loaded) {
  const std::string text =
      test::without_matches(markup(), " xmlns=\"http://www.w3.org/1998/Math/MathML\"");
  for (const char* part : {"http:", "https:", " src=", "<link", "@import"})
    BOOST_TEST(!has(text, part), part);
  BOOST_TEST(!test::has_match(text, "href=\"(?!#)"));
  BOOST_TEST(has(text, "default-src 'none'; script-src '" + script_hash(page_script()) + "';"));
}

BOOST_AUTO_TEST_CASE(tags_are_balanced) {
  BOOST_TEST(first_unbalanced("<p><b>x</b></p>") == "");
  BOOST_TEST(first_unbalanced("<p><b>x</p></b>") == "p");
  BOOST_TEST(first_unbalanced(markup()) == "");
}

BOOST_AUTO_TEST_CASE(links_lead_somewhere_and_names_are_given_once) {
  const std::string text = markup();
  for (const auto& link : test::matches(text, "href=\"#([^\"]*)\""))
    BOOST_TEST(count(text, " id=\"" + link[1] + "\"") == 1, link[1]);
}

BOOST_AUTO_TEST_CASE(the_same_bytes_again) { BOOST_TEST((catalogue_page() == html())); }

BOOST_AUTO_TEST_SUITE_END()
