#include "report/network_drawing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/constants.hpp"
#include "network/law.hpp"
#include "report/graph_layout.hpp"
#include "report/html.hpp"

namespace vcrit::validation::report {

namespace {

constexpr double element_width = 84, element_above = 33, element_below = 14;
constexpr double label_height = 18;
constexpr double bus = 14;         // between the bars of parallel branches and the branches
constexpr double branch_gap = 2;   // between stacked branches
constexpr double connection = 10;  // between elements in series

const char* const spring_path = "M0 0H18l4 -8l8 16l8 -16l8 16l8 -16l8 16l4 -8H84";
const char* const damper_path = "M0 0H32V-10H56M32 0V10H56M46 -7V7M46 0H84";

std::string path(const char* d, const char* kind) {
  return fmt::format(R"(<path class="{}" d="{}"/>)", kind, d);
}

/// "k_1, tau_1"
std::string names_of(const Element& element) {
  std::string names;
  for_each_number(element, [&](const Symbol& symbol, NumberRole) {
    names += (names.empty() ? "" : ", ") + label(symbol);
  });
  return names;
}

Drawing draw_maxwell(const Element& element) {
  return {2 * element_width, element_above, element_below,
          path(spring_path, "spring") + moved(element_width, 0, path(damper_path, "damper")) +
              text(element_width, -label_height, names_of(element))};
}

/// A box; what it pushes against, beyond the dashes, is inertial ground.
std::string mass_box() {
  return line(0, 0, 22, 0) + path("M62 0H84", "inertial") + path("M22 -12H62V12H22z", "solid");
}

std::string symbol_of(const Element& element) {
  if (element.kind == ElementKind::mass) return mass_box();
  return element.kind == ElementKind::spring || element.kind == ElementKind::lossy
             ? path(spring_path, "spring")
             : path(damper_path, "damper");
}

Drawing draw_element(const Element& element) {
  if (element.kind == ElementKind::maxwell) return draw_maxwell(element);
  return {element_width, element_above, element_below,
          symbol_of(element) + text(element_width / 2, -label_height, names_of(element))};
}

Drawing draw_series(const Series& series) {
  Drawing all;
  for (const Network& part : series.parts) {
    const Drawing drawing = draw(part);
    if (all.width > 0) {
      all.svg += line(all.width, 0, all.width + connection, 0);
      all.width += connection;
    }
    all.svg += moved(all.width, 0, drawing.svg);
    all.width += drawing.width;
    all.above = std::max(all.above, drawing.above);
    all.below = std::max(all.below, drawing.below);
  }
  return all;
}

std::string branch_in(const Drawing& branch, double y, double inner) {
  const double begin = bus + (inner - branch.width) / 2, end = begin + branch.width;
  return line(bus / 2, y, begin, y) + moved(begin, y, branch.svg) +
         line(end, y, inner + 1.5 * bus, y);
}

std::string bar(double x, double top, double bottom, double outer) {
  return line(x, top, x, bottom) + line(x, 0, outer, 0);
}

Drawing draw_parallel(const Parallel& parallel) {
  std::vector<Drawing> branches;
  for (const Network& part : parallel.parts) branches.push_back(draw(part));
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
    all.svg += branch_in(branches[i], ys[i] - middle, inner);
  const double reach = ys.back() - middle;
  all.svg += bar(bus / 2, -reach, reach, 0) + bar(width - bus / 2, -reach, reach, width);
  return all;
}

std::string dot(const Point& at) {
  return fmt::format(R"(<circle class="node" cx="{:.1f}" cy="{:.1f}" r="3.2"/>)", at.x, at.y);
}

/// The label of a single element beside its edge, upright whatever the edge's direction, on the
/// side away from the line between the terminals.
std::string edge_label(const Element& element, const Point& middle, double angle) {
  const double side = middle.y > 1 ? -1 : 1, away = side > 0 ? 20 : 22;
  const double x = middle.x + side * away * std::sin(angle);
  const double y = middle.y - side * away * std::cos(angle) + 5;
  const double tilt = side * std::sin(angle);
  const char* anchor = tilt > 0.3 ? "start" : tilt < -0.3 ? "end" : "middle";
  return text(x, y, names_of(element), anchor);
}

/// A part drawn along the straight line from one node to another, never upside down.
std::string edge(const Network& part, Point from, Point to) {
  if (from.x > to.x) std::swap(from, to);
  const double dx = to.x - from.x, dy = to.y - from.y;
  const double length = std::hypot(dx, dy), angle = std::atan2(dy, dx);
  const auto* element = std::get_if<Element>(&part.form);
  const bool upright = element != nullptr && element->kind != ElementKind::maxwell;
  const Drawing drawing = upright ? Drawing{element_width, 0, 0, symbol_of(*element)} : draw(part);
  const double lead = (length - drawing.width) / 2;
  const std::string lying =
      line(0, 0, lead, 0) + moved(lead, 0, drawing.svg) + line(lead + drawing.width, 0, length, 0);
  const std::string turned =
      fmt::format(R"svg(<g transform="translate({:.1f} {:.1f}) rotate({:.2f})">{}</g>)svg", from.x,
                  from.y, angle * 180 / pi, lying);
  const Point middle{(from.x + to.x) / 2, (from.y + to.y) / 2};
  return upright ? turned + edge_label(*element, middle, angle) : turned;
}

Drawing draw_graph(const Graph& graph) {
  double longest = 0, highest = 0;
  for (const Network& part : graph.parts) {
    const Drawing drawing = draw(part);
    longest = std::max(longest, drawing.width);
    highest = std::max(highest, drawing.above + drawing.below);
  }
  const GraphLayout layout = lay_out(graph, longest + 2 * connection);
  const double reach = layout.reach + highest / 2;
  Drawing all{layout.width, reach, reach, {}};
  for (std::size_t i = 0; i < graph.parts.size(); ++i) {
    const auto from = static_cast<std::size_t>(graph.wires[i].from);
    const auto to = static_cast<std::size_t>(graph.wires[i].to);
    all.svg += edge(graph.parts[i], layout.nodes[from], layout.nodes[to]);
  }
  for (const Point& node : layout.nodes) all.svg += dot(node);
  return all;
}

struct Drawer {
  Drawing operator()(const Element& element) const { return draw_element(element); }
  Drawing operator()(const Series& series) const { return draw_series(series); }
  Drawing operator()(const Parallel& parallel) const { return draw_parallel(parallel); }
  Drawing operator()(const Graph& graph) const { return draw_graph(graph); }
};

}  // namespace

Drawing draw(const Network& network) { return std::visit(Drawer{}, network.form); }

std::string framed(const Drawing& drawing, const std::string& description) {
  constexpr double margin = 8;
  const double width = drawing.width + 2 * margin;
  const double height = drawing.above + drawing.below + 2 * margin;
  return fmt::format(
      R"(<svg class="drawing" role="img" aria-label="{}" width="{:.0f}" height="{:.0f}" )"
      R"(viewBox="{:.0f} {:.1f} {:.0f} {:.0f}">{}</svg>)",
      escape(description), width, height, -margin, -drawing.above - margin, width, height,
      drawing.svg);
}

std::string label(const Symbol& symbol) {
  const bool time = symbol.name.starts_with("tau"), loss = symbol.name.starts_with("eta");
  const std::string base = time ? "τ" : loss ? "η" : symbol.name.substr(0, 1);
  std::string index = symbol.name.substr(time || loss ? 3 : 1);
  if (!index.empty() && index.front() == '_') index.erase(0, 1);
  if (symbol.entry > 0) index += (index.empty() ? "" : ",") + std::to_string(symbol.entry);
  const std::string letter = fmt::format(R"(<tspan class="letter">{}</tspan>)", escape(base));
  if (index.empty()) return letter;
  // The second tspan returns to the line, so that text may follow.
  return fmt::format(R"({}<tspan class="index" dy="4">{}</tspan><tspan dy="-4">&#8203;</tspan>)",
                     letter, escape(index));
}

std::string moved(double x, double y, const std::string& svg) {
  return fmt::format(R"svg(<g transform="translate({:.1f} {:.1f})">{}</g>)svg", x, y, svg);
}

std::string line(double x1, double y1, double x2, double y2) {
  return fmt::format(R"(<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}"/>)", x1, y1, x2, y2);
}

std::string text(double x, double y, const std::string& content, const char* anchor) {
  return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">{}</text>)", x, y, anchor,
                     content);
}

}  // namespace vcrit::validation::report
