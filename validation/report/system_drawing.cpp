#include "report/system_drawing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "network/law.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

constexpr double body_height = 44, plate_height = 20, foot_height = 16, foot_width = 44;  // px
constexpr double body_reach = 48;            // to the left of the middle, at least
constexpr std::size_t most_with_values = 4;  // names and values of more would need too much room

Word italic(const char* letter) { return {"letter", letter, ""}; }
Word lowered(const char* index) { return {"index", index, "4"}; }
Word plain(const std::string& words) { return {"", words, ""}; }
/// After a letter with an index, back on the line.
Word raised(const std::string& words) { return {"", words, "-4"}; }

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
  double left() const { return left_; }
  double right() const { return right_; }
  Picture picture(const std::string& description) {
    all_.shapes = moved(-left_, 0, all_.shapes);
    all_.width = right_ - left_;
    return {all_, description};
  }

 private:
  Drawing all_;
  double left_ = 0, right_ = 0;
};

std::string value_words(const Problem& problem, const Quantity& quantity, const char* unit) {
  return " = " + vcrit::validation::report::quantity(problem.value(quantity), unit, 4);
}

/// Elements by the names that the scene gives them, with values unless they are many.
class DrawnNetwork {
 public:
  DrawnNetwork(const Problem& problem, const ReducedNetwork& given, bool standing,
               bool of_half_space = false)
      : look_{standing, {}} {
    Network network = given.network();
    std::map<Symbol, std::string> words;
    for_each_element(given.network(), [&](const Element& element) {
      for_each_number(element, [&](const Symbol& symbol, NumberRole role) {
        const NumberRow& row = number_row(role);
        const Dimension dimension = of_half_space ? row.in_half_space : row.dimension;
        const char* unit = dimension == Dimension::none ? "" : si_unit(dimension);
        const auto known = problem.values().find(symbol);
        if (known != problem.values().end())
          words[as_called(problem, symbol)] = " = " + quantity(known->second, unit, 4);
      });
    });
    rename(network, [&](const Symbol& symbol) { return as_called(problem, symbol); });
    if (numbers_in(network) <= most_with_values)
      look_.value = [words](const Symbol& symbol) {
        const auto found = words.find(symbol);
        return found == words.end() ? std::string() : found->second;
      };
    drawing_ = draw(network, look_);
  }
  const Drawing& drawing() const { return drawing_; }

 private:
  static std::size_t numbers_in(const Network& network) {
    std::size_t count = 0;
    for_each_element(network, [&](const Element& element) {
      for_each_amount(element, [&](const Amount&, NumberRole) { ++count; });
    });
    return count;
  }

  NetworkLook look_;
  Drawing drawing_;
};

/// A hatched edge from x to x + length; the hatching lies below it.
Shapes ground(double x, double y, double length) {
  Shapes shapes{path(fmt::format("M{:.0f} {:.0f}h{:.0f}", x, y, length), "heavy")};
  for (double at = 6; at <= length; at += 8) shapes.push_back(line(x + at, y, x + at - 6, y + 7));
  return shapes;
}

Shapes arrow_to_both_sides(double y, double length) {
  return {
      path(fmt::format("M0 {0:.0f}v{1:.0f}m-5 -8l5 9l5 -9M-5 {2:.0f}l5 -9l5 9", y, length, y + 8),
           "arrow")};
}

Label coefficient_words(const Problem& problem) {
  const Symbol symbol = as_called(problem, problem->coefficient.symbol);
  const std::string value = value_words(problem, problem->coefficient, "");
  if (symbol == Symbol{"mu0"}) return {italic("μ"), lowered("0"), raised(value)};
  return joined({label(symbol), {plain(value)}});
}

