#include "critical/batch.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <optional>
#include <utility>

#include "base/interruption.hpp"
#include "critical/columns.hpp"
#include "critical/decimals.hpp"
#include "critical/kernels.hpp"
#include "critical/operations.hpp"
#include "problem/variation.hpp"

namespace vcrit {

namespace {

using kernels::lanes;
using Given = std::span<const std::span<const double>>;

constexpr double no_velocity = std::numeric_limits<double>::quiet_NaN();

double at(std::span<const double> column, std::size_t lane) {
  return column[column.size() == 1 ? 0 : lane];
}

}  // namespace

class CriticalVelocities::Formula {
 public:
  Formula(const Problem& problem, std::vector<std::string> names, Grade grade);
  void evaluate(Given given, std::span<double> out) const;

 private:
  /// A parameter that varies, and the unit in which it is given.
  struct Varying {
    Symbol symbol;
    double factor = 1;
  };
  class Columns;
  class Certified;
  class Call;

  Problem problem_;
  std::vector<std::string> names_;
  std::vector<Varying> varying_;
  Values values_;  // of all symbols; of those that vary any
  std::optional<Operations> operations_;
};

CriticalVelocities::Formula::Formula(const Problem& problem, std::vector<std::string> names,
                                     Grade grade)
    : problem_(problem), names_(std::move(names)) {
  const Variation changing(problem_, names_);
  bool all_there = true;
  for (const Variation::Target& target : changing.targets()) {
    varying_.push_back({target.symbol, target.factor});
    all_there = all_there && !target.is_left_out;
  }
  if (all_there && grade == Grade::doubles) operations_ = operations_of(problem_);
  // A number that every quantity may have, Poisson's ratio as well; no omega of a table.
  if (operations_ || problem_->measured.empty())
    values_ = changing.at(std::vector<double>(names_.size(), 0.25)).values();
}

/// Columns of `lanes` doubles that begin at lines of the cache.
class CriticalVelocities::Formula::Columns {
 public:
  explicit Columns(std::size_t count)
      : numbers_(static_cast<double*>(
            ::operator new[](count* lanes * sizeof(double), std::align_val_t{64}))) {}
  double* operator[](Column column) const { return numbers_.get() + column * lanes; }

 private:
  struct Free {
    void operator()(double* numbers) const { ::operator delete[](numbers, std::align_val_t{64}); }
  };
  std::unique_ptr<double, Free> numbers_;
};

/// Lanes of which the correctly rounded value is wanted, one after the other. Neighbours may be one
/// scene, as all rows of a sweep over speeds are: it takes memory and microseconds once.
class CriticalVelocities::Formula::Certified {
 public:
  Certified(const Problem& problem, const std::vector<std::string>& names)
      : changing_(problem, names) {}

  double operator()(Given given, std::size_t lane) {
    if (velocity_ && is_last(given, lane)) return *velocity_;
    hear_interruption();
    values_.clear();
    for (const auto& column : given) values_.push_back(at(column, lane));
    const bool unknown =
        std::any_of(values_.begin(), values_.end(), [](double value) { return std::isnan(value); });
    velocity_ = unknown ? no_velocity : velocity_of(changing_.at(values_));
    return *velocity_;
  }

 private:
  bool is_last(Given given, std::size_t lane) const {
    return std::equal(
        given.begin(), given.end(), values_.begin(),
        [lane](const auto& column, double value) { return at(column, lane) == value; });
  }

  double velocity_of(const Problem& problem) try {
    return certified_critical_velocity(problem, decimals_).value;
  } catch (const ModelError&) {
    return no_velocity;
  }

  Variation changing_;
  ReadDecimals decimals_;
  std::vector<double> values_;      // of the last lane
  std::optional<double> velocity_;  // its v*
};

/// One call of the batch: its columns, and which operations must run for each block.
class CriticalVelocities::Formula::Call {
 public:
  Call(const Formula& formula, Given given);
  void run(std::span<double> out);

 private:
  /// A parameter with a value for each lane.
  struct Moving {
    std::span<const double> values;
    double factor;
    Column column;
  };

  void place(const Varying& varying, std::span<const double> values);
  void run_constant_operations();
  void apply(const BatchOperation& operation);
  void load(std::size_t first, std::size_t count);
  void require_usual(Column column);
  double certified(std::size_t lane);

