#include "report/system_drawing.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "network/law.hpp"
#include "report/canvas.hpp"
#include "report/units.hpp"

namespace vcrit::validation::report {

namespace {

constexpr double body_height = 44, plate_height = 20, foot_height = 16, foot_width = 44;  // px
constexpr double body_reach = 48;            // to the left of the middle, at least
constexpr std::size_t most_with_values = 4;  // names and values of more would need too much room
constexpr std::size_t most_listed = 8;       // and these below the drawing
// On a phone of 390 pixels, 374 beside its margins, 14 units are 11 pixels: 476 units, 16 of them
// the margins of an image.
constexpr double phone_width = 460;
constexpr std::size_t narrow_branches = 4;

Word italic(const char* letter) { return {"letter", letter, ""}; }
Word lowered(const char* index) { return {"index", index, "4"}; }
Word plain(const std::string& words) { return {"", words, ""}; }
/// After a letter with an index, back on the line.
Word raised(const std::string& words) { return {"", words, "-4"}; }

/// How a system is drawn, the widest first: with the drive beside the body or above it, with
/// numbers in the drawing or below it.
enum class Layout { drive_beside, drive_above, names_alone };

std::string value_words(const Problem& problem, const Quantity& quantity, const char* unit) {
  return " = " + vcrit::validation::report::quantity(problem.value(quantity), unit, 4);
}

/// Elements by the names that the scene gives them, with values unless they are many.
class DrawnNetwork {
 public:
  DrawnNetwork(const Problem& problem, const ReducedNetwork& given, bool standing, Layout layout,
               bool of_half_space = false)
      : look_{standing, {}} {
    Network network = given.network();
    std::map<Symbol, std::string> words;
    std::vector<Symbol> order;
    for_each_element(given.network(), [&](const Element& element) {
      for_each_number(element, [&](const Symbol& symbol, NumberRole role) {
        const NumberRow& row = number_row(role);
        const Dimension dimension = of_half_space ? row.in_half_space : row.dimension;
        const char* unit = dimension == Dimension::none ? "" : si_unit(dimension);
        const double* const known = problem.values().find(symbol);
        if (known == nullptr) return;
        const Symbol called = as_called(problem, symbol);
        if (words.emplace(called, " = " + quantity(*known, unit, 4)).second)
          order.push_back(called);
      });
    });
    rename(network, [&](const Symbol& symbol) { return as_called(problem, symbol); });
    const std::size_t numbers = numbers_in(network);
    if (layout == Layout::names_alone) look_.most_branches = narrow_branches;
    if (layout == Layout::names_alone || numbers > most_with_values) {
      if (numbers <= most_listed)
        for (const Symbol& symbol : order)
          values_.push_back(concatenated({label(symbol), {plain(words[symbol])}}));
    } else {
      look_.value = [words](const Symbol& symbol) {
        const auto found = words.find(symbol);
        return found == words.end() ? std::string() : found->second;
      };
    }
    drawing_ = draw(network, look_);
  }
  const Drawing& drawing() const { return drawing_; }
  /// "k_0 = 8 N/µm", where the drawing has names alone.
  const std::vector<Label>& values() const { return values_; }

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
  std::vector<Label> values_;
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
  return concatenated({label(symbol), {plain(value)}});
}

/// "u_z(t) = 0.5 + 0.1 cos ωt µm"; under a load "W = 20 N, Δu_z(t) = 0.1 cos ωt µm"
Label oscillation_words(const Problem& problem) {
  const double amplitude = problem.value(problem->amplitude);
  if (problem->load) {
    const Scale scale = scale_for(amplitude, "m");
    const Label load = concatenated({label(as_called(problem, problem->load->symbol)),
                                     {plain(value_words(problem, *problem->load, "N"))}});
    if (problem->mount)
      return concatenated(
          {load,
           {plain(", "), italic("U"),
            plain(fmt::format(" = {:.4g} {}", amplitude * scale.factor, scale.unit))}});
    return concatenated(
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

/// Draws one system in one layout.
class SystemDrawing {
 public:
  SystemDrawing(const Problem& problem, Layout layout) : problem_(problem), layout_(layout) {}
  double width() const { return canvas_.width(); }
  Picture drawn();

 private:
  struct Contact {
    double bottom = 0, right = 0;  ///< of what is below the body, and how far the body must reach
  };

  bool in_list() const { return layout_ == Layout::names_alone; }
  Drawing network(const ReducedNetwork& given, bool standing);
  double draw_half_space(const Drawing& network);
  double draw_tangential(const Drawing& network, double y, double from, double at);
  Contact draw_contact(const Drawing& normal);
  double draw_drive(double x, double y);
  double draw_drive_above(double x, double top);
  double draw_mount(double top, const Drawing& mount);
  void draw_motion(double moving, double drive_top);

  const Problem& problem_;
  Layout layout_;
  Canvas canvas_;
  std::string words_ = "Substrate, contact, its network along the normal";
  std::vector<Label> list_;  ///< of numbers, where they are below the drawing
};

Drawing SystemDrawing::network(const ReducedNetwork& given, bool standing) {
  const bool of_half_space = problem_->indenter && &given == &problem_->normal;
  const DrawnNetwork drawn(problem_, given, standing, layout_, of_half_space);
  for (const Label& value : drawn.values())  // a number of two networks once
    if (std::find(list_.begin(), list_.end(), value) == list_.end()) list_.push_back(value);
  return drawn.drawing();
}

/// The material of the half-space below the indenter, with its network within. Returns how far
/// down.
double SystemDrawing::draw_half_space(const Drawing& network) {
  constexpr double depth = 14;  // of the network's upper end
  const double bottom = depth + network.width;
  canvas_.put({path(profile(problem_->indenter->shape), "")});
  canvas_.put({path("M-92 0H-34M34 0H92", "heavy"), line(0, 6, 0, depth)});
  canvas_.put(moved(0, depth, standing(network)));
  canvas_.reach(-92, 92, 0, bottom);
  canvas_.write(-66, -6, coefficient_words(problem_), "end");
  return bottom;
}

/// The contact's own network along the surface, from the foot to an arm of the body at `at`.
double SystemDrawing::draw_tangential(const Drawing& network, double y, double from, double at) {
  const double start = at - network.width - 10;
  canvas_.put({line(from, y, start, y), line(at - 10, y, at, y),
               path(fmt::format("M{0:.1f} 0V{1:.1f}", at, y + 8), "heavy")});
  canvas_.put(moved(start, y, network.shapes));
  canvas_.reach(from, at, y - network.above, y + network.below);
  return at;
}

SystemDrawing::Contact SystemDrawing::draw_contact(const Drawing& normal) {
  const auto* own = std::get_if<ReducedNetwork>(&problem_->tangential);
  const Drawing tangential = own == nullptr ? Drawing() : network(*own, false);
  const double foot = own == nullptr ? foot_height : std::max(foot_height, tangential.below + 16);
  const double gap = problem_->separation ? 7 : 0;
  // So low that the network along the surface, on a line at `along`, stays below the body.
  constexpr double along = 8, clear = 6;
  const double ankle = std::max(normal.width, tangential.above + clear - along);
  const double sole = ankle + foot, surface = sole + gap;
  canvas_.put(standing(normal));
  if (ankle > normal.width) canvas_.put({line(0, normal.width, 0, ankle)});
  canvas_.reach(-normal.below, normal.above, 0, surface);
  canvas_.put({path(fmt::format("M{:.1f} {:.1f}h{:.1f}v{:.1f}h{:.1f}z", -foot_width / 2, ankle,
                                foot_width, foot, -foot_width),
                    "solid")});
  double right = std::max(normal.above, body_reach);
  if (own != nullptr)
    right =
        draw_tangential(tangential, ankle + along, foot_width / 2, right + tangential.width + 20) +
        8;
  const double left = std::min(-normal.below, -body_reach) - (in_list() ? 8 : 40);
  canvas_.put(ground(left, surface, std::max(right, body_reach) + (in_list() ? 0 : 12) - left));
  canvas_.reach(left, right, surface, surface + 8);
  if (in_list())
    list_.insert(list_.begin(), coefficient_words(problem_));
  else
    canvas_.write(-foot_width / 2 - 8, surface - 6, coefficient_words(problem_), "end");
  if (gap > 0) canvas_.write(foot_width / 2 + 8, surface - 3, {plain("may open")});
  return {surface, right};
}

/// From (x, y) to the right, with the arrow of its speed. Returns how far up.
double SystemDrawing::draw_drive(double x, double y) {
  double at = x, top = y;
  const auto add = [&](const Drawing& drawing) {
    canvas_.put(moved(at, y, drawing.shapes));
    canvas_.reach(at, at + drawing.width, y - drawing.above, y + drawing.below);
    at += drawing.width;
    top = std::min(top, y - drawing.above);
  };
  std::visit(Overloaded{[](const Rigid&) {},
                        [&](const ReducedNetwork& drive) {
                          add(network(drive, false));
                          words_ += ", drive network";
                        },
                        [&](const Receptance&) {
                          add({92,
                               26,
                               26,
                               {line(0, 0, 10, 0), path("M10 -22H82V22H10z", "solid"),
                                text(46, 5, label({"R_d"})), line(82, 0, 92, 0)}});
                          words_ += ", measured drive";
                        }},
             problem_->drive);
  add({58,
       26,
       8,
       {line(0, 0, 12, 0), path("M12 0H50M42 -5L51 0L42 5", "arrow"),
        text(32, -11, {italic("v"), lowered("0")})}});
  return top;
}

/// From a post on the body at (x, top), so high that the drive clears the body.
double SystemDrawing::draw_drive_above(double x, double top) {
  constexpr double clear = 8;
  const auto* drive = std::get_if<ReducedNetwork>(&problem_->drive);
  const double below =
      drive == nullptr ? 22 : DrawnNetwork(problem_, *drive, false, layout_).drawing().below;
  const double y = top - below - clear;
  canvas_.put({line(x, top, x, y)});
  return draw_drive(x, y);
}

/// Above the body: the mount and, at its upper end, the vibrator. Returns where that ends.
double SystemDrawing::draw_mount(double top, const Drawing& mount) {
  constexpr double half_width = 44, height = 22;
  const double lower = top - mount.width, upper = lower - height;
  canvas_.put(moved(0, lower, standing(mount)));
  canvas_.reach(-mount.below, mount.above, lower, top);
  canvas_.put({path(fmt::format("M{:.1f} {:.1f}H{:.1f}V{:.1f}H{:.1f}z", -half_width, upper,
                                half_width, lower, -half_width),
                    "solid")});
  canvas_.reach(-half_width, half_width, upper, lower);
  canvas_.write(0, (upper + lower) / 2 + 5, {plain("vibrator")}, "middle");
  if (problem_->mount_mass &&
      !(problem_->mass && problem_->mass->symbol == problem_->mount_mass->symbol)) {
    const Label mass = concatenated(
        {label(as_called(problem_, problem_->mount_mass->symbol)),
         {plain(value_words(problem_, *problem_->mount_mass, "kg") + " along the normal")}});
    if (in_list())
      list_.push_back(mass);
    else  // beside the body or its plate
      canvas_.write(-half_width - 12, top + (problem_->mass ? 20 : 6), mass, "end");
  }
  words_ += ", mount, vibrator";
  return upper;
}

/// The words stand above the arrow and above the drive.
void SystemDrawing::draw_motion(double moving, double drive_top) {
  constexpr double clear = 6;
  const double lift =
      layout_ == Layout::drive_beside ? 0 : std::max(0.0, moving - 38 - (drive_top - clear));
  canvas_.put(arrow_to_both_sides(moving - 34 - lift, 26 + lift));
  canvas_.reach(-5, 5, moving - 36 - lift, moving);
  // They may not reach further to the left than what is below them, where there is no room.
  if (in_list())
    canvas_.write(canvas_.left(), moving - 44 - lift, oscillation_words(problem_));
  else
    canvas_.write(0, moving - 44 - lift, oscillation_words(problem_), "middle");
}

Picture SystemDrawing::drawn() {
  const Drawing normal = network(problem_->normal, true);
  const Contact contact =
      problem_->indenter ? Contact{draw_half_space(normal), 60} : draw_contact(normal);
  const Drawing mount = problem_->mount ? network(*problem_->mount, true) : Drawing();
  const double post = std::max(14.0, mount.above) + 16;  // of a drive above the body
  const double left = problem_->indenter ? -60 : -body_reach,
               right = std::max(
                   {contact.right, body_reach, layout_ == Layout::drive_beside ? 0 : post + 8}),
               bottom = problem_->indenter ? -16 : 0,
               top = bottom - (problem_->mass ? body_height : plate_height);
  canvas_.put(
      {path(fmt::format("M{:.1f} {:.1f}H{:.1f}V{:.1f}H{:.1f}z", left, top, right, bottom, left),
            problem_->indenter ? "" : "solid")});
  canvas_.reach(left, right, top, bottom);
  if (problem_->mass) {
    canvas_.write((left + right) / 2, (top + bottom) / 2 + 5,
                  concatenated({label(as_called(problem_, problem_->mass->symbol)),
                                {plain(value_words(problem_, *problem_->mass, "kg"))}}),
                  "middle");
    words_ += ", body";
  }
  const double drive_top = layout_ == Layout::drive_beside ? draw_drive(right, (top + bottom) / 2)
                                                           : draw_drive_above(post, top);
  draw_motion(problem_->mount ? draw_mount(top, mount) : top, drive_top);
  double below = contact.bottom + 28;
  const auto* isotropic = std::get_if<Isotropic>(&problem_->tangential);
  if (isotropic != nullptr && tangential_ratio(*isotropic) != 1) {
    canvas_.write(canvas_.left(), below,
                  {plain(fmt::format("along the surface {:.4g} × the same network",
                                     tangential_ratio(*isotropic)))});
    below += 20;
  }
  canvas_.list(below, list_, phone_width);
  return canvas_.picture(words_ + ", moved at constant velocity");
}

}  // namespace

Picture draw_system(const Problem& problem) {
  for (const Layout layout : {Layout::drive_beside, Layout::drive_above}) {
    SystemDrawing drawer(problem, layout);
    Picture picture = drawer.drawn();
    if (drawer.width() <= phone_width) return picture;
  }
  return SystemDrawing(problem, Layout::names_alone).drawn();
}

}  // namespace vcrit::validation::report
