#include "critical/operations.hpp"

#include "network/masses.hpp"
#include "network/reduction.hpp"

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
  using Kind = Operation::Kind;

  explicit Recorder(Symbol omega) : omega_(std::move(omega)) {}

  Pair element(const Element& e) {
    const Column coefficient = parameter(e.coefficient);
    if (e.kind == ElementKind::spring) return {coefficient, zero_column};
    if (e.kind == ElementKind::damper) return {zero_column, multiply(coefficient, omega())};
    return pair(Kind::maxwell, {coefficient, parameter(e.time), omega()});
  }
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
  return element != nullptr && element->kind == ElementKind::spring;
}

/// The velocity of a rigidly driven contact, and K_t where the drive needs it.
struct Contact {
  Column velocity;
  Pair tangential;
};

Contact isotropic_contact(Recorder& recorder, const Scene& scene, const Isotropic& isotropic,
                          Column velocity) {
  Column ratio = recorder.parameter(isotropic.quantity.symbol);
  if (isotropic.by == Isotropic::By::poisson) {
    recorder.written().poisson = ratio;
    ratio = recorder.single(Operation::Kind::isotropic, {ratio});
  }
  velocity = recorder.single(Operation::Kind::divide, {velocity, ratio});
  // Under a rigid drive it needs no rheology at all.
  if (!scene.drive) return {velocity, {}};
  const Pair normal = evaluate(reduce(scene.normal), recorder);
  return {velocity,
          {recorder.multiply(normal.storage, ratio), recorder.multiply(normal.loss, ratio)}};
}

Contact anisotropic_contact(Recorder& recorder, const Scene& scene, const Network& network,
                            Column velocity) {
  const Pair n = evaluate(reduce(scene.normal), recorder);
  const Pair t = evaluate(reduce(network), recorder);
  const Column factor =
      recorder.single(Operation::Kind::modulus_ratio, {n.storage, n.loss, t.storage, t.loss});
  return {recorder.multiply(velocity, factor), t};
}

Column driven(Recorder& recorder, const Scene& scene, const Contact& contact) {
  const Pair drive = evaluate(reduce(*scene.drive), recorder);
  const Column mass = scene.mass ? recorder.parameter(scene.mass->symbol) : zero_column;
  const Pair t = contact.tangential;
  const Column factor =
      recorder.single(Operation::Kind::drive_factor,
                      {t.storage, t.loss, drive.storage, drive.loss, mass, recorder.omega()});
  return recorder.multiply(contact.velocity, factor);
}

}  // namespace

std::optional<Operations> operations_of(const Scene& scene) {
  if (scene.receptance || (scene.drive && has_masses(*scene.drive))) return std::nullopt;
  Recorder recorder(scene.angular_frequency.symbol);
  const Column outer = recorder.multiply(recorder.parameter(scene.coefficient.symbol),
                                         recorder.parameter(scene.amplitude.symbol));
  const Column velocity = recorder.multiply(outer, recorder.omega());
  const auto* isotropic = std::get_if<Isotropic>(&scene.tangential);
  const Contact contact =
      isotropic != nullptr
          ? isotropic_contact(recorder, scene, *isotropic, velocity)
          : anisotropic_contact(recorder, scene, std::get<Network>(scene.tangential), velocity);
  recorder.written().result = scene.drive ? driven(recorder, scene, contact) : contact.velocity;
  recorder.written().exact_contact =
      isotropic == nullptr && is_spring(std::get<Network>(scene.tangential));
  recorder.written().exact_drive = scene.drive && is_spring(*scene.drive);
  return std::move(recorder.written());
}

}  // namespace vcrit
