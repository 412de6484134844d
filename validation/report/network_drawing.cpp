#include "report/network_drawing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "base/constants.hpp"
#include "base/errors.hpp"
#include "network/law.hpp"
#include "report/graph_layout.hpp"

namespace vcrit::validation::report {

namespace {

constexpr double element_width = 84, element_above = 33,
                 element_below = 14;  // px, of the paths below
constexpr double label_height = 18;   // above the line: clear of a mass's box
constexpr double bus = 14;            // between the bars of parallel branches and the branches
constexpr double branch_gap = 2;      // between stacked branches
constexpr double connection = 10;     // between elements in series
constexpr double beside = 13;         // from a standing element to its names
constexpr const char* no_width = "\u200b";

const char* const spring_path = "M0 0H18l4 -8l8 16l8 -16l8 16l8 -16l8 16l4 -8H84";
const char* const damper_path = "M0 0H32V-10H56M32 0V10H56M46 -7V7M46 0H84";

/// "k_1, tau_1"
Label names_of(const Element& element, const NetworkLook& look) {
  Label names;
  const auto add = [&](const Symbol& symbol, NumberRole) {
    if (!names.empty()) names.push_back({"", ", ", ""});
    names = concatenated({names, label(symbol)});
    if (look.value) names.push_back({"", look.value(symbol), ""});
  };
  for_each_amount(element, [&](const Amount& amount, NumberRole role) {
    if (amount.name().name.empty())
      for_each_symbol(amount, role, add);
    else
      add(amount.name(), role);
  });
  return names;
}

/// A box; what it pushes against, beyond the dashes, is inertial ground.
Shapes mass_box() {
  return {line(0, 0, 22, 0), path("M62 0H84", "inertial"), path("M22 -12H62V12H22z", "solid")};
}

/// Of whatever is in it no more is known than its table.
Shapes measured_box() {
  return {line(0, 0, 22, 0), path("M22 -12H62V12H22z", "solid"), line(62, 0, 84, 0)};
}

/// Without its names. A Maxwell branch is two symbols in series.
Drawing symbol_of(const Element& element) {
  const auto drawn = [](Shapes shapes, int symbols = 1) {
    return Drawing{symbols * element_width, element_above, element_below, std::move(shapes)};
  };
  const DrawnShape spring = path(spring_path, "spring"), damper = path(damper_path, "damper");
  switch (element.kind) {
    case ElementKind::spring:
    case ElementKind::lossy:
      return drawn({spring});
    case ElementKind::damper:
      return drawn({damper});
    case ElementKind::mass:
      return drawn(mass_box());
    case ElementKind::measured:
      return drawn(measured_box());
    case ElementKind::maxwell:
      return drawn(concatenated({{spring}, moved(element_width, 0, {damper})}), 2);
  }
  throw Bug("an element without a symbol");
}

/// Words that stay upright when all is turned, to the right of (x, 0) then.
DrawnShape upright_text(double x, const Label& words) {
  DrawnShape shape = text(x, 5 - beside, words, "start");
  shape.transform = fmt::format("rotate(-90 {:.1f} {:.1f})", x, -beside);
  return shape;
}

/// In the middle of a line that is as long as its names, if these stand over it.
Drawing draw_element(const Element& element, const NetworkLook& look) {
  Drawing drawing = symbol_of(element);
  const Label names = names_of(element, look);
  if (look.standing) {
    drawing.above = beside + width_of(names) + 8;
    drawing.add({upright_text(drawing.width / 2, names)});
    return drawing;
  }
  const double lead = std::max(0.0, (width_of(names) + 8 - drawing.width) / 2);
  const double end = lead + drawing.width;
  drawing.shapes = moved(lead, 0, drawing.shapes);
  if (lead > 0) drawing.add({line(0, 0, lead, 0), line(end, 0, end + lead, 0)});
  drawing.width = end + lead;
  drawing.add({text(drawing.width / 2, -label_height, names)});
  return drawing;
}

Drawing draw_series(const Series& series, const NetworkLook& look) {
  Drawing all;
  for (const Network& part : series.parts) {
    const Drawing drawing = draw(part, look);
    if (all.width > 0) {
      all.shapes.push_back(line(all.width, 0, all.width + connection, 0));
      all.width += connection;
    }
    all.add(moved(all.width, 0, drawing.shapes));
    all.width += drawing.width;
    all.above = std::max(all.above, drawing.above);
    all.below = std::max(all.below, drawing.below);
  }
  return all;
}

Shapes branch_in(const Drawing& branch, double y, double inner) {
  const double begin = bus + (inner - branch.width) / 2, end = begin + branch.width;
  return concatenated({{line(bus / 2, y, begin, y)},
                       moved(begin, y, branch.shapes),
                       {line(end, y, inner + 1.5 * bus, y)}});
}

Shapes bar(double x, double top, double bottom, double outer) {
  return {line(x, top, x, bottom), line(x, 0, outer, 0)};
}

/// In place of branches that would look like those before.
Drawing more_branches(std::size_t count, const NetworkLook& look) {
  const Label words{{"", fmt::format("and {} more", count), ""}};
  Drawing drawing{element_width,
                  element_above,
                  element_below,
                  {path(fmt::format("M0 0H{:.0f}", element_width), "inertial")}};
  if (look.standing) drawing.above = beside + width_of(words) + 8;
  drawing.add({look.standing ? upright_text(element_width / 2, words)
                             : text(element_width / 2, -8, words)});
  return drawing;
}

Drawing draw_parallel(const Parallel& parallel, const NetworkLook& look) {
  std::vector<Drawing> branches;
  const std::size_t count = parallel.parts.size(),
                    shown = count > look.most_branches ? look.most_branches - 1 : count;
  for (std::size_t i = 0; i < shown; ++i) branches.push_back(draw(parallel.parts[i], look));
  if (shown < count) branches.push_back(more_branches(count - shown, look));
  if (look.standing) std::reverse(branches.begin(), branches.end());  // the first is on the left
  std::vector<double> ys;
  double inner = 0, y = 0;
  for (const Drawing& branch : branches) {
    inner = std::max(inner, branch.width);
    y += branch.above;
    ys.push_back(y);
    y += branch.below + branch_gap;
  }
  const double middle = (ys.front() + ys.back()) / 2, width = inner + 2 * bus;
  Drawing all{width, middle, y - branch_gap - middle, {}};
  for (std::size_t i = 0; i < branches.size(); ++i)
    all.add(branch_in(branches[i], ys[i] - middle, inner));
  const double reach = ys.back() - middle;
  all.add(bar(bus / 2, -reach, reach, 0));
  all.add(bar(width - bus / 2, -reach, reach, width));
  return all;
}

DrawnShape dot(const LayoutPoint& at) {
  DrawnShape shape;
  shape.form = DrawnShape::Form::node;
  shape.x = at.x;
  shape.y = at.y;
  return shape;
}

/// The label of a single element beside its edge, upright whatever the edge's direction, on the
/// side away from the line between the terminals.
DrawnShape edge_label(const Element& element, const LayoutPoint& middle, double angle,
                      const NetworkLook& look) {
  const double side = middle.y > 1 ? -1 : 1, away = side > 0 ? 20 : 22;
  const double x = middle.x + side * away * std::sin(angle);
  const double y = middle.y - side * away * std::cos(angle);
  const double tilt = side * (look.standing ? std::cos(angle) : std::sin(angle));
  const char* anchor = tilt > 0.3 ? "start" : tilt < -0.3 ? "end" : "middle";
  DrawnShape shape = text(x, y + 5, names_of(element, look), anchor);
  if (look.standing) shape.transform = fmt::format("rotate(-90 {:.1f} {:.1f})", x, y);
  return shape;
}

/// A part drawn along the straight line from one node to another, never upside down.
Shapes edge(const Network& part, LayoutPoint from, LayoutPoint to, const NetworkLook& look) {
  if (from.x > to.x) std::swap(from, to);
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double length = std::hypot(dx, dy), angle = std::atan2(dy, dx);
  const auto* element = std::get_if<Element>(&part.form);
  const bool upright = element != nullptr && symbol_of(*element).width == element_width;
  const Drawing drawing = upright ? symbol_of(*element) : draw(part, look);
  const double lead = (length - drawing.width) / 2;
  Shapes all = concatenated({{line(0, 0, lead, 0)},
                             moved(lead, 0, drawing.shapes),
                             {line(lead + drawing.width, 0, length, 0)}});
  transform(all, fmt::format("translate({:.1f} {:.1f}) rotate({:.2f})", from.x, from.y,
                             angle * 180 / pi));
  const LayoutPoint middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
  if (upright) all.push_back(edge_label(*element, middle, angle, look));
  return all;
}

/// Parts that join the same two nodes are one edge, beside each other; they would lie on each
/// other.
Graph with_single_edges(const Graph& graph) {
  Graph single{graph.nodes, {}, {}};
  std::map<std::pair<int, int>, std::size_t> known;
  for (std::size_t i = 0; i < graph.parts.size(); ++i) {
    const auto [from, to] = graph.wires[i];
    const auto [edge, is_new] =
        known.try_emplace({std::min(from, to), std::max(from, to)}, single.parts.size());
    if (is_new) {
      single.parts.push_back(graph.parts[i]);
      single.wires.push_back(graph.wires[i]);
    } else {
      Network& before = single.parts[edge->second];
      before = parallel({before, graph.parts[i]});
    }
  }
  return single;
}

/// Without the edge that joins both terminals, which would run through whatever is between them.
std::optional<std::pair<Graph, Network>> direct_edge_apart(Graph graph) {
  const auto direct = std::find_if(graph.wires.begin(), graph.wires.end(),
                                   [](const Wire& it) { return it.from + it.to == 1; });
  if (direct == graph.wires.end() || graph.wires.size() == 1) return std::nullopt;
  const auto part = graph.parts.begin() + (direct - graph.wires.begin());
  Network apart = std::move(*part);
  graph.parts.erase(part);
  graph.wires.erase(direct);
  return std::pair{std::move(graph), std::move(apart)};
}

Drawing draw_graph(const Graph& drawn, const NetworkLook& look) {
  const Graph graph = with_single_edges(drawn);
  if (const auto apart = direct_edge_apart(graph))
    return draw(parallel({Network{apart->first}, apart->second}), look);
  double longest = 0, highest = 0;
  for (const Network& part : graph.parts) {
    const Drawing drawing = draw(part, look);
    longest = std::max(longest, drawing.width);
    highest = std::max(highest, drawing.above + drawing.below);
  }
  const GraphLayout layout = lay_out(graph, longest + 2 * connection);
  const double reach = layout.reach + highest / 2;
  Drawing all{layout.width, reach, reach, {}};
  for (std::size_t i = 0; i < graph.parts.size(); ++i) {
    const auto from = static_cast<std::size_t>(graph.wires[i].from);
    const auto to = static_cast<std::size_t>(graph.wires[i].to);
    all.add(edge(graph.parts[i], layout.nodes[from], layout.nodes[to], look));
  }
  for (const LayoutPoint& node : layout.nodes) all.shapes.push_back(dot(node));
  return all;
}

struct Drawer {
  const NetworkLook& look;
  Drawing operator()(const Element& element) const { return draw_element(element, look); }
  Drawing operator()(const Series& series) const { return draw_series(series, look); }
  Drawing operator()(const Parallel& parallel) const { return draw_parallel(parallel, look); }
  Drawing operator()(const Graph& graph) const { return draw_graph(graph, look); }
};

}  // namespace

Drawing draw(const Network& network, const NetworkLook& look) {
  return std::visit(Drawer{look}, network.form);
}

Shapes standing(const Drawing& drawing) {
  Shapes shapes = drawing.shapes;
  transform(shapes, "rotate(90)");
  return shapes;
}

double width_of(const Label& words) {
  constexpr double letter = 8.4, small_letter = 6.8;  // px, of the style sheet's fonts
  double width = 0;
  for (const Word& word : words)
    for (const char c : word.text == no_width ? "" : word.text)  // not bytes that continue a letter
      if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U)
        width += word.style == "index" ? small_letter : letter;
  return width;
}

