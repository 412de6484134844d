// vcrit sweep: quantities of a scene over a grid of its parameters and the speed, as a table or an
// array, on all cores and on all processes of mpirun.
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "answers/realised_friction.hpp"
#include "base/constants.hpp"
#include "base/joined.hpp"
#include "base/numbers.hpp"
#include "base/output_places.hpp"
#include "base/rounded.hpp"
#include "base/units.hpp"
#include "maps/csv_map.hpp"
#include "problem/input_files.hpp"
#include "problem/variants.hpp"
#include "record/fields.hpp"
#include "streams.hpp"
#include "sweep/sweep.hpp"
#include "sweep_options.hpp"

namespace vcrit::app {

namespace {

// The factor to rad/s of an axis of frequencies; nothing for other axes.
std::optional<double> to_omega(const std::string& axis, const Problem& problem) {
  const auto named = problem->source->named.find(axis);
  if (named == problem->source->named.end()) return std::nullopt;
  if (named->second == frequency_symbol) return two_pi;
  if (named->second == problem->angular_frequency.symbol) return 1;
  return std::nullopt;
}

// "frequency=log:..." and so on.
bool varies_frequency(const std::vector<std::string>& axes, const Problem& problem) {
  return std::any_of(axes.begin(), axes.end(), [&](const std::string& axis) {
    return to_omega(axis.substr(0, axis.find('=')), problem);
  });
}

void warn_of(Sweep& sweep, const std::string& warning) {
  warn(warning);
  std::vector<std::string> warnings = sweep.problem->source->warnings;
  warnings.push_back(warning);
  sweep.problem = warning_of(sweep.problem, std::move(warnings));
}

void warn_of_axes(Sweep& sweep) {
  for (const Axis& axis : sweep.axes) {
    const auto factor = to_omega(axis.name, sweep.problem);
    if (!factor || axis.values.empty()) continue;
    const auto [least, most] = std::minmax_element(axis.values.begin(), axis.values.end());
    const auto beyond = beyond_fitted_range(sweep.problem, *factor * *least, *factor * *most);
    if (!beyond) continue;
    warn_of(sweep, *beyond);
  }
}

/// A folder that does not exist may be a typing error.
void warn_of_folder(const SweepOptions& options, Sweep& sweep) {
  const auto folder = std::filesystem::path(options.out).parent_path();  // none without a file
  std::error_code ignored;
  if (folder.empty() || std::filesystem::exists(folder, ignored)) return;
  const std::string made = fmt::format("{}: there was no such folder, it is made", folder.string());
  warn_of(sweep, made);
}

/// The scene, its tables, and lists of axes.
void refuse_lost_inputs(const SweepOptions& options, const Problem& problem) {
  std::vector<std::filesystem::path> read = input_files(problem);
  for (const std::string& axis : options.over)
    if (const auto list = list_file(axis)) read.emplace_back(*list);
  refuse_input_as_output(options.out, read);
}

Sweep sweep_of(const SweepOptions& options) {
  using Frequency = SceneOptions::Frequency;
  const auto frequency = [&](const Problem& problem) {
    return varies_frequency(options.over, problem) ? Frequency::varied : Frequency::of_the_scene;
  };
  Sweep sweep{options.scene.read(frequency), {}, {}, {}, {}, options.units};
  for (const std::string& axis : options.over)
    sweep.axes.push_back(parse_axis(axis, sweep.problem));
  refuse_lost_inputs(options, sweep.problem);
  warn_of_axes(sweep);
  warn_of_folder(options, sweep);
  for (const std::string& name : options.quantities)
    sweep.quantities.push_back(parse_swept_quantity(name, sweep.problem));
  if (std::ranges::any_of(sweep.quantities, needs_motion))
    for (const std::string& warning : unstated_error(sweep.problem)) warn_of(sweep, warning);
  if (!options.velocity.empty())
    sweep.velocity = parse_quantity(options.velocity, Dimension::velocity, {"--velocity"});
  if (!options.velocity_ratio.empty())
    sweep.velocity_ratio = speed_ratio_of(options.velocity_ratio);
  return sweep;
}

/// One line on a terminal: how far, how fast, how long still.
class ProgressLine {
 public:
  void operator()(const maps::StreamProgress& progress) {
    const auto now = Clock::now();
    if (now - shown_ < std::chrono::milliseconds(250)) return;
    shown_ = now;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double rate = static_cast<double>(progress.in_this_run) / seconds;
    const double left = static_cast<double>(progress.rows - progress.done) / rate;
    tell("\r\033[K{:5.1f} % of {} points, {:.3g} a second, {:.0f} s left",
         100 * static_cast<double>(progress.done) / static_cast<double>(progress.rows),
         progress.rows, rate, left);
  }
  static void end() { tell("\r\033[K"); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now(), shown_ = start_;
};

struct Swept {
  std::string file;
  maps::Streamed rows;
  std::vector<std::string> warnings;

