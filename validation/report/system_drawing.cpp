#include "report/system_drawing.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "report/network_drawing.hpp"

namespace vcrit::validation::report {

namespace {

std::string italic(const char* letter) {
  return fmt::format(R"(<tspan class="letter">{}</tspan>)", letter);
}

/// Pieces side by side on one line.
class Row {
 public:
  void add(const Drawing& piece) {
    all_.svg += moved(all_.width, 0, piece.svg);
    all_.width += piece.width;
    all_.above = std::max(all_.above, piece.above);
    all_.below = std::max(all_.below, piece.below);
  }

  std::string svg(const std::string& description) const { return framed(all_, description); }

 private:
  Drawing all_;
};

/// A hatched edge from (0, 0) along +x; the hatching lies below it.
std::string ground(double length) {
  std::string svg = fmt::format(R"(<path class="heavy" d="M0 0H{:.0f}"/>)", length);
  for (double x = 6; x <= length; x += 8) svg += line(x, 0, x - 6, 7);
  return svg;
}

/// The contact point on the substrate, with the coefficient of friction.
Drawing contact_point(const Symbol& coefficient) {
  const std::string name = coefficient == Symbol{"mu0"}
                               ? italic("μ") + R"(<tspan class="index" dy="4">0</tspan>)"
                               : label(coefficient);
  return {52, 14, 52,
          R"(<path class="solid" d="M12 -9H44V9H12z"/>)" + line(44, 0, 52, 0) +
              moved(0, 9, ground(56)) + text(28, 40, name)};
}

Drawing wall() {
  return {18, 34, 34,
          fmt::format(R"svg(<g transform="translate(8 -32) rotate(90)">{}</g>)svg", ground(64)) +
              line(8, 0, 18, 0)};
}

Drawing body(const Symbol& mass) {
  return {64, 28, 28,
          line(0, 0, 6, 0) + R"(<path class="solid" d="M6 -26H58V26H6z"/>)" +
              text(32, 5, label(mass)) + line(58, 0, 64, 0)};
}

Drawing joint() {
  return {12, 10, 10, R"(<path class="heavy" d="M6 -10V10"/>)" + line(0, 0, 12, 0)};
}

Drawing arrow(const std::string& name) {
  return {62, 26, 8,
          line(0, 0, 16, 0) + R"(<path class="arrow" d="M16 0H52M44 -5L53 0L44 5"/>)" +
              text(34, -11, name)};
}

Drawing oscillation() {
  const std::string name =
      italic("u") + R"(<tspan class="index" dy="4">z</tspan>)" + R"(<tspan dy="-4">(t)</tspan>)";
  return {76, 30, 30,
          R"(<path class="heavy" d="M6 -20V20"/>)" + line(0, 0, 6, 0) +
              R"(<path class="arrow" d="M16 0H66M24 -5L15 0L24 5M58 -5L67 0L58 5"/>)" +
              text(42, -11, name)};
}

/// A drive of which only the receptance is known.
Drawing measured_drive() {
  return {92, 28, 28,
          line(0, 0, 10, 0) + R"(<path class="solid" d="M10 -22H82V22H10z"/>)" +
              text(46, 5, label({"R_d"})) + line(82, 0, 92, 0)};
}

std::string drive_speed() { return italic("v") + R"(<tspan class="index" dy="4">0</tspan>)"; }

/// An isotropic contact: the normal network within brackets, with the ratio in front.
Drawing times(double factor, const Drawing& network) {
  constexpr double before = 84, after = 26;
  const double top = -network.above, bottom = network.below;
  const auto bracket = [&](double x, int side) {
    return fmt::format(R"(<path class="bracket" d="M{0:.1f} {1:.1f}H{2:.1f}V{3:.1f}H{0:.1f}"/>)",
                       x + 6 * side, top, x, bottom);
  };
  const double end = before + network.width;
  return {end + after, network.above, network.below,
          line(0, 0, before, 0) + moved(before, 0, network.svg) + line(end, 0, end + after, 0) +
              bracket(before - 10, 1) + bracket(end + 12, -1) +
              text(before - 48, -8, fmt::format("{:.4g} ×", factor))};
}

/// Its elements by the names that the scene gives them.
Scene by_written_names(Scene scene) {
  const auto name = [names = scene](const Symbol& symbol) { return as_called(names, symbol); };
  rename(scene.normal, name);
  if (auto* own = std::get_if<Network>(&scene.tangential)) rename(*own, name);
  if (scene.drive) rename(*scene.drive, name);
  return scene;
}

Drawing tangential(const Scene& scene) {
  const auto* isotropic = std::get_if<Isotropic>(&scene.tangential);
  if (isotropic == nullptr) return draw(std::get<Network>(scene.tangential));
  const double ratio = tangential_ratio(*isotropic);
  return ratio == 1 ? draw(scene.normal) : times(ratio, draw(scene.normal));
}

}  // namespace

std::string draw_sliding(const Scene& given) {
  const Scene scene = by_written_names(given);
  Row row;
  std::string description = "Substrate, contact point, tangential contact network";
  row.add(contact_point(as_called(scene, scene.coefficient.symbol)));
  row.add(tangential(scene));
  if (scene.mass) {
    row.add(body(as_called(scene, scene.mass->symbol)));
    description += ", body";
  } else if (has_drive(scene)) {
    row.add(joint());
  }
  if (scene.drive) {
    row.add(draw(*scene.drive));
    description += ", drive network";
  }
  if (scene.receptance) {
    row.add(measured_drive());
    description += ", measured drive";
  }
  row.add(arrow(drive_speed()));
  return row.svg(description + ", moved at constant velocity");
}

std::string draw_normal(const Scene& given) {
  const Scene scene = by_written_names(given);
  Row row;
  row.add(wall());
  row.add(draw(scene.normal));
  row.add(oscillation());
  return row.svg("Substrate, normal contact network, imposed oscillation");
}

}  // namespace vcrit::validation::report
