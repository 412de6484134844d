#include "sweep/sweep.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "answers/critical_onset.hpp"
#include "answers/friction.hpp"
#include "answers/under_load.hpp"
#include "base/rounded.hpp"
#include "critical/admissibility.hpp"
#include "modes/general_modes.hpp"
#include "normal/mean_indentation.hpp"
#include "problem/variation.hpp"
#include "rules/kinds.hpp"
#include "rules/rulebook.hpp"
#include "sweep/refusals.hpp"

namespace vcrit {

namespace {

// Speeds that are found one from another. Fixed, so that the answers depend on the sweep alone.
constexpr std::size_t speeds_at_once = 32;

// So that a block takes about a millisecond with the formula alone, and tens of them else.
constexpr std::size_t rows_of_formula = 131072, rows_of_scenes = 4096, rows_of_motion = 1024;
// Rows whose columns stay in the cache while the formula runs over them.
constexpr std::size_t rows_of_columns = 4096;

// Up to so many v* are correctly rounded, as that of a single scene; it takes part of a second.
constexpr std::size_t certified_scenes = 10'000;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

bool any_of(const Sweep& sweep, bool (*holds)(const SweptQuantity&)) {
  return std::any_of(sweep.quantities.begin(), sweep.quantities.end(), holds);
}

bool needs_scene(const SweptQuantity& quantity) {
  return quantity.kind != SweptQuantity::Kind::critical_velocity;
}

std::size_t rows_at_once(const Sweep& sweep) {
  if (any_of(sweep, needs_motion) ||
      !rules::answer(rules::Question::formula_of_all_values, sweep.problem))
    return rows_of_motion;
  return any_of(sweep, needs_scene) ? rows_of_scenes : rows_of_formula;
}

std::vector<std::size_t> parameters_of(const Grid& grid) {
  std::vector<std::size_t> axes;
  for (std::size_t a = 0; a < grid.axes().size(); ++a)
    if (grid.speed() != a) axes.push_back(a);
  return axes;
}

Grade grade_of(const Grid& grid) {
  const std::size_t speeds = grid.speed() ? grid.axes()[*grid.speed()].values.size() : 1;
  return grid.rows() / speeds <= certified_scenes ? Grade::certified : Grade::doubles;
}

// Whether an axis lets an element of the normal network vanish, which makes it another network.
bool leaves_out(const Sweep& sweep) {
  const std::vector<Symbol> normal = symbols_of(sweep.problem->normal.network());
  return std::any_of(sweep.axes.begin(), sweep.axes.end(), [&](const Axis& axis) {
    const auto named = sweep.problem->source->named.find(axis.name);
    return named != sweep.problem->source->named.end() &&
           std::ranges::count(normal, named->second) > 0 &&
           std::ranges::count(axis.values, 0.0) > 0;
  });
}

// Whether closed contacts are not known by the amplitude over the indentation or the load: below an
// indenter, of a contact that may sink as it opens, and below a mount.
bool asked_one_by_one(const Problem& problem) {
  return problem->mount || (problem->load && rules::may_open(problem));
}

std::vector<std::string> names_of(const Grid& grid, const std::vector<std::size_t>& axes) {
  std::vector<std::string> names;
  for (const std::size_t a : axes) names.push_back(grid.axes()[a].name);
  return names;
}

double found_indentation(const Problem& problem) {
  const double indentation = simulation::mean_indentation(problem);
  if (std::isfinite(indentation)) return indentation;
  throw ModelError("under its load the contact sinks for ever: it has no mean indentation");
}

void refuse_value(const Variation& varied, const Axis& axis, double value) {
  try {
    varied.refuse({&value, 1});
  } catch (const InputError& error) {
    if (!is_of(error, axis)) throw;
    const std::string number = rounded(value, axis.dimension, all_digits);
    throw InputError(error.place(), fmt::format("{} = {}", axis.name, number), error.expected(),
                     error.advice());
  }
}

// Wrong values are found before the first block, however late their rows come.
void refuse_axis_values(const Sweep& sweep, const Grid& grid) {
  for (const std::size_t a : parameters_of(grid)) {
    const Axis& axis = grid.axes()[a];
    const Variation varied(sweep.problem, {axis.name});
    for (const double value : axis.values) refuse_value(varied, axis, value);
  }
}

}  // namespace

/// The rows of one block while they are being answered.
class Sweeping::Rows {
  using Kind = SweptQuantity::Kind;

