#include "report/system_drawing.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "report/network_drawing.hpp"

namespace vcrit::validation::report {

namespace {

Word italic(const char* letter) { return {"letter", letter, ""}; }
Word lowered(const char* index) { return {"index", index, "4"}; }

/// Pieces side by side on one line.
class Row {
 public:
  void add(const Drawing& piece) {
    all_.add(moved(all_.width, 0, piece.shapes));
    all_.width += piece.width;
    all_.above = std::max(all_.above, piece.above);
    all_.below = std::max(all_.below, piece.below);
  }

  Picture picture(const std::string& description) const { return {all_, description}; }

 private:
  Drawing all_;
};

/// A hatched edge from (0, 0) along +x; the hatching lies below it.
Shapes ground(double length) {
  Shapes shapes{path(fmt::format("M0 0H{:.0f}", length), "heavy")};
  for (double x = 6; x <= length; x += 8) shapes.push_back(line(x, 0, x - 6, 7));
  return shapes;
}

/// The contact point on the substrate, with the coefficient of friction.
Drawing contact_point(const Symbol& coefficient) {
  const Label name =
      coefficient == Symbol{"mu0"} ? Label{italic("μ"), lowered("0")} : label(coefficient);
  return {52, 14, 52,
          joined({{path("M12 -9H44V9H12z", "solid"), line(44, 0, 52, 0)},
                  moved(0, 9, ground(56)),
                  {text(28, 40, name)}})};
}

Drawing wall() {
  Shapes upright = ground(64);
  transform(upright, "translate(8 -32) rotate(90)");
  upright.push_back(line(8, 0, 18, 0));
  return {18, 34, 34, upright};
}

Drawing body(const Symbol& mass) {
  return {64,
          28,
          28,
          {line(0, 0, 6, 0), path("M6 -26H58V26H6z", "solid"), text(32, 5, label(mass)),
           line(58, 0, 64, 0)}};
}

Drawing joint() { return {12, 10, 10, {path("M6 -10V10", "heavy"), line(0, 0, 12, 0)}}; }

Drawing arrow(const Label& name) {
  return {62,
          26,
          8,
          {line(0, 0, 16, 0), path("M16 0H52M44 -5L53 0L44 5", "arrow"), text(34, -11, name)}};
}

Drawing oscillation() {
  const Label name{italic("u"), lowered("z"), {"", "(t)", "-4"}};
  return {76,
          30,
          30,
          {path("M6 -20V20", "heavy"), line(0, 0, 6, 0),
           path("M16 0H66M24 -5L15 0L24 5M58 -5L67 0L58 5", "arrow"), text(42, -11, name)}};
}

/// A drive of which only the receptance is known.
Drawing measured_drive() {
  return {92,
          28,
          28,
          {line(0, 0, 10, 0), path("M10 -22H82V22H10z", "solid"), text(46, 5, label({"R_d"})),
           line(82, 0, 92, 0)}};
}

Label drive_speed() { return {italic("v"), lowered("0")}; }

/// An isotropic contact: the normal network within brackets, with the ratio in front.
Drawing times(double factor, const Drawing& network) {
  constexpr double before = 84, after = 26;  // px: the factor and a bracket; a bracket
  const double top = -network.above, bottom = network.below;
  const auto bracket = [&](double x, int side) {
    return path(
        fmt::format("M{0:.1f} {1:.1f}H{2:.1f}V{3:.1f}H{0:.1f}", x + 6 * side, top, x, bottom),
        "bracket");
  };
  const double end = before + network.width;
  const Label words{{"", fmt::format("{:.4g} ×", factor), ""}};
  return {end + after, network.above, network.below,
          joined({{line(0, 0, before, 0)},
                  moved(before, 0, network.shapes),
                  {line(end, 0, end + after, 0), bracket(before - 10, 1), bracket(end + 12, -1),
                   text(before - 48, -8, words)}})};
}

/// Its elements by the names that the scene gives them.
Drawing draw_written(const Problem& problem, const ReducedNetwork& given) {
  Network network = given.network();
  rename(network, [&](const Symbol& symbol) { return as_called(problem, symbol); });
  return draw(network);
}

Drawing tangential(const Problem& problem) {
  const auto* isotropic = std::get_if<Isotropic>(&problem->tangential);
  if (isotropic == nullptr)
    return draw_written(problem, std::get<ReducedNetwork>(problem->tangential));
  const double ratio = tangential_ratio(*isotropic);
  const Drawing normal = draw_written(problem, problem->normal);
  return ratio == 1 ? normal : times(ratio, normal);
}

}  // namespace

Picture draw_sliding(const Problem& problem) {
  Row row;
  std::string description = "Substrate, contact point, tangential contact network";
  row.add(contact_point(as_called(problem, problem->coefficient.symbol)));
  row.add(tangential(problem));
  if (problem->mass) {
    row.add(body(as_called(problem, problem->mass->symbol)));
    description += ", body";
  } else if (!problem->rigid()) {
    row.add(joint());
  }
  std::visit(Overloaded{[](const Rigid&) {},
                        [&](const ReducedNetwork& drive) {
                          row.add(draw_written(problem, drive));
                          description += ", drive network";
                        },
                        [&](const Receptance&) {
                          row.add(measured_drive());
                          description += ", measured drive";
                        }},
             problem->drive);
  row.add(arrow(drive_speed()));
  return row.picture(description + ", moved at constant velocity");
}

Picture draw_normal(const Problem& problem) {
  Row row;
  row.add(wall());
  row.add(draw_written(problem, problem->normal));
  row.add(oscillation());
  return row.picture("Substrate, normal contact network, imposed oscillation");
}

}  // namespace vcrit::validation::report