  friend void fields(record::Fields& f, const Swept& it) {
    f("file", it.file)("rows", it.rows.rows)("rows_found", it.rows.found);
    f("rows_outside", it.rows.outside)("reason", it.rows.reason).some("warnings", it.warnings);
  }
};

void warn_of_rows_outside(const maps::Streamed& rows) {
  if (rows.outside > 0)
    warn(fmt::format("{} of {} rows are outside the model (nan); the first: {}", rows.outside,
                     rows.found, rows.reason));
}

void report(const SweepOptions& options, const Sweep& sweep, const maps::Streamed& streamed) {
  warn_of_rows_outside(streamed);
  if (options.json)
    print(record::json_of(Swept{options.out, streamed, sweep.problem->source->warnings}));
}

// On stdout a table is for eyes and pipes; a map is for a file.
constexpr std::size_t most_printed = 100'000;

void require_file(const SweepOptions& options, std::size_t rows, const maps::Ranks& ranks) {
  const char* why = ranks.size() > 1        ? "several processes"
                    : options.stream.resume ? "--resume"
                    : rows > most_printed   ? "so many rows"
                                            : nullptr;
  if (why != nullptr)
    throw InputError(argument("out"), fmt::format("no file with {}", why),
                     "FILE.csv, FILE.h5 or FILE.nc");
}

double table_value(const SweptTable& table, std::size_t row, std::size_t column) {
  return table.values[row * table.columns.size() + column];
}

/// The word that a number stands for, where the column is one of words.
std::optional<std::string> word_in(const Sweep& sweep, std::size_t column, double value) {
  const std::size_t axes = sweep.axes.size();
  if (column < axes || words(sweep.quantities[column - axes]).empty()) return std::nullopt;
  return word_of(sweep.quantities[column - axes], value);
}

/// As a file has it: all digits in SI units.
void print_csv(const Sweep& sweep, const SweptTable& table) {
  fmt::print("{}", maps::csv_header(sweep));
  std::vector<std::string> cells(table.columns.size());
  for (std::size_t row = 0; row < table.rows; ++row) {
    for (std::size_t column = 0; column < cells.size(); ++column) {
      const double value = table_value(table, row, column);
      cells[column] = word_in(sweep, column, value).value_or(to_text(value));
    }
    fmt::print("{}\n", joined(cells, ","));
  }
}

/// In a unit that reads well for the largest of the column.
UnitScale scale_of_column(const SweptTable& table, std::size_t column, const std::string& unit) {
  double largest = 0;
  for (std::size_t row = 0; row < table.rows; ++row)
    if (const double size = std::abs(table_value(table, row, column)); std::isfinite(size))
      largest = std::max(largest, size);
  return scale_for(largest, unit);
}

std::size_t count_characters(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

/// For people: each column in one unit, numbers in four digits.
void print_table(const Sweep& sweep, const SweptTable& table) {
  std::vector<std::vector<std::string>> lines(table.rows + 1);
  for (const SweptColumn& column : swept_columns(sweep)) {
    const std::size_t at = lines.front().size();
    const UnitScale scale = scale_of_column(table, at, column.unit);
    lines.front().push_back(column_heading(column.name, scale.unit));
    for (std::size_t row = 0; row < table.rows; ++row) {
      const double value = table_value(table, row, at);
      const std::string number = std::isnan(value) ? "nan" : rounded(value * scale.factor, "");
      lines[row + 1].push_back(word_in(sweep, at, value).value_or(number));
    }
    std::size_t width = 0;
    for (const auto& line : lines) width = std::max(width, count_characters(line[at]));
    for (auto& line : lines) line[at].append(width - count_characters(line[at]), ' ');
  }
  for (auto& line : lines) {
    std::string& last = line.back();
    last.erase(last.find_last_not_of(' ') + 1);
    fmt::print("{}\n", joined(line, "  "));
  }
}

record::Json json_table(const Sweep& sweep, const SweptTable& table) {
  const record::Fields as_files_have_it(record::Reader::file);
  record::Json lines = record::Json::array();
  for (std::size_t row = 0; row < table.rows; ++row) {
    record::Json line = record::Json::array();
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      const double value = table_value(table, row, column);
      const auto word = word_in(sweep, column, value);
      line.push_back(word ? record::Json(*word) : as_files_have_it.written(value));
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

void print_sweep(const SweepOptions& options, const Sweep& sweep) {
  const SweptTable table = swept(sweep);
  if (table.outside == table.rows) throw ModelError(table.reason);
  const maps::Streamed rows{table.rows, table.rows, table.outside, table.reason};
  warn_of_rows_outside(rows);
  if (!options.json)
    return options.out == "-" ? print_csv(sweep, table) : print_table(sweep, table);
  record::Json object = record::json_of(Swept{options.out, rows, sweep.problem->source->warnings});
  object["columns"] = table.columns;
  object["table"] = json_table(sweep, table);
  print(object);
}

}  // namespace

void run_sweep(const SweepOptions& options, maps::Ranks& ranks) {
  std::optional<Sweeping> sweeping;
  ranks.together([&] { sweeping.emplace(sweep_of(options)); });
  if (options.out.empty() || options.out == "-") {
    require_file(options, sweeping->grid().rows(), ranks);
    return print_sweep(options, sweeping->sweep());
  }
  maps::StreamOptions stream = options.stream;
  const bool terminal = ::isatty(STDERR_FILENO) == 1;
  if (terminal) stream.told = [line = ProgressLine()](const auto& p) mutable { line(p); };
  const maps::Streamed streamed = maps::stream(*sweeping, options.out, stream, ranks);
  if (terminal && ranks.first()) ProgressLine::end();
  if (ranks.first()) report(options, sweeping->sweep(), streamed);
}

}  // namespace vcrit::app
