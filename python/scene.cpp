// A scene for Python: what it names, whether Eq. 24 applies, and v*.
#include "scene/scene.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <tuple>

#include "answers/critical_onset.hpp"
#include "base/files.hpp"
#include "base/units.hpp"
#include "bindings.hpp"
#include "critical/admissibility.hpp"
#include "interrupt.hpp"
#include "scene/settings.hpp"

namespace vcrit::python {

namespace py = pybind11;

namespace {

using Parameter = std::tuple<std::string, std::optional<double>, std::string>;

// What the scene's formulas may depend on, under the names of the formulas: name, value, unit.
std::vector<Parameter> parameters(const Scene& scene) {
  std::vector<Parameter> all;
  const auto add = [&](const Symbol& symbol, const std::optional<double>& value) {
    const std::string name = to_text(as_called(scene, symbol));
    if (const auto known = scene.settable.find(name); known != scene.settable.end())
      all.emplace_back(name, value, si_unit(known->second));
  };
  for (const Quantity* quantity :
       {&scene.coefficient, &scene.angular_frequency, &scene.amplitude, &scene.indentation})
    add(quantity->symbol, quantity->value);
  if (scene.mass) add(scene.mass->symbol, scene.mass->value);
  if (const auto* isotropic = std::get_if<Isotropic>(&scene.tangential))
    add(isotropic->quantity.symbol, isotropic->quantity.value);
  for (const auto& [symbol, value] : scene.elements) add(symbol, value);
  return all;
}

std::map<std::string, std::string> settable(const Scene& scene) {
  std::map<std::string, std::string> units;
  for (const auto& [name, dimension] : scene.settable) units[name] = si_unit(dimension);
  return units;
}

std::tuple<double, double, std::string> certified(const Scene& scene) {
  const OthersRun others_run;
  const auto [value, bound, reason] = certified_onset(scene);
  return {value, bound, reason};
}

std::tuple<double, double, std::string, std::string> onset(const Scene& scene) {
  const OthersRun others_run;
  const CriticalOnset found = critical_onset(scene);
  return {found.contact_velocity, found.drive_velocity,
          found.by == CriticalOnset::By::formula ? "formula" : "simulation", found.reason};
}

double factor(const Scene& scene, const std::string& name, const std::string& unit) {
  const Place place{name};
  return parse_quantity("1 " + unit, known_dimension(name, scene.settable, place, scene.named),
                        place);
}

// Of files beside the scene's own.
bool reads_tables(const Scene& scene) {
  return scene.receptance.has_value() || (scene.indenter && scene.indenter->profile);
}

std::string read(const std::string& file) { return read_file(file); }

}  // namespace

void add_scene(py::module_& module) {
  using py::arg;
  py::class_<Scene>(module, "Scene")
      .def(py::init(&parse_scene), arg("text"), arg("file"), arg("settings"))
      .def_readonly("title", &Scene::title)
      .def_property_readonly("reads_tables", &reads_tables)
      .def_readonly("warnings", &Scene::warnings);
  module.def("read_file", &read, arg("file"));
  module.def("parameters", &parameters, arg("scene"));
  module.def("settable", &settable, arg("scene"));
  module.def("factor", &factor, arg("scene"), arg("name"), arg("unit"));
  module.def("certified", &certified, arg("scene"));
  module.def("reasons", &inadmissible_reasons, arg("scene"));
  module.def("critical_onset", &onset, arg("scene"));
}

}  // namespace vcrit::python
