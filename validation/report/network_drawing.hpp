// Networks drawn as mechanics draws them: zigzag springs, dashpots, series along the line, parallel
// branches stacked between bars, graphs with their inner nodes as dots.
#pragma once

#include <string>

#include "network/network.hpp"

namespace vcrit::validation::report {

/// A piece of a drawing whose terminals lie at (0, 0) and (width, 0); y points down, pixels.
struct Drawing {
  double width = 0;
  double above = 0, below = 0;  ///< how far it reaches from the line between the terminals
  std::string svg;
};

Drawing draw(const Network& network);

/// The drawing as an image; `description` is read to those who do not see it.
std::string framed(const Drawing& drawing, const std::string& description);

/// A name with its index set lower, as SVG text content: "k0", "k[3]", "tau[2]".
std::string label(const Symbol& symbol);

/// One SVG piece moved to (x, y).
std::string moved(double x, double y, const std::string& svg);
/// A straight line.
std::string line(double x1, double y1, double x2, double y2);
/// Text around a point; `content` is SVG.
std::string text(double x, double y, const std::string& content, const char* anchor = "middle");

}  // namespace vcrit::validation::report