/// "u_z(t) = 0.5 + 0.1 cos ωt µm"; under a load "W = 20 N, Δu_z(t) = 0.1 cos ωt µm"
Label oscillation_words(const Problem& problem) {
  const double amplitude = problem.value(problem->amplitude);
  if (problem->load) {
    const Scale scale = scale_for(amplitude, "m");
    const Label load = joined({label(as_called(problem, problem->load->symbol)),
                               {plain(value_words(problem, *problem->load, "N"))}});
    if (problem->mount)
      return joined({load,
                     {plain(", "), italic("U"),
                      plain(fmt::format(" = {:.4g} {}", amplitude * scale.factor, scale.unit))}});
    return joined(
        {load,
         {plain(", "), italic("Δu"), lowered("z"),
          raised(fmt::format("(t) = {:.4g} cos ωt {}", amplitude * scale.factor, scale.unit))}});
  }
  if (problem->mount) {
    const Scale scale = scale_for(amplitude, "m");
    return {italic("U"), plain(fmt::format(" = {:.4g} {}", amplitude * scale.factor, scale.unit))};
  }
  const double mean = problem.value(problem->indentation);
  const Scale scale = scale_for(std::max(mean, amplitude), "m");
  return {italic("u"), lowered("z"),
          raised(fmt::format("(t) = {:.4g} + {:.4g} cos ωt {}", mean * scale.factor,
                             amplitude * scale.factor, scale.unit))};
}

/// What presses into the half-space, from the body's bottom corners at y = -16 down to 6.
const char* profile(Indenter::Shape shape) {
  switch (shape) {
    case Indenter::Shape::flat:
      return "M60 -16H36V6H-36V-16H-60";
    case Indenter::Shape::cone:
      return "M60 -16L0 6L-60 -16";
    case Indenter::Shape::parabola:
      return "M60 -16Q0 28 -60 -16";
    case Indenter::Shape::power:
    case Indenter::Shape::table:
      return "M60 -16C30 13 -30 13 -60 -16";
  }
  throw Bug("an indenter without a shape");
}

/// The material of the half-space below the indenter, with its network within. Returns how far
/// down.
double draw_half_space(Canvas& canvas, const Problem& problem, const Drawing& network) {
  constexpr double depth = 14;  // of the network's upper end
  const double bottom = depth + network.width;
  canvas.put({path(profile(problem->indenter->shape), "")});
  canvas.put({path("M-92 0H-34M34 0H92", "heavy"), line(0, 6, 0, depth)});
  canvas.put(moved(0, depth, standing(network)));
  canvas.reach(-92, 92, 0, bottom);
  canvas.write(-66, -6, coefficient_words(problem), "end");
  return bottom;
}

/// The contact's own network along the surface, from the foot to an arm of the body at `at`.
double draw_tangential(Canvas& canvas, const Drawing& network, double y, double from, double at) {
  const double start = at - network.width - 10;
  canvas.put({line(from, y, start, y), line(at - 10, y, at, y),
              path(fmt::format("M{0:.1f} 0V{1:.1f}", at, y + 8), "heavy")});
  canvas.put(moved(start, y, network.shapes));
  canvas.reach(from, at, y - network.above, y + network.below);
  return at;
}

struct Contact {
  double bottom = 0, right = 0;  ///< of what is below the body, and how far the body must reach
};

Contact draw_contact(Canvas& canvas, const Problem& problem, const Drawing& normal) {
  const auto* own = std::get_if<ReducedNetwork>(&problem->tangential);
  const Drawing tangential =
      own == nullptr ? Drawing() : DrawnNetwork(problem, *own, false).drawing();
  const double foot = own == nullptr ? foot_height : std::max(foot_height, tangential.below + 16);
  const double gap = problem->separation ? 7 : 0;
  const double sole = normal.width + foot, surface = sole + gap;
  canvas.put(standing(normal));
  canvas.reach(-normal.below, normal.above, 0, surface);
  canvas.put({path(fmt::format("M{:.1f} {:.1f}h{:.1f}v{:.1f}h{:.1f}z", -foot_width / 2,
                               normal.width, foot_width, foot, -foot_width),
                   "solid")});
  double right = std::max(normal.above, body_reach);
  if (own != nullptr)
    right = draw_tangential(canvas, tangential, normal.width + 8, foot_width / 2,
                            right + tangential.width + 20) +
            8;
  const double left = std::min(-normal.below, -body_reach) - 40;
  canvas.put(ground(left, surface, std::max(right, body_reach) + 12 - left));
  canvas.reach(left, right, surface, surface + 8);
  canvas.write(-foot_width / 2 - 8, surface - 6, coefficient_words(problem), "end");
  if (gap > 0) canvas.write(foot_width / 2 + 8, surface - 3, {plain("may open")});
  return {surface, right};
}

