#include "live/scene_text.hpp"

#include <fmt/core.h>

#include <cstdlib>
#include <memory>
#include <type_traits>
#include <utility>

namespace vcrit::live {

namespace {

// Words with a space after each; before each text how long it is. One description of a scene serves
// both: transfer(archive, member) for all members, in one order.
class Writer {
 public:
  static constexpr bool reads = false;

  void number(double& x) { text_ += fmt::format("{} ", x); }
  void words(std::string& x) { text_ += fmt::format("{} {} ", x.size(), x); }
  std::string text() && { return std::move(text_); }

 private:
  std::string text_;
};

class Reader {
 public:
  static constexpr bool reads = true;

  explicit Reader(const std::string& text) : at_(text.c_str()) {}

  void number(double& x) {
    char* end = nullptr;
    x = std::strtod(at_, &end);
    at_ = end + 1;
  }
  void words(std::string& x) {
    double size = 0;
    number(size);
    x.assign(at_, static_cast<std::size_t>(size));
    at_ += x.size() + 1;
  }

 private:
  const char* at_;
};

template <class Archive>
void transfer(Archive& a, double& x) {
  a.number(x);
}
template <class Archive>
void transfer(Archive& a, std::string& x) {
  a.words(x);
}
template <class Archive, class T>
requires(std::is_integral_v<T> || std::is_enum_v<T>) void transfer(Archive& a, T& x) {
  auto number = static_cast<double>(x);
  a.number(number);
  x = static_cast<T>(static_cast<int>(number));
}

template <class Archive, class T>
void transfer(Archive& a, std::optional<T>& x);
template <class Archive, class T>
void transfer(Archive& a, std::vector<T>& x);
template <class Archive, class K, class T>
void transfer(Archive& a, std::map<K, T>& x);

template <class Archive, class First, class Second>
void transfer(Archive& a, std::pair<First, Second>& x) {
  transfer(a, x.first);
  transfer(a, x.second);
}
template <class Archive>
void transfer(Archive& a, Symbol& x) {
  transfer(a, x.name);
  transfer(a, x.entry);
}
template <class Archive>
void transfer(Archive& a, TypedNumber& x) {
  transfer(a, x.value);
  transfer(a, x.decimal);
}
template <class Archive>
void transfer(Archive& a, Quantity& x) {
  transfer(a, x.symbol);
  transfer(a, x.value);
}
template <class Archive>
void transfer(Archive& a, Isotropic& x) {
  transfer(a, x.by);
  transfer(a, x.quantity);
}
template <class Archive>
void transfer(Archive& a, Receptance::Row& x) {
  transfer(a, x.omega);
  transfer(a, x.re);
  transfer(a, x.im);
}
template <class Archive>
void transfer(Archive& a, Receptance& x) {
  transfer(a, x.file);
  transfer(a, x.rows);
}

template <class Archive>
void transfer(Archive& a, AmountTreePointer& x) {
  AmountTree tree = x ? *x : AmountTree{};
  bool there = x != nullptr;
  transfer(a, there);
  if (!there) return;
  transfer(a, tree.kind);
  transfer(a, tree.symbol);
  transfer(a, tree.role);
  transfer(a, tree.number);
  transfer(a, tree.first);
  transfer(a, tree.second);
  if constexpr (Archive::reads) x = std::make_shared<const AmountTree>(std::move(tree));
}
template <class Archive>
void transfer(Archive& a, Amount& x) {
  Symbol name = x.name();
  AmountTreePointer expression = x.expression();
  transfer(a, name);
  transfer(a, expression);
  if constexpr (Archive::reads) x = Amount(std::move(name), std::move(expression));
}

template <class Archive>
void transfer(Archive& a, Network& x);
template <class Archive>
void transfer(Archive& a, Element& x) {
  transfer(a, x.kind);
  transfer(a, x.coefficient);
  transfer(a, x.second);
}
template <class Archive>
void transfer(Archive& a, Series& x) {
  transfer(a, x.parts);
}
template <class Archive>
void transfer(Archive& a, Parallel& x) {
  transfer(a, x.parts);
}
template <class Archive>
void transfer(Archive& a, Wire& x) {
  transfer(a, x.from);
  transfer(a, x.to);
}
template <class Archive>
void transfer(Archive& a, Graph& x) {
  transfer(a, x.nodes);
  transfer(a, x.parts);
  transfer(a, x.wires);
}

// The alternative by its place, then what it holds.
template <class Archive, class... T>
void transfer(Archive& a, std::variant<T...>& x) {
  std::size_t place = x.index(), i = 0;
  transfer(a, place);
  const auto one = [&]<class Held>(Held held) {
    if (i++ != place) return;
    if constexpr (!Archive::reads) held = std::get<Held>(x);
    transfer(a, held);
    if constexpr (Archive::reads) x = std::move(held);
  };
  (one(T{}), ...);
}
template <class Archive>
void transfer(Archive& a, Network& x) {
  transfer(a, x.form);
}

template <class Archive, class T>
void transfer(Archive& a, std::optional<T>& x) {
  bool there = x.has_value();
  transfer(a, there);
  if (!there) return;
  if constexpr (Archive::reads) x.emplace();
  transfer(a, *x);
}
template <class Archive, class T>
void transfer(Archive& a, std::vector<T>& x) {
  std::size_t size = x.size();
  transfer(a, size);
  if constexpr (Archive::reads) x.resize(size);
  for (T& each : x) transfer(a, each);
}
template <class Archive, class K, class T>
void transfer(Archive& a, std::map<K, T>& x) {
  std::vector<std::pair<K, T>> all(x.begin(), x.end());
  transfer(a, all);
  if constexpr (Archive::reads) x = {all.begin(), all.end()};
}

// Without indenter: below one each place has a motion of its own, and no page simulates that.
template <class Archive>
void transfer(Archive& a, Scene& x) {
  transfer(a, x.file);
  transfer(a, x.names);
  transfer(a, x.separation);
  transfer(a, x.mass);
  for (Quantity* each : {&x.coefficient, &x.angular_frequency, &x.amplitude, &x.indentation})
    transfer(a, *each);
  transfer(a, x.load);
  transfer(a, x.mount_mass);
  transfer(a, x.elements);
  transfer(a, x.normal);
  transfer(a, x.tangential);
  transfer(a, x.drive);
  transfer(a, x.mount);
  transfer(a, x.receptance);
}

std::variant<Isotropic, Network> tangential_of(const Problem& problem) {
  if (const auto* own = std::get_if<ReducedNetwork>(&problem->tangential)) return own->network();
  return std::get<Isotropic>(problem->tangential);
}

}  // namespace

std::string scene_text(const Problem& problem) {
  Scene scene;
  static_cast<Givens&>(scene) = *problem;
  for (const auto& [symbol, value] : elements_with_values(problem))
    scene.elements.emplace_back(symbol, value);
  scene.file = problem->source->file;
  scene.normal = problem->normal.network();
  scene.tangential = tangential_of(problem);
  if (const ReducedNetwork* drive = problem->drive_network()) scene.drive = drive->network();
  if (problem->mount) scene.mount = problem->mount->network();
  if (const Receptance* measured = problem->receptance()) scene.receptance = *measured;
  Writer writer;
  transfer(writer, scene);
  return std::move(writer).text();
}

Scene scene_of(const std::string& text) {
  Scene scene;
  Reader reader(text);
  transfer(reader, scene);
  return scene;
}

}  // namespace vcrit::live
