#include "harness/network_json.hpp"

#include "network/reduction.hpp"

namespace vcrit::bench {

namespace {

struct Recorder {
  using Value = std::size_t;
  nlohmann::ordered_json steps = nlohmann::ordered_json::array();

  Value recorded(nlohmann::ordered_json step) {
    steps.push_back(std::move(step));
    return steps.size() - 1;
  }
  Value element(const Element& e) {
    const std::string name = to_text(e.coefficient);
    switch (e.kind) {
      case ElementKind::spring:
        return recorded({"spring", name});
      case ElementKind::damper:
        return recorded({"damper", name});
      case ElementKind::maxwell:
        return recorded({"maxwell", name, to_text(e.second)});
      case ElementKind::lossy:
      case ElementKind::measured:
      case ElementKind::mass:
        break;
    }
    throw Bug("an element of a kind that peers do not know");
  }
  Value parallel(Value a, Value b) { return recorded({"parallel", a, b}); }
  Value series(Value a, Value b) { return recorded({"series", a, b}); }
  Value mesh(Value a, Value b, Value total) { return recorded({"mesh", a, b, total}); }
};

}  // namespace

nlohmann::ordered_json network_json(const Network& network) {
  Recorder recorder;
  evaluate(reduce(network), recorder);
  return recorder.steps;
}

}  // namespace vcrit::bench