Label label(const Symbol& symbol) {
  const bool time = symbol.name.starts_with("tau"), loss = symbol.name.starts_with("eta");
  const std::string base = time ? "τ" : loss ? "η" : symbol.name.substr(0, 1);
  std::string index = symbol.name.substr(time || loss ? 3 : 1);
  if (!index.empty() && index.front() == '_') index.erase(0, 1);
  if (symbol.entry > 0) index += (index.empty() ? "" : ",") + std::to_string(symbol.entry);
  if (index.empty()) return {{"letter", base, ""}};
  // The last word, of no width, returns to the line, so that text may follow.
  return {{"letter", base, ""}, {"index", index, "4"}, {"", no_width, "-4"}};
}

void Drawing::add(const Shapes& more) { shapes.insert(shapes.end(), more.begin(), more.end()); }

void transform(Shapes& shapes, const std::string& how) {
  for (DrawnShape& shape : shapes)
    shape.transform = how + (shape.transform.empty() ? "" : " ") + shape.transform;
}

Shapes moved(double x, double y, Shapes shapes) {
  transform(shapes, fmt::format("translate({:.1f} {:.1f})", x, y));
  return shapes;
}

DrawnShape path(const std::string& d, const char* style) {
  DrawnShape shape;
  shape.d = d;
  shape.style = style;
  return shape;
}

