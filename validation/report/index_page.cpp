#include "report/index_page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "report/assets.hpp"
#include "report/document.hpp"
#include "report/records.hpp"
#include "report/verdict.hpp"

namespace vcrit::validation::report {

namespace {

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
  std::size_t made = 0, failures = 0, outside = 0, without = 0;
  record::Json record{{"entries", record::page_of(entries)}};
  for (const IndexEntry& entry : entries) {
    made += entry.line.made;
    failures += entry.line.failed.size();
    outside += entry.line.state == "outside" ? 1U : 0U;
    without += entry.line.answer_words == "no answer" ? 1U : 0U;
  }
  record["state"] = failures > 0 ? "failed" : "passed";
  record["failed_total"] = failures > 0 ? record::Json(failures) : record::Json();
  record["made_total"] = made;
  record["total_words"] =
      fmt::format("{} scenes. {} answered, {} outside the model, {} checks failed.", entries.size(),
                  entries.size() - outside - without, outside, failures);
  add_origin(origin, record);
  return document("index", record,
                  {"Critical velocities of scenes", false, {std::string(index_script())}});
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
