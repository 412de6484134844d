// A sweep as a table: a header row, then one row a point in row-major order.
#pragma once

#include <fstream>
#include <map>

#include "maps/map_file.hpp"
#include "maps/part.hpp"

namespace vcrit::maps {

/// The sweep that OUT.part belongs to lies beside it as OUT.part.sweep until the end.
class CsvMap : public MapFile {
 public:
  CsvMap(const Sweeping& sweeping, const std::filesystem::path& file, bool resume,
         const Ranks& ranks);

  std::vector<bool> done() const override;
  std::string prepare(const BlockAnswer& answer) const override;
  void write(const BlockAnswer& answer, const std::string& prepared) override;
  void finish() override;
  void discard() override;

 private:
  std::string sweep_of_part() const;
  void begin();
  void go_on();
  void open(const std::filesystem::path& file, std::ios::openmode mode);
  void append(const std::string& text, const std::string& next_step = {});

  const Sweeping& sweeping_;
  PartFile part_;
  std::filesystem::path path_, sweep_file_;
  std::ofstream out_;
  std::size_t next_ = 0;                      // the first block that is not in the file
  std::map<std::size_t, std::string> early_;  // blocks before whose turn it is not yet
};

/// The header row: names, and units if the sweep asks for them.
std::string csv_header(const Sweep& sweep);

}  // namespace vcrit::maps
