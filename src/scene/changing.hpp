// One scene with ever new values of some parameters, as if it were read again each time, but
// without reading where no element appears or vanishes.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace vcrit {

class ChangingScene {
 public:
  /// `names` as for --set. Throws InputError for names that the scene does not have and for two
  /// names of one quantity.
  ChangingScene(const Scene& scene, std::vector<std::string> names);
  ChangingScene(const ChangingScene&) = delete;
  ChangingScene& operator=(const ChangingScene&) = delete;

  /// The scene with one value (SI) for each name, until the next call. Throws InputError as reading
  /// with these settings does.
  const Scene& at(std::span<const double> values);

  /// What a name stands for in the scene: a number of it times a factor.
  struct Target {
    std::optional<double>* value = nullptr;  ///< null where the scene leaves the quantity out
    Symbol symbol;
    double factor = 1;        ///< 2 pi for a frequency
    bool is_poisson = false;  ///< the one quantity that need not be positive
  };
  const std::vector<Target>& targets() const { return targets_; }

 private:
  Target target(const std::string& name);
  const Scene& read_again(std::span<const double> values);

  std::vector<std::string> names_;
  Scene scene_;
  std::optional<Scene> read_;
  std::vector<Target> targets_;
};

}  // namespace vcrit
