#include "scene/part_networks.hpp"

#include <fmt/core.h>

#include <utility>
#include <vector>

#include "network/graph.hpp"
#include "network/law.hpp"
#include "network/masses.hpp"

namespace vcrit {

void refuse_misplaced_masses(const Network& drive, const Place& place) {
  const std::vector<Symbol> off = masses_off_the_far_end(drive);
  if (!off.empty())
    throw InputError(
        place, fmt::format("mass \"{}\" between two moving points", to_text(off.front())),
        "one end of each mass at the far end of the drive, as in \"k1 - (mass(m1) | k2)\", or at "
        "node \"ground\" of a graph");
  if (hangs_on_masses(drive))
    throw InputError(place, "a drive in which only masses lead to the far end",
                     "a path of springs and dampers, to balance the mean friction");
}

Network without_zeros(const Network& network, const std::function<bool(const Symbol&)>& zero,
                      const std::string& role, const std::string& file) {
  auto left = with_elements(
      network, [&zero](const Element& element) { return vcrit::without_zeros(element, zero); });
  if (!left || hangs_on_masses(*left))
    throw InputError({file}, fmt::format("a {} network that elements of value 0 cut in two", role),
                     "a path of springs and dampers above 0 between its terminals");
  return std::move(*left);
}

}  // namespace vcrit