DrawnShape line(double x1, double y1, double x2, double y2) {
  return path(fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", x1, y1, x2, y2), "");
}

DrawnShape text(double x, double y, const Label& words, const char* anchor) {
  DrawnShape shape;
  shape.form = DrawnShape::Form::text;
  shape.x = x;
  shape.y = y;
  shape.words = words;
  shape.anchor = anchor;
  return shape;
}

}  // namespace vcrit::validation::report

namespace vcrit::record {

namespace report = validation::report;
using validation::report::DrawnShape;

void fields(Fields& f, const report::Word& it) {
  f("style", it.style)("word", it.text)("shift", it.shift);
}

void fields(Fields& f, const DrawnShape& it) {
  f("is_path", it.form == DrawnShape::Form::path)("is_node", it.form == DrawnShape::Form::node);
  f("is_text", it.form == DrawnShape::Form::text)("transform", it.transform)("shape_style",
                                                                             it.style);
  f("d", it.d)("x", it.x)("y", it.y)("anchor", it.anchor)("words", it.words);
}

void fields(Fields& f, const report::Picture& it) {
  constexpr double margin = 8;  // px: strokes and ends of labels reach beyond the shapes
  const report::Drawing& drawing = it.drawing;
  f("description", it.description)("width", drawing.width + 2 * margin);
  f("height", drawing.above + drawing.below + 2 * margin);
  f("left", -margin)("top", -drawing.above - margin)("shapes", drawing.shapes);
}

}  // namespace vcrit::record
