// Networks drawn as mechanics draws them: zigzag springs, dashpots, series along the line, parallel
// branches stacked between bars, graphs with their inner nodes as dots. A drawing is a list of
// shapes; templates/drawing.mustache makes an SVG of it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "network/network.hpp"
#include "record/fields.hpp"

namespace vcrit::validation::report {

/// Some letters in one style ("letter", "index"; empty: upright), moved down by `shift` pixels from
/// here on, if it says how far.
struct Word {
  std::string style, text, shift;
  friend bool operator==(const Word&, const Word&) = default;
};
using Label = std::vector<Word>;

/// Coordinates in pixels, y points down.
struct DrawnShape {
  enum class Form { path, node, text };
  Form form = Form::path;
  std::string transform;          ///< as SVG has it, the outermost first
  std::string style;              ///< class of the style sheet; may be empty
  std::string d;                  ///< of a path
  double x = 0, y = 0;            ///< of a node or a text
  std::string anchor = "middle";  ///< where a text has (x, y)
  Label words;                    ///< of a text
};
using Shapes = std::vector<DrawnShape>;

/// A piece of a drawing whose terminals lie at (0, 0) and (width, 0).
struct Drawing {
  double width = 0;
  double above = 0, below = 0;  ///< how far it reaches from the line between the terminals
  Shapes shapes;

  void add(const Shapes& more);
};

/// How a network is drawn, besides lying with its names alone.
struct NetworkLook {
  bool standing = false;  ///< terminals at (0, 0) and (0, width) when standing() has turned it
  /// What follows the name of a number, as " = 8 N/µm"; none: nothing.
  std::function<std::string(const Symbol&)> value = {};
  std::size_t most_branches = 6;
};

/// Of more than most_branches parallel branches all but one of these, and how many more there are.
Drawing draw(const Network& network, const NetworkLook& look = {});

/// A network that was drawn standing, turned downwards from (0, 0): `above` is to its right.
Shapes standing(const Drawing& drawing);

/// How many pixels the words take, about.
double width_of(const Label& words);

/// A drawing as an image; `description` is read to those who do not see it.
struct Picture {
  Drawing drawing;
  std::string description;
};

/// A name with its index set lower: "k0", "k[3]", "tau[2]".
Label label(const Symbol& symbol);

/// Puts `how` around what is done to the shapes already.
void transform(Shapes& shapes, const std::string& how);
/// Shapes moved to (x, y).
Shapes moved(double x, double y, Shapes shapes);
DrawnShape path(const std::string& d, const char* style);
/// A straight line.
DrawnShape line(double x1, double y1, double x2, double y2);
/// Text around a point.
DrawnShape text(double x, double y, const Label& words, const char* anchor = "middle");

/// All of them in one list.
template <class Item>
std::vector<Item> concatenated(std::initializer_list<std::vector<Item>> lists) {
  std::vector<Item> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace vcrit::validation::report

namespace vcrit::record {

void fields(Fields& f, const validation::report::Picture& picture);

}  // namespace vcrit::record