 public:
  Rows(const Sweeping& sweeping, std::size_t index)
      : sweeping_(sweeping),
        grid_(sweeping.grid_),
        block_(grid_.block(index)),
        changing_(sweeping.sweep_.problem, names_of(grid_, sweeping.parameters_)),
        separating_(rules::Facts(sweeping.sweep_.problem).is(rules::SceneKind::separating)),
        critical_(block_.rows) {
    velocities_.reserve(speeds_at_once);
    answer_.block = index;
    for (const SweptQuantity& quantity : sweeping.sweep_.quantities)
      answer_.values.emplace_back(quantity.kind == Kind::critical_velocity ? 0 : block_.rows,
                                  words(quantity).empty() ? nothing : 0);
    outside_.resize(block_.rows);
    admissible_.resize(block_.rows);
  }

  BlockAnswer run() {
    find_critical();
    if (any_of(sweeping_.sweep_, needs_scene)) find_others();
    for (std::size_t q = 0; q < answer_.values.size(); ++q)
      if (sweeping_.sweep_.quantities[q].kind == Kind::critical_velocity)
        answer_.values[q].swap(critical_);
    answer_.outside = static_cast<std::size_t>(std::count(outside_.begin(), outside_.end(), true));
    return std::move(answer_);
  }

 private:
  void find_critical() {
    std::vector<std::vector<double>> columns(sweeping_.parameters_.size());
    for (std::size_t begin = 0; begin < block_.rows;) {
      const std::size_t rows = rows_from(begin);
      for (std::size_t i = 0; i < columns.size(); ++i)
        fill(columns[i], sweeping_.parameters_[i], begin, rows);
      const std::vector<std::span<const double>> views(columns.begin(), columns.end());
      sweeping_.critical_(views, std::span(critical_).subspan(begin, rows));
      for (std::size_t row = begin; row < begin + rows; ++row)
        if (std::isnan(critical_[row])) note(row, why_no_velocity(row));
      find_admissible(views, begin, rows);
      begin += rows;
    }
  }

  void find_admissible(const std::vector<std::span<const double>>& columns, std::size_t begin,
                       std::size_t rows) {
    shares_.resize(rows);
    if (sweeping_.closed_) (*sweeping_.closed_)(columns, shares_);
    for (std::size_t i = 0; i < rows; ++i) {
      const std::size_t row = begin + i;
      const std::string reason = why_inadmissible(row, shares_[i]);
      if (admissible_[row]) continue;
      critical_[row] = nothing;
      note(row, reason);
    }
  }

  // Nothing where the row is, or where another one's reason is known.
  std::string why_inadmissible(std::size_t row, double share) {
    try {
      admissible_[row] = sweeping_.closed_ ? is_admissible(row, share)
                                           : inadmissible_reasons(problem_at(row)).empty();
      if (admissible_[row] || !answer_.reason.empty()) return {};
      return inadmissible_reasons(problem_at(row)).front();
    } catch (const ModelError& error) {  // outside the table of a measured contact
      admissible_[row] = false;
      return error.what();
    }
  }

  // The border itself is a question of more digits, as are shares beyond the range of doubles.
  bool is_admissible(std::size_t row, double share) {
    // Far above the rounding errors of the share.
    constexpr double close = 1e-9;
    const double amplitude = sweeping_.amplitude_.of(grid_, block_.first + row);
    const double part = amplitude / sweeping_.pressing_.of(grid_, block_.first + row);
    const bool usual = std::isfinite(share) && share > 0 && amplitude > 0;
    if (usual && separating_) return true;
    if (usual && std::abs(part - share) > close * share) return part < share;
    return inadmissible_reasons(problem_at(row)).empty();
  }

