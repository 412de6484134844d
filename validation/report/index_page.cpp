#include "report/index_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "report/document.hpp"
#include "report/html.hpp"

namespace vcrit::validation::report {

namespace {

std::string summary(const std::vector<IndexEntry>& entries) {
  std::size_t made = 0, failures = 0, skipped = 0;
  for (const IndexEntry& entry : entries) {
    made += entry.line.made;
    failures += entry.line.failed.size();
    skipped += entry.line.not_run.size();
  }
  const char* state = failures > 0 ? "failed" : skipped > 0 ? "not-run" : "passed";
  std::string words = failures > 0 ? fmt::format("{} of {} comparisons failed", failures, made)
                                   : fmt::format("{} comparisons passed", made);
  if (skipped > 0) words += fmt::format(", {} not run", skipped);
  return fmt::format("<p class=\"total {}\">{}.</p>\n", state, words);
}

std::string entry_line(const IndexEntry& entry) {
  const SceneLine& line = entry.line;
  std::string words = escape(line.state_words);
  if (!line.failed.empty())
    words +=
        fmt::format("<small>{}</small>", escape(fmt::format("{}", fmt::join(line.failed, "; "))));
  return fmt::format(
      "<li class=\"{}\"><a href=\"{}\"><span class=\"name\">{}</span>"
      "<span class=\"velocity\">{}</span><span class=\"state\">{}</span></a></li>\n",
      line.state, escape(entry.page), escape(line.title), escape(line.velocity), words);
}

/// What a link and every file system takes as it stands.
std::string plain_stem(const std::string& stem) {
  std::string result;
  for (const char c : stem) {
    const auto letter = static_cast<unsigned char>(c);
    const bool allowed = letter < 0x80 && (std::isalnum(letter) != 0 || c == '-' || c == '_');
    result += allowed ? c : '_';
  }
  return result.empty() ? "scene" : result;
}

std::string small(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

std::string index_page(const std::vector<IndexEntry>& entries, const Origin& origin) {
  std::string rows;
  for (const IndexEntry& entry : entries) rows += entry_line(entry);
  const std::string body = fmt::format(
      "<a class=\"skip\" href=\"#content\">To the scenes</a>\n"
      "<header class=\"page\"><p class=\"program\">vcrit {}</p>\n"
      "<h1>Critical velocities, validated</h1>\n"
      "<p class=\"lead\">Of each scene the formula is derived, evaluated in several ways, and set "
      "against a stick-slip simulation that does not know the formula.</p>\n{}</header>\n"
      "<main id=\"content\">\n<nav aria-label=\"Scenes\"><ol class=\"index\">\n{}</ol></nav>\n"
      "{}</main>\n",
      escape(origin.machine.program), summary(entries), rows, machine_section(origin));
  return document({"Validation of critical velocities", body, false, {}});
}

std::vector<std::string> page_names(const std::vector<std::string>& scene_files) {
  std::set<std::string> taken{"index"};
  std::vector<std::string> names;
  for (const std::string& file : scene_files) {
    const std::string stem = plain_stem(std::filesystem::path(file).stem().string());
    std::string name = stem;
    for (int i = 2; !taken.insert(small(name)).second; ++i) name = fmt::format("{}-{}", stem, i);
    names.push_back(name);
  }
  return names;
}

}  // namespace vcrit::validation::report
