#include "figures/screen.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/errors.hpp"
#include "figures/drawn.hpp"

namespace vcrit::validation::figures {

namespace {

// Letters; with the ticks' words left of the frame a line fits the usual 80.
constexpr int screen_columns = 66, screen_rows = 17, words_width = 10;
// Of lines and points in their order; what is dashed or dotted has dots.
constexpr std::string_view marks = "*o+x#%@";

class Screen {
 public:
  explicit Screen(const Figure& figure)
      : figure_(figure),
        scales_(scales_of(figure, 6, 5)),
        lines_(screen_rows, std::string(screen_columns, ' ')) {
    for (const Rule& rule : figure.rules) draw(rule);
    for (const FigureSeries& series : figure.series) draw(series, mark_of(series));
    for (const Rule& rule : figure.rules) write_words(rule);
  }

  std::string text() const {
    std::string text = figure_.title + "\n" + figure_.y.title + legend() + "\n";
    for (int row = 0; row < screen_rows; ++row)
      text += trimmed(fmt::format("{:>{}} |{}", words_at(row), words_width - 2, lines_[at(row)])) +
              "\n";
    return text + std::string(words_width - 1, ' ') + "+" + std::string(screen_columns, '-') +
           "\n" + trimmed(std::string(words_width, ' ') + words_below()) + "\n" +
           std::string(words_width, ' ') + figure_.x.title + "\n";
  }

 private:
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }
  static std::string trimmed(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
  }

  /// Between letters; NaN for what has no place.
  double column_of(double x) const { return scales_.x.place(x) * (screen_columns - 1); }
  double row_of(double y) const { return (1 - scales_.y.place(y)) * (screen_rows - 1); }

  void put(double column, double row, char letter) {
    const double c = std::round(column), r = std::round(row);
    if (c >= 0 && c < screen_columns && r >= 0 && r < screen_rows)
      lines_[at(static_cast<int>(r))][at(static_cast<int>(c))] = letter;
  }

  void draw(const Rule& rule) {
    for (int i = 0; i < std::max(screen_columns, screen_rows); ++i)
      rule.horizontal ? put(i, row_of(rule.at), '.') : put(column_of(rule.at), i, '|');
  }

  void draw(const FigureSeries& series, char mark) {
    const bool line = !is_marks(series.style);
    double last_column = NAN, last_row = NAN;
    for (const Point& point : series.points) {
      const double column = column_of(point.x), row = row_of(point.y);
      const double steps =
          line ? 2 * std::max(std::abs(column - last_column), std::abs(row - last_row)) : 0;
      // Twice as many marks as letters in between, so that the line has no holes.
      if (std::isfinite(steps))
        for (double i = 0; i < std::min(steps, 4.0 * screen_columns); ++i)
          put(last_column + (column - last_column) * i / steps,
              last_row + (row - last_row) * i / steps, mark);
      if (std::isfinite(column) && std::isfinite(row)) put(column, row, mark);
      last_column = column;
      last_row = row;
    }
  }

  /// In the first row where they touch nothing but spaces; right of the rule, or left of it.
  void write_words(const Rule& rule) {
    std::string words = rule.words;  // a letter a byte
    for (std::size_t i = 0; (i = words.find("µ")) != words.npos;) words.replace(i, 2, "u");
    const int length = static_cast<int>(words.size());
    const double place = rule.horizontal ? 0 : column_of(rule.at);
    if (!(place >= 0 && place < screen_columns)) return;
    for (int row = 0; row < screen_rows; ++row)
      for (const int begin : {static_cast<int>(std::round(place)) + 2,
                              static_cast<int>(std::round(place)) - 1 - length}) {
        if (begin < 0 || begin + length > screen_columns) continue;
        if (rule.horizontal && row != static_cast<int>(std::round(row_of(rule.at)) + 1)) continue;
        std::string& line = lines_[at(row)];
        if (line.substr(at(begin), at(length)).find_first_not_of(' ') != line.npos) continue;
        line.replace(at(begin), at(length), words);
        return;
      }
  }

  /// Series of one name have one mark.
  char mark_of(const FigureSeries& series) const {
    if (series.style == Style::dashed || series.style == Style::dotted) return '.';
    std::size_t mark = 0;
    for (const FigureSeries& other : figure_.series) {
      if (other.name == series.name) break;
      if (other.style != Style::dashed && other.style != Style::dotted) ++mark;
    }
    return marks[mark % marks.size()];
  }

  std::string legend() const {
    std::string text;
    std::set<std::string> named{""};
    for (const FigureSeries& series : figure_.series)
      if (named.insert(series.name).second)
        text += fmt::format("   {} {}", mark_of(series), series.name);
    return named.size() > 2 ? text : "";
  }

  std::string words_at(int row) const {
    for (const auto& [value, words] : scales_.y.ticks())
      if (std::round(row_of(value)) == row) return words;
    return "";
  }

  std::string words_below() const {
    std::string text(screen_columns + 6, ' ');
    std::size_t free = 0;
    for (const auto& [value, words] : scales_.x.ticks()) {
      const double place = column_of(value);
      if (!(place >= -0.5 && place < screen_columns)) continue;
      const double half = static_cast<double>(words.size()) / 2;
      const auto begin = static_cast<std::size_t>(std::max(0.0, std::round(place - half + 0.5)));
      if (begin < free || begin + words.size() > text.size()) continue;
      text.replace(begin, words.size(), words);
      free = begin + words.size() + 2;
    }
    return text;
  }

  const Figure& figure_;
  FigureScales scales_;
  std::vector<std::string> lines_;
};

}  // namespace

std::string on_screen(const Figure& figure) {
  if (figure.map) throw Bug("a map in a picture of letters");
  return Screen(figure).text();
}

}  // namespace vcrit::validation::figures