  // Where the last axis is long, no more than its rows: all that the other axes decide is the same.
  std::size_t rows_from(std::size_t begin) const {
    std::size_t rows = std::min(rows_of_columns, block_.rows - begin);
    if (grid_.axes().empty()) return rows;
    const std::size_t last = grid_.axes().size() - 1;
    if (block_.count[last] >= rows_of_columns / 4)
      rows = std::min(rows, block_.count[last] - begin % block_.count[last]);
    return rows;
  }

  // The values along an axis; one value where it does not change within these rows.
  void fill(std::vector<double>& column, std::size_t axis, std::size_t begin,
            std::size_t rows) const {
    const double* const values = grid_.axes()[axis].values.data() + block_.start[axis];
    const std::size_t stride = grid_.stride(axis), count = block_.count[axis];
    const bool constant = begin / stride == (begin + rows - 1) / stride;
    column.resize(constant ? 1 : rows);
    std::size_t index = begin / stride % count;
    for (std::size_t row = 0; row < column.size();) {
      const std::size_t left = stride - (begin + row) % stride;
      // Neighbours in the file are neighbours along the last axis.
      const std::size_t run = std::min(column.size() - row, stride == 1 ? count - index : left);
      if (stride == 1)
        std::copy_n(values + index, run, column.data() + row);
      else
        std::fill_n(column.data() + row, run, values[index]);
      row += run;
      index = stride == 1 ? 0 : (index + 1) % count;
    }
  }

  std::string why_no_velocity(std::size_t row) {
    if (!answer_.reason.empty()) return {};
    try {
      certified_onset(problem_at(row));
    } catch (const ModelError& error) {
      return error.what();
    }
    throw Bug("v* without a number and without a reason");
  }

  Problem problem_at(std::size_t row) {
    point_.clear();
    for (const std::size_t a : sweeping_.parameters_)
      point_.push_back(grid_.value(a, block_.first + row));
    return changing_.at(point_);
  }

  void note(std::size_t row, const std::string& reason) {
    outside_[row] = true;
    if (answer_.reason.empty()) answer_.reason = reason;
  }

  // Rows that differ in the speed alone share a scene.
  void find_others() {
    const std::optional<std::size_t> axis = grid_.speed();
    const std::size_t between = axis ? grid_.stride(*axis) : 1;
    const std::size_t speeds = axis ? block_.count[*axis] : 1;
    // Before the block's own axes, the speed is one and the same for all of its rows.
    const std::size_t stride = between <= block_.rows ? between : 1;
    for (std::size_t row = 0; row < block_.rows; row += speeds * stride)
      for (std::size_t i = 0; i < stride; ++i) find_scene(row + i, speeds, stride);
  }

  void find_scene(std::size_t row, std::size_t speeds, std::size_t stride) {
    const Problem problem = problem_at(row);
    for (std::size_t q = 0; q < answer_.values.size(); ++q) {
      const SweptQuantity& quantity = sweeping_.sweep_.quantities[q];
      if (quantity.kind == Kind::critical_velocity || needs_motion(quantity)) continue;
      const double value = of_scene(quantity, problem, row);
      for (std::size_t i = 0; i < speeds; ++i) {
        answer_.values[q][row + i * stride] = value;
        if (outside_[row]) note(row + i * stride, answer_.reason);
      }
    }
    if (!any_of(sweeping_.sweep_, needs_motion)) return;
    try {
      const SteadyFriction friction(problem, nullptr, &known_modes_);
      for (std::size_t i = 0; i < speeds; i += speeds_at_once)
        find_motion(friction, row + i * stride, std::min(speeds_at_once, speeds - i), stride);
    } catch (const ModelError& error) {
      for (std::size_t i = 0; i < speeds; ++i) note(row + i * stride, error.what());
    }
  }

  double of_scene(const SweptQuantity& quantity, const Problem& problem, std::size_t row) {
    if (quantity.kind == Kind::admissible) return admissible_[row] ? 1 : 0;
    if (!admissible_[row]) return nothing;
    try {
      if (quantity.kind == Kind::indentation) return found_indentation(problem);
      if (quantity.kind == Kind::contact_amplitude) return amplitude_at_contact(problem);
      if (quantity.kind == Kind::mean_normal_force) return mean_normal_force_of(problem);
      return onset_log_derivative(problem, quantity.parameter);
    } catch (const ModelError& error) {
      note(row, error.what());
      return nothing;
    }
  }