  const Formula& formula_;
  const Operations& operations_;
  Given given_;
  Columns columns_;
  double* lost_;                   // 1 in lanes that need the certified value
  std::vector<const double*> at_;  // where each column lies now
  std::vector<bool> varies_;       // which columns change from block to block
  std::vector<Moving> moving_;
  std::vector<std::span<const double>> unknown_;  // without effect on v*, but for NaN
  std::vector<const BatchOperation*> each_block_;
  bool always_lost_ = false;
  std::optional<Certified> certified_;
};

CriticalVelocities::Formula::Call::Call(const Formula& formula, Given given)
    : formula_(formula),
      operations_(*formula.operations_),
      given_(given),
      columns_(operations_.columns + 1),
      lost_(columns_[operations_.columns]),
      varies_(operations_.columns, false) {
  std::fill_n(lost_, lanes, 0.0);
  std::fill_n(columns_[zero_column], lanes, 0.0);
  for (Column column = 0; column < operations_.columns; ++column) at_.push_back(columns_[column]);
  for (const auto& [symbol, column] : operations_.parameters)
    std::fill_n(columns_[column], lanes, formula_.values_.at(symbol));
  for (std::size_t i = 0; i < given_.size(); ++i) place(formula_.varying_[i], given_[i]);
  for (const auto& [symbol, column] : operations_.parameters)
    if (!varies_[column]) require_usual(column);
  run_constant_operations();
}

void CriticalVelocities::Formula::Call::place(const Varying& varying,
                                              std::span<const double> values) {
  const auto parameter = operations_.parameters.find(varying.symbol);
  if (parameter == operations_.parameters.end()) {
    // v* does not depend on it, but the scene may not have every value of it.
    bool unknown = false;
    for (std::size_t lane = 0; lane < values.size(); ++lane) {
      unknown = unknown || std::isnan(values[lane]);
      if (!(values[lane] >= 0 && std::isfinite(values[lane]))) certified(lane);
    }
    if (unknown) unknown_.push_back(values);
    return;
  }
  const Column column = parameter->second;
  if (values.size() == 1) {
    std::fill_n(columns_[column], lanes, varying.factor * values[0]);
    return;
  }
  moving_.push_back({values, varying.factor, column});
  varies_[column] = true;
}

void CriticalVelocities::Formula::Call::run_constant_operations() {
  for (const BatchOperation& operation : operations_.list) {
    const bool varies = std::any_of(operation.in.begin(), operation.in.end(),
                                    [this](Column column) { return varies_[column]; });
    if (varies)
      each_block_.push_back(&operation);
    else
      apply(operation);
    for (const Column column : operation.out) varies_[column] = varies;
  }
  always_lost_ = lost_[0] != 0;
}

// Poisson's ratio may be negative: its kernel knows its range.
void CriticalVelocities::Formula::Call::require_usual(Column column) {
  if (column != operations_.poisson) kernels::kernels().outside_range(lost_, at_[column]);
}

void CriticalVelocities::Formula::Call::apply(const BatchOperation& operation) {
  using Kind = BatchOperation::Kind;
  const kernels::Kernels& run = kernels::kernels();
  const auto in = [&](std::size_t i) { return at_[operation.in[i]]; };
  const auto pair = [&](std::size_t i) { return kernels::StiffnessLanes{in(i), in(i + 1)}; };
  double* const out = columns_[operation.out[0]];
  const kernels::LanesResult both{out, columns_[operation.out[1]]};
  switch (operation.kind) {
    case Kind::multiply:
      return run.multiply(out, in(0), in(1));
    case Kind::divide:
      return run.divide(out, in(0), in(1));
    case Kind::add:
      return run.add(out, in(0), in(1));
    case Kind::maxwell:
      return run.maxwell(both, in(0), in(1), in(2));
    case Kind::series:
      return run.series(both, pair(0), pair(2));
    case Kind::mesh:
      return run.mesh(both, pair(0), pair(2), pair(4));
    case Kind::isotropic:
      return run.isotropic(out, lost_, in(0));
    case Kind::modulus_ratio:
      return run.modulus_ratio(out, pair(0), pair(2));
    case Kind::drive_factor:
      return run.drive_factor(out, lost_, pair(0),
                              {pair(2), operation.in[4] == zero_column ? nullptr : in(4), in(5),
                               operations_.exact_contact, operations_.exact_drive});
  }
}

// Whole blocks in SI are read where they lie; behind the last lane its value is repeated.
void CriticalVelocities::Formula::Call::load(std::size_t first, std::size_t count) {
  std::fill_n(lost_, lanes, always_lost_ ? 1.0 : 0.0);
  for (const Moving& moving : moving_) {
    const double* values = moving.values.data() + first;
    at_[moving.column] = values;
    if (count < lanes || moving.factor != 1) {
      double* const column = columns_[moving.column];
      for (std::size_t i = 0; i < count; ++i) column[i] = moving.factor * values[i];
      std::fill(column + count, column + lanes, column[count - 1]);
      at_[moving.column] = column;
    }
    require_usual(moving.column);
  }
  for (const auto& values : unknown_)
    for (std::size_t i = 0; i < count; ++i)
      if (std::isnan(at(values, first + i))) lost_[i] = 1;
}

double CriticalVelocities::Formula::Call::certified(std::size_t lane) {
  if (!certified_) certified_.emplace(formula_.problem_, formula_.names_);
  return (*certified_)(given_, lane);
}

void CriticalVelocities::Formula::Call::run(std::span<double> out) {
  double* const result = columns_[operations_.result];
  for (std::size_t first = 0; first < out.size(); first += lanes) {
    const std::size_t count = std::min(lanes, out.size() - first);
    load(first, count);
    for (const BatchOperation* operation : each_block_) apply(*operation);
    for (std::size_t i = 0; i < count; ++i)
      if (lost_[i] != 0) result[i] = certified(first + i);
    std::copy_n(result, count, out.data() + first);
  }
}

void CriticalVelocities::Formula::evaluate(Given given, std::span<double> out) const {
  check_columns(names_, given, out.size());
  if (out.empty()) return;
  if (operations_) return Call(*this, given).run(out);
  Certified certified(problem_, names_);
  for (std::size_t lane = 0; lane < out.size(); ++lane) out[lane] = certified(given, lane);
}

CriticalVelocities::CriticalVelocities(const Problem& problem, std::vector<std::string> varying,
                                       Grade grade)
    : formula_(std::make_unique<const Formula>(problem, std::move(varying), grade)) {}
CriticalVelocities::~CriticalVelocities() = default;
CriticalVelocities::CriticalVelocities(CriticalVelocities&&) noexcept = default;
CriticalVelocities& CriticalVelocities::operator=(CriticalVelocities&&) noexcept = default;

void CriticalVelocities::operator()(std::span<const std::span<const double>> columns,
                                    std::span<double> out) const {
  formula_->evaluate(columns, out);
}

}  // namespace vcrit
