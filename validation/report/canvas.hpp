// A picture that is drawn piece by piece, and knows how far it reaches.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "report/network_drawing.hpp"

namespace vcrit::validation::report {

/// A picture that grows with what is put into it; x from the middle of the body, y from its bottom.
class Canvas {
 public:
  void put(const Shapes& shapes) { all_.add(shapes); }
  void reach(double left, double right, double top, double bottom) {
    left_ = std::min(left_, left);
    right_ = std::max(right_, right);
    all_.above = std::max(all_.above, -top);
    all_.below = std::max(all_.below, bottom);
  }
  void write(double x, double y, const Label& words, const char* anchor = "start") {
    const double width = width_of(words);
    const double left = anchor[0] == 's' ? x : anchor[0] == 'e' ? x - width : x - width / 2;
    reach(left, left + width, y - 14, y + 6);
    put({text(x, y, words, anchor)});
  }
  /// Lines of items from the left edge on, as long as the picture is wide but at least `width`.
  void list(double y, const std::vector<Label>& items, double width) {
    constexpr double line_height = 20, gap = 18;
    const double start = left_, end = std::max(right_, left_ + width);
    double x = start;
    for (const Label& item : items) {
      const double length = width_of(item);
      if (x > start && x + length > end) {
        x = start;
        y += line_height;
      }
      write(x, y, item);
      x += length + gap;
    }
  }
  double left() const { return left_; }
  double width() const { return right_ - left_; }
  Picture picture(const std::string& description) {
    all_.shapes = moved(-left_, 0, all_.shapes);
    all_.width = right_ - left_;
    return {all_, description};
  }

 private:
  Drawing all_;
  double left_ = 0, right_ = 0;
};

}  // namespace vcrit::validation::report