/// Right of the body, with the arrow of its speed.
void draw_drive(Canvas& canvas, const Problem& problem, double x, double y, std::string& words) {
  double at = x;
  const auto add = [&](const Drawing& drawing) {
    canvas.put(moved(at, y, drawing.shapes));
    canvas.reach(at, at + drawing.width, y - drawing.above, y + drawing.below);
    at += drawing.width;
  };
  std::visit(Overloaded{[](const Rigid&) {},
                        [&](const ReducedNetwork& drive) {
                          add(DrawnNetwork(problem, drive, false).drawing());
                          words += ", drive network";
                        },
                        [&](const Receptance&) {
                          add({92,
                               26,
                               26,
                               {line(0, 0, 10, 0), path("M10 -22H82V22H10z", "solid"),
                                text(46, 5, label({"R_d"})), line(82, 0, 92, 0)}});
                          words += ", measured drive";
                        }},
             problem->drive);
  add({58,
       26,
       8,
       {line(0, 0, 12, 0), path("M12 0H50M42 -5L51 0L42 5", "arrow"),
        text(32, -11, {italic("v"), lowered("0")})}});
}

/// Above the body: the mount and, at its upper end, the vibrator. Returns where that ends.
double draw_mount(Canvas& canvas, const Problem& problem, double top, std::string& words) {
  constexpr double half_width = 44, height = 22;
  const Drawing mount = DrawnNetwork(problem, *problem->mount, true).drawing();
  const double lower = top - mount.width, upper = lower - height;
  canvas.put(moved(0, lower, standing(mount)));
  canvas.reach(-mount.below, mount.above, lower, top);
  canvas.put({path(fmt::format("M{:.1f} {:.1f}H{:.1f}V{:.1f}H{:.1f}z", -half_width, upper,
                               half_width, lower, -half_width),
                   "solid")});
  canvas.reach(-half_width, half_width, upper, lower);
  canvas.write(0, (upper + lower) / 2 + 5, {plain("vibrator")}, "middle");
  if (problem->mount_mass &&
      !(problem->mass && problem->mass->symbol == problem->mount_mass->symbol))
    canvas.write(
        -half_width - 12, top + (problem->mass ? 20 : 6),  // beside the body or its plate
        joined({label(as_called(problem, problem->mount_mass->symbol)),
                {plain(value_words(problem, *problem->mount_mass, "kg") + " along the normal")}}),
        "end");
  words += ", mount, vibrator";
  return upper;
}

}  // namespace

Picture draw_system(const Problem& problem) {
  Canvas canvas;
  const Drawing normal =
      DrawnNetwork(problem, problem->normal, true, problem->indenter.has_value()).drawing();
  std::string words = "Substrate, contact, its network along the normal";
  Contact contact;
  if (problem->indenter)
    contact = {draw_half_space(canvas, problem, normal), 60};
  else
    contact = draw_contact(canvas, problem, normal);
  const double left = problem->indenter ? -60 : -body_reach,
               right = std::max(contact.right, body_reach), bottom = problem->indenter ? -16 : 0,
               top = bottom - (problem->mass ? body_height : plate_height);
  canvas.put(
      {path(fmt::format("M{:.1f} {:.1f}H{:.1f}V{:.1f}H{:.1f}z", left, top, right, bottom, left),
            problem->indenter ? "" : "solid")});
  canvas.reach(left, right, top, bottom);
  if (problem->mass) {
    canvas.write((left + right) / 2, (top + bottom) / 2 + 5,
                 joined({label(as_called(problem, problem->mass->symbol)),
                         {plain(value_words(problem, *problem->mass, "kg"))}}),
                 "middle");
    words += ", body";
  }
  draw_drive(canvas, problem, right, (top + bottom) / 2, words);
  const double moving = problem->mount ? draw_mount(canvas, problem, top, words) : top;
  canvas.put(arrow_to_both_sides(moving - 34, 26));
  canvas.reach(-5, 5, moving - 36, moving);
  canvas.write(0, moving - 44, oscillation_words(problem), "middle");
  const auto* isotropic = std::get_if<Isotropic>(&problem->tangential);
  if (isotropic != nullptr && tangential_ratio(*isotropic) != 1)
    canvas.write(canvas.left(), contact.bottom + 28,
                 {plain(fmt::format("along the surface {:.4g} × the same network",
                                    tangential_ratio(*isotropic)))});
  return canvas.picture(words + ", moved at constant velocity");
}

}  // namespace vcrit::validation::report
