// vcrit's own ways.
#include <algorithm>
#include <chrono>
#include <set>

#include "derivation/derivation.hpp"
#include "derivation/stiffness_forms.hpp"
#include "polynomial/network_polynomials.hpp"
#include "scaling/own.hpp"

namespace vcrit::scaling {

double median_seconds(const std::function<void()>& run) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  std::vector<double> seconds;
  do {
    const Clock::time_point start = Clock::now();
    run();
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
  } while (Clock::now() - begin < std::chrono::milliseconds(100));
  std::nth_element(seconds.begin(), seconds.begin() + static_cast<long>(seconds.size() / 2),
                   seconds.end());
  return seconds[seconds.size() / 2];
}

std::optional<double> straight_line(const Case& each) {
  return median_seconds([&] { reduce(each.network); });
}

std::optional<double> named_formula(const Case& each) {
  return median_seconds([&] {
    std::vector<symbolic::Line> definitions;
    symbolic::nested(reduce(each.network), {}, definitions);
  });
}

std::optional<double> multiplied_out(const Case& each) {
  std::set<std::string> names{"s"};
  for (const Symbol& symbol : symbols_of(each.network)) names.insert(to_text(symbol));
  return median_seconds([&] {
    const symbolic::Ring ring({names.begin(), names.end()});
    symbolic::stiffness(each.network, ring);
  });
}

double whole_derivation(const Case& each) {
  Scene scene;
  scene.normal = each.network;
  scene.tangential = Isotropic{Isotropic::By::ratio, {{"tangential_ratio"}, 0.8}};
  scene.drive = spring({"kd"});
  scene.mass = Quantity{{"m"}, {}};
  for (const Symbol& symbol : symbols_of(each.network))
    scene.elements.emplace_back(symbol, std::nullopt);
  return median_seconds([&] { symbolic::derive(scene); });
}

}  // namespace vcrit::scaling
