#include "bounds/systems.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

namespace vcrit::bounds {

namespace {

constexpr int branches = 10, rungs = 10, bridge_edges = 5,
              grid_edges = 12;  // of the systems with these names

class Builder {
 public:
  /// The network's expression; its slots are added, what it needs beside it goes to `networks`.
  std::string network(NetworkShape shape, const std::string& letter) {
    letter_ = letter;
    switch (shape) {
      case NetworkShape::spring:
        return k(0);
      case NetworkShape::kelvin:
        return spring_and_damper("|");
      case NetworkShape::maxwell:
        return spring_and_damper("-");
      case NetworkShape::zener:
        return zener();
      case NetworkShape::burgers:
        return burgers();
      case NetworkShape::prony:
        return prony();
      case NetworkShape::ladder:
        return ladder();
      case NetworkShape::bridge:
        return bridge();
      case NetworkShape::grid:
        return grid();
    }
    return {};
  }

  SlotRange network(NetworkShape shape, const std::string& letter, std::string& expression) {
    const std::size_t first = slots.size();
    expression = network(shape, letter);
    return {first, slots.size() - first};
  }

  std::size_t add(Role role, const std::string& name, int entry = 0) {
    slots.push_back({role, name, entry});
    return slots.size() - 1;
  }

  std::vector<Slot> slots;
  std::string networks;

 private:
  std::string named(Role role, const char* kind, int number) {
    const std::string name = fmt::format("{}{}{}", kind, letter_, number);
    add(role, name);
    return name;
  }
  std::string k(int number) { return named(Role::spring, "k", number); }
  std::string c(int number) { return named(Role::damper, "c", number); }

  // One after the other: the order of slots is that of the calls.
  std::string spring_and_damper(const char* sign) {
    const std::string spring = k(0), damper = c(0);
    return fmt::format("{} {} {}", spring, sign, damper);
  }

  std::string zener() {
    const std::string k0 = k(0), k1 = k(1), c1 = c(1);
    return fmt::format("{} | ({} - {})", k0, k1, c1);
  }

  std::string burgers() {
    const std::string k1 = k(1), c1 = c(1), k2 = k(2), c2 = c(2);
    return fmt::format("{} - {} - ({} | {})", k1, c1, k2, c2);
  }

  std::string prony() {
    const std::string k0 = k(0);
    for (int j = 1; j <= branches; ++j) add(Role::spring, "k" + letter_, j);
    for (int j = 1; j <= branches; ++j) add(Role::time, "tau" + letter_, j);
    return fmt::format("prony({0}, k{1}, tau{1}, {2})", k0, letter_, branches);
  }

  std::vector<std::string> several(std::string (Builder::*element)(int), int count) {
    std::vector<std::string> names;
    for (int j = 1; j <= count; ++j) names.push_back((this->*element)(j));
    return names;
  }

  std::string ladder() {
    const auto springs = several(&Builder::k, rungs), dampers = several(&Builder::c, rungs);
    std::string inner = springs.back() + " | " + dampers.back();
    for (std::size_t j = rungs - 1; j-- > 0;)
      inner = fmt::format("{} | ({} - ({}))", dampers[j], springs[j], inner);
    return inner;
  }

  std::string graph(const std::string& name, const std::string& terminals,
                    const std::vector<std::string>& edges) {
    networks += fmt::format("[networks.{}]\nterminals = [{}]\nedges = [{}]\n", name, terminals,
                            fmt::join(edges, ", "));
    return name;
  }

  std::string bridge() {
    const auto springs = several(&Builder::k, bridge_edges),
               dampers = several(&Builder::c, bridge_edges);
    const char* const ends[bridge_edges] = {R"("A", "C")", R"("A", "D")", R"("C", "B")",
                                            R"("D", "B")", R"("C", "D")"};
    std::vector<std::string> edges;
    for (std::size_t j = 0; j < bridge_edges; ++j)
      edges.push_back(fmt::format("[\"{} | {}\", {}]", springs[j], dampers[j], ends[j]));
    return graph("bridge_" + letter_, R"("A", "B")", edges);
  }

  // Springs and dampers by turns on the edges of 3 x 3 points, in the order of formulas.hpp.
  std::string grid() {
    std::vector<std::string> edges;
    const auto edge = [&](int from, int to) {
      const int number = static_cast<int>(edges.size()) + 1;
      const std::string name = number % 2 == 1 ? k(number) : c(number);
      edges.push_back(fmt::format("[\"{}\", \"p{}\", \"p{}\"]", name, from, to));
    };
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) {
        const int here = 3 * row + column;
        if (column < 2) edge(here, here + 1);
        if (row < 2) edge(here, here + 3);
      }
    return edges.size() == grid_edges ? graph("grid_" + letter_, R"("p0", "p8")", edges) : "";
  }

  std::string letter_;
};

enum class Contact { own, isotropic };

TrialSystem system(const std::string& name, NetworkShape contact, Contact tangential,
                   std::optional<NetworkShape> drive) {
  Builder builder;
  builder.add(Role::coefficient, "mu0");
  builder.add(Role::omega, "omega");
  builder.add(Role::amplitude, "du_z");
  std::string normal, other = "\"nu\"", driving;
  SlotRange own, driven;
  std::optional<std::size_t> mass, poisson;
  const SlotRange contacts = builder.network(contact, "n", normal);
  if (tangential == Contact::own) {
    own = builder.network(contact, "t", other);
    other = fmt::format("\"{}\"", other);
  } else {
    poisson = builder.add(Role::poisson, "nu");
  }
  std::string text = fmt::format("[contact]\nnormal = \"{}\"\n{} = {}\n", normal,
                                 tangential == Contact::own ? "tangential" : "poisson", other);
  if (drive) {
    driven = builder.network(*drive, "d", driving);
    mass = builder.add(Role::mass, "m");
    text += fmt::format("[drive]\nnetwork = \"{}\"\n[body]\nmass = \"m\"\n", driving);
  }
  Problem problem = parse_problem(text + builder.networks, name + ".toml");
  return {name,
          std::move(problem),
          std::move(builder.slots),
          contact,
          drive,
          contacts,
          own,
          driven,
          mass,
          poisson};
}

}  // namespace

std::vector<TrialSystem> all_systems() {
  return {system("rigid", NetworkShape::zener, Contact::own, {}),
          system("isotropic", NetworkShape::zener, Contact::isotropic, NetworkShape::spring),
          system("kelvin", NetworkShape::kelvin, Contact::own, NetworkShape::kelvin),
          system("maxwell", NetworkShape::maxwell, Contact::own, NetworkShape::maxwell),
          system("zener", NetworkShape::zener, Contact::own, NetworkShape::zener),
          system("burgers", NetworkShape::burgers, Contact::own, NetworkShape::burgers),
          system("prony10", NetworkShape::prony, Contact::own, NetworkShape::prony),
          system("ladder10", NetworkShape::ladder, Contact::own, NetworkShape::ladder),
          system("bridge", NetworkShape::bridge, Contact::own, NetworkShape::bridge),
          system("grid3x3", NetworkShape::grid, Contact::own, NetworkShape::grid)};
}

}  // namespace vcrit::bounds
