// The page over many scenes: a line each, and a way to its own page.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "record/fields.hpp"
#include "report/origin.hpp"
#include "report/scene_line.hpp"

namespace vcrit::validation::report {

/// A line of the index and the file of its page, beside the index.
struct IndexEntry {
  SceneLine line;
  std::string page;

  friend void fields(record::Fields& f, const IndexEntry& it) {
    fields(f, it.line);
    f("page_file", it.page)("file_name", std::filesystem::path(it.line.file).filename());
  }
};

std::string index_page(const std::vector<IndexEntry>& entries, const Origin& origin);

/// Names for the pages of scene files, after the files: "zener", "zener-2", without ".html"; never
/// "index", and none twice, not even where a file system takes capitals for small letters.
std::vector<std::string> page_names(const std::vector<std::string>& scene_files);

}  // namespace vcrit::validation::report
