#include "maps/csv_map.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <system_error>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "base/joined.hpp"
#include "base/numbers.hpp"

namespace vcrit::maps {

namespace fs = std::filesystem;

namespace {

// Where the lines of whole blocks end, and how many blocks that are. The last line may be torn.
struct Whole {
  std::size_t blocks = 0;
  std::uintmax_t bytes = 0;
};

Whole whole_blocks(const fs::path& part, const Grid& grid, std::size_t header) {
  std::ifstream in(part, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(header));
  Whole whole{0, header};
  std::size_t rows = 0, end = grid.block(0).rows;
  std::uintmax_t position = header;
  std::vector<char> buffer(1U << 20U);
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())), in.gcount() > 0) {
    const auto size = static_cast<std::size_t>(in.gcount());
    for (std::size_t i = 0; i < size; ++i) {
      if (buffer[i] != '\n' || ++rows < end) continue;
      whole = {whole.blocks + 1, position + i + 1};
      if (whole.blocks < grid.blocks()) end += grid.block(whole.blocks).rows;
    }
    position += size;
  }
  return whole;
}

std::string cell(const SweptQuantity& quantity, double value) {
  return words(quantity).empty() ? to_text(value) : word_of(quantity, value);
}

const fs::path& of_one_process(const fs::path& file, const Ranks& ranks) {
  if (ranks.size() > 1)
    throw InputError(argument("out"), fmt::format("\"{}\" under mpirun", file.string()),
                     "a file ending in .h5, which several processes can write");
  return file;
}

}  // namespace

std::string csv_header(const Sweep& sweep) {
  std::vector<std::string> columns;
  for (const auto& [name, unit] : swept_columns(sweep))
    columns.push_back(sweep.units_in_header ? column_heading(name, unit) : name);
  return fmt::format("{}\n", joined(columns, ","));
}

CsvMap::CsvMap(const Sweeping& sweeping, const fs::path& file, bool resume, const Ranks& ranks)
    : sweeping_(sweeping),
      part_(of_one_process(file, ranks), resume),
      path_(part_of(file)),
      sweep_file_(path_) {
  sweep_file_ += ".sweep";
  part_.is_there() ? go_on() : begin();
}

// With a header that has units: the rows below it belong to it.
std::string CsvMap::sweep_of_part() const {
  const Sweep& sweep = sweeping_.sweep();
  return signature(sweep) + (sweep.units_in_header ? csv_header(sweep) : "");
}

void CsvMap::begin() {
  std::error_code error;
  fs::remove(sweep_file_, error);  // or what somebody has linked there would be written over
  try {
    // Whole before the part is there: whatever has that name can be gone on with.
    open(sweep_file_, std::ios::out);
    append(sweep_of_part());
    out_.close();
    open(path_, std::ios::out);
    append(csv_header(sweeping_.sweep()));
  } catch (const InputError&) {
    discard();  // no row is there that a sweep could go on from
    throw;
  }
}

void CsvMap::go_on() {
  const std::string header = csv_header(sweeping_.sweep());
  if (!fs::exists(sweep_file_) || read_file(sweep_file_) != sweep_of_part())
    throw InputError({path_.string()}, "the unfinished file of another sweep",
                     "the same scene, axes, quantities and header");
  const Whole whole = fs::file_size(path_) < header.size()
                          ? Whole{}
                          : whole_blocks(path_, sweeping_.grid(), header.size());
  next_ = whole.blocks;
  std::error_code error;
  fs::resize_file(path_, whole.bytes, error);
  if (error) refuse_part(path_, error.message());
  open(path_, std::ios::app);
  if (whole.bytes == 0) append(header);
}

std::vector<bool> CsvMap::done() const {
  std::vector<bool> done(sweeping_.grid().blocks(), false);
  std::fill_n(done.begin(), next_, true);
  return done;
}

std::string CsvMap::prepare(const BlockAnswer& answer) const {
  const Grid& grid = sweeping_.grid();
  const Block block = grid.block(answer.block);
  const auto& quantities = sweeping_.sweep().quantities;
  std::string text;
  for (std::size_t row = 0; row < block.rows; ++row) {
    for (std::size_t a = 0; a < grid.axes().size(); ++a)
      text += to_text(grid.value(a, block.first + row)) + ",";
    for (std::size_t q = 0; q < quantities.size(); ++q)
      text += cell(quantities[q], answer.values[q][row]) + (q + 1 < quantities.size() ? "," : "\n");
  }
  return text;
}

void CsvMap::open(const fs::path& file, std::ios::openmode mode) {
  errno = 0;
  out_.open(file, mode | std::ios::binary);
  if (!out_) refuse_part(path_, errno != 0 ? std::strerror(errno) : "no file");
}

void CsvMap::append(const std::string& text, const std::string& next_step) {
  errno = 0;
  out_ << text << std::flush;
  if (!out_) refuse_part(path_, errno != 0 ? std::strerror(errno) : "a write error", next_step);
}

void CsvMap::write(const BlockAnswer& answer, const std::string& prepared) {
  early_.emplace(answer.block, prepared);
  for (auto turn = early_.begin(); turn != early_.end() && turn->first == next_;
       turn = early_.erase(turn), ++next_)
    append(turn->second, goes_on);
}

void CsvMap::finish() {
  out_.close();
  if (!out_) refuse_part(path_, "a write error");
  part_.put_into_place();
  std::error_code ignored;
  fs::remove(sweep_file_, ignored);
}

void CsvMap::discard() {
  part_.remove();
  std::error_code ignored;
  fs::remove(sweep_file_, ignored);
}

}  // namespace vcrit::maps
