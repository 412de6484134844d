// --method and the options of each method: the one place where the exact method and the others
// meet.
#pragma once

#include <string>

#include "simulation/methods/methods.hpp"

namespace CLI {
class App;
}

namespace vcrit::app {

class MethodChoice {
 public:
  void add_to(CLI::App& command);
  const std::string& name() const { return name_; }
  bool is_exact() const { return !simulation::method_named(name_); }
  /// Throws InputError for an option that the method does not take.
  simulation::SteadyState steady_state(const simulation::System& system, double velocity) const;

 private:
  simulation::Start start() const;

  std::string name_ = "exact", start_ = "sliding";
  simulation::MethodOptions options_;
  bool plain_ = false;
  CLI::App* command_ = nullptr;
};

}  // namespace vcrit::app
