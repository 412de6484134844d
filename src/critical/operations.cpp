#include "critical/operations.hpp"

#include "critical/eq24.hpp"
#include "network/law.hpp"
#include "network/reduction.hpp"
#include "rules/kinds.hpp"

namespace vcrit {

namespace {

/// Columns of storage and loss stiffness.
struct Pair {
  Column storage = zero_column, loss = zero_column;
};

/// Writes the operations down; as an algebra, it does so while the reductions run.
class Recorder {
 public:
  using Value = Pair;
  using Kind = BatchOperation::Kind;

  explicit Recorder(Symbol omega) : omega_(std::move(omega)) {}

  Pair of(const Symbol& symbol) { return {parameter(symbol), zero_column}; }
  static Pair constant(const TypedNumber&) { throw Bug("columns know no expressions"); }
  static Pair plus(Pair, Pair) { throw Bug("columns know no expressions"); }
  static Pair times(Pair, Pair) { throw Bug("columns know no expressions"); }
  static Pair over(Pair, Pair) { throw Bug("columns know no expressions"); }
  Pair times_s(Pair k) {
    ensure(k.loss == zero_column, "columns are of springs and dampers only");
    return {zero_column, multiply(k.storage, omega())};
  }
  Pair relaxing(Pair k, Pair tau) { return pair(Kind::maxwell, {k.storage, tau.storage, omega()}); }
  Pair lossy(Pair k, Pair eta) { return {k.storage, multiply(k.storage, eta.storage)}; }
  Pair parallel(Pair a, Pair b) { return {add(a.storage, b.storage), add(a.loss, b.loss)}; }
  Pair series(Pair a, Pair b) { return pair(Kind::series, {a.storage, a.loss, b.storage, b.loss}); }
  Pair mesh(Pair a, Pair b, Pair total) {
    return pair(Kind::mesh, {a.storage, a.loss, b.storage, b.loss, total.storage, total.loss});
  }

  Column parameter(const Symbol& symbol) {
    const auto [place, is_new] = written_.parameters.emplace(symbol, written_.columns);
    if (is_new) ++written_.columns;
    return place->second;
  }
  Column omega() { return parameter(omega_); }

  Column single(Kind kind, std::array<Column, 6> in) {
    written_.list.push_back({kind, {written_.columns, written_.columns}, in});
    return written_.columns++;
  }
  Column multiply(Column a, Column b) {
    return a == zero_column || b == zero_column ? zero_column : single(Kind::multiply, {a, b});
  }

  Operations& written() { return written_; }

 private:
  Column add(Column a, Column b) {
    if (a == zero_column || b == zero_column) return a == zero_column ? b : a;
    return single(Kind::add, {a, b});
  }
  Pair pair(Kind kind, std::array<Column, 6> in) {
    const Column storage = written_.columns++, loss = written_.columns++;
    written_.list.push_back({kind, {storage, loss}, in});
    return {storage, loss};
  }

  Symbol omega_;
  Operations written_;
};

bool is_spring(const Network& network) {
  const auto* element = std::get_if<Element>(&network.form);
  return element != nullptr && is_elastic(*element);
}

/// Eq. (24) in columns.
struct InColumns {
  Problem problem;
  Recorder& recorder;

  Column outer() const {
    const Column friction = recorder.parameter(problem->coefficient.symbol);
    const Column product =
        recorder.multiply(friction, recorder.parameter(problem->amplitude.symbol));
    return recorder.multiply(product, recorder.omega());
  }
  Column ratio(const Isotropic& isotropic) const {
    const Column given = recorder.parameter(isotropic.quantity.symbol);
    if (isotropic.by == Isotropic::By::ratio) return given;
    recorder.written().poisson = given;
    return recorder.single(BatchOperation::Kind::isotropic, {given});
  }
  Pair normal() const { return evaluate(problem->normal.reduction(), recorder); }
  Pair tangential(const ReducedNetwork& own) const { return evaluate(own.reduction(), recorder); }
  Pair scaled(Column ratio, Pair normal) const {
    return {recorder.multiply(normal.storage, ratio), recorder.multiply(normal.loss, ratio)};
  }
  static void times_mount(Column&, const Pair&, const ReducedNetwork&) {
    throw Bug("a mount has no columns");
  }
  void divide(Column& v, Column ratio) const {
    v = recorder.single(BatchOperation::Kind::divide, {v, ratio});
  }
  void times_quotient(Column& v, Pair n, Pair t) const {
    v = recorder.multiply(v, recorder.single(BatchOperation::Kind::modulus_ratio,
                                             {n.storage, n.loss, t.storage, t.loss}));
  }
  void times_drive(Column& v, Pair t, const ReducedNetwork& network) const {
    const Pair drive = evaluate(network.reduction(), recorder);
    const Column mass = problem->mass ? recorder.parameter(problem->mass->symbol) : zero_column;
    v = recorder.multiply(
        v, recorder.single(BatchOperation::Kind::drive_factor,
                           {t.storage, t.loss, drive.storage, drive.loss, mass, recorder.omega()}));
  }
  static void times_drive(Column&, Pair, const Receptance&) {
    throw Bug("a measured drive has no columns");
  }
};

}  // namespace

std::optional<Operations> operations_of(const Problem& problem) {
  if (problem->receptance() != nullptr || rules::drive_resonates(problem) || problem->mount ||
      !problem->expressions.empty() || !problem->measured.empty())
    return std::nullopt;
  Recorder recorder(problem->angular_frequency.symbol);
  recorder.written().result = eq24(problem, InColumns{problem, recorder});
  const auto* tangential = std::get_if<ReducedNetwork>(&problem->tangential);
  recorder.written().exact_contact = tangential != nullptr && is_spring(tangential->network());
  recorder.written().exact_drive =
      problem->drive_network() != nullptr && is_spring(problem->drive_network()->network());
  return std::move(recorder.written());
}

}  // namespace vcrit
