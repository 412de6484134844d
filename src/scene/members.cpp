#include "scene/members.hpp"

#include <fmt/core.h>

#include "network/graph.hpp"
#include "network/law.hpp"
#include "network/masses.hpp"
#include "network/wiring.hpp"
#include "scene/scene.hpp"

namespace vcrit {

namespace {

class Members {
 public:
  Members(const Scene& scene, const Values& elements) : scene_(scene), elements_(elements) {}

  void check() const {
    check_contact_network(scene_.normal, "normal");
    if (const auto* tangential = std::get_if<Network>(&scene_.tangential))
      check_contact_network(*tangential, "tangential");
    if (scene_.mount) check_mount();
    check_drive();
    if (scene_.indenter) check_indenter();
  }

 private:
  [[noreturn]] void refuse(const std::string& found, const std::string& expected) const {
    throw InputError({scene_.file}, found, expected);
  }

  void check_network(const Network& network, const char* role) const {
    check_wiring(network);
    for_each_element(network, [&](const Element& element) {
      for_each_number(element, [&](const Symbol& symbol, NumberRole) {
        if (!elements_.contains(symbol))
          refuse(fmt::format("{} in the {} network but not in elements",
                             to_text(as_called(scene_, symbol)), role),
                 "an entry of elements for each number of its networks");
      });
    });
  }

  void check_contact_network(const Network& network, const char* role) const {
    check_network(network, role);
    if (has_masses(network))
      refuse(fmt::format("a mass in the {} network", role),
             "springs and dampers: only a drive may hold masses");
  }

  void check_mount() const {
    check_contact_network(*scene_.mount, "mount");
    if (!springs_alone(*scene_.mount))
      refuse("a mount without springs through it", "K_m(0) above 0, for the mean normal force");
    if (scene_.indenter) refuse("a mount above an indenter", "one of the two");
  }

  void check_drive() const {
    if (scene_.drive && scene_.receptance) refuse("drive and receptance", "one of the two");
    if (!scene_.drive) return;
    check_network(*scene_.drive, "drive");
    if (!has_masses(*scene_.drive)) return;
    if (const auto off = masses_off_the_far_end(*scene_.drive); !off.empty())
      refuse(fmt::format("mass {} in the drive between two moving points", to_text(off.front())),
             "one end of each mass at the far end of the drive");
    if (hangs_on_masses(*scene_.drive))
      refuse("a drive in which only masses lead to the far end",
             "a path of springs and dampers, to balance the mean friction");
  }

  void check_indenter() const {
    const auto* isotropic = std::get_if<Isotropic>(&scene_.tangential);
    if (isotropic == nullptr || isotropic->by != Isotropic::By::poisson)
      refuse("indenter with a tangential contact by other means than poisson",
             "tangential = Isotropic{By::poisson, ...}, of the half-space");
    for (const Quantity& size : scene_.indenter->sizes)
      if (!size.value) return;
    vcrit::check_indenter(*scene_.indenter, {scene_.file});
  }

  const Scene& scene_;
  const Values& elements_;
};

}  // namespace

void check_members(const Scene& scene, const Values& elements) { Members(scene, elements).check(); }

}  // namespace vcrit