  double velocity(std::size_t row) const {
    const Sweep& sweep = sweeping_.sweep_;
    if (sweep.velocity) return *sweep.velocity;
    if (sweep.velocity_ratio) return *sweep.velocity_ratio * critical_[row];
    const double speed = grid_.value(*grid_.speed(), block_.first + row);
    return speed * (grid_.axes()[*grid_.speed()].name == "velocity" ? 1 : critical_[row]);
  }

  void find_motion(const SteadyFriction& friction, std::size_t row, std::size_t speeds,
                   std::size_t stride) {
    velocities_.clear();
    for (std::size_t i = 0; i < speeds; ++i) velocities_.push_back(velocity(row + i * stride));
    if (!std::all_of(velocities_.begin(), velocities_.end(),
                     [](double v) { return v > 0 && std::isfinite(v); }))
      throw ModelError("v* is 0 or infinite, so that velocity_ratio has no meaning");
    friction.curve(velocities_, [&](std::size_t i, const simulation::PassingPoint& point) {
      put_motion(row + i * stride, point);
    });
  }

  void put_motion(std::size_t row, const simulation::PassingPoint& point) {
    if (point.state == nullptr) return note(row, point.reason);
    put(Kind::friction_ratio, row, point.state->friction_ratio);
    put(Kind::friction_ratio_error, row, point.state->friction_ratio_error);
    put(Kind::regime, row, static_cast<double>(point.state->regime) + 1);
  }

  void put(Kind kind, std::size_t row, double value) {
    for (std::size_t q = 0; q < answer_.values.size(); ++q)
      if (sweeping_.sweep_.quantities[q].kind == kind) answer_.values[q][row] = value;
  }

  const Sweeping& sweeping_;
  const Grid& grid_;
  Block block_;
  Variation changing_;
  bool separating_;
  simulation::KnownModes known_modes_;
  std::vector<double> point_, velocities_, critical_, shares_;
  std::vector<bool> outside_, admissible_;
  BlockAnswer answer_;
};

Sweeping::Sweeping(const Sweep& sweep) try
    : sweep_({completed(sweep.problem, sweep.axes), sweep.axes, sweep.quantities, sweep.velocity,
              sweep.velocity_ratio, sweep.units_in_header}),
      grid_(sweep_.axes, rows_at_once(sweep_), any_of(sweep_, needs_motion) ? speeds_at_once : 1),
      parameters_(parameters_of(grid_)),
      critical_(sweep_.problem, names_of(grid_, parameters_), grade_of(grid_)),
      amplitude_(sweep_.problem, grid_, parameters_, sweep_.problem->amplitude),
      pressing_(sweep_.problem, grid_, parameters_, pressing(sweep_.problem)) {
  refuse_settings(sweep_);
  refuse_repetition(sweep_);
  refuse_speeds(sweep_, grid_);
  refuse_axis_values(sweep_, grid_);
  if (!leaves_out(sweep_) && !asked_one_by_one(sweep_.problem))
    closed_.emplace(sweep_.problem, names_of(grid_, parameters_));
} catch (const InputError& error) {
  refuse_as_of_axis(sweep, error);
}

Sweeping::Varying::Varying(const Problem& problem, const Grid& grid,
                           const std::vector<std::size_t>& parameters, const Quantity& quantity)
    : value_(quantity.value.value_or(0)) {
  for (const std::size_t a : parameters)
    if (target_of(problem, grid.axes()[a].name).symbol == quantity.symbol) axis_ = a;
}

double Sweeping::Varying::of(const Grid& grid, std::size_t row) const {
  return axis_ ? grid.value(*axis_, row) : value_;
}

BlockAnswer Sweeping::answer(std::size_t block) const {
  if (block >= grid_.blocks())
    throw InputError(argument("block"), fmt::format("{}", block),
                     fmt::format("one of {}, counted from 0", grid_.blocks()));
  return Rows(*this, block).run();
}

}  // namespace vcrit
