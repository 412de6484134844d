// The derivation, as one of the documents that `vcrit derive` prints.
#include <chrono>
#include <map>
#include <memory>
#include <mutex>

#include "bindings.hpp"
#include "document/findings.hpp"
#include "document/print.hpp"
#include "formula/algebra_lock.hpp"
#include "formula/names.hpp"
#include "interrupt.hpp"

namespace vcrit::python {

namespace {

using symbolic::Format;
using symbolic::ResultForm;

const std::map<std::string, Format>& formats() {
  static const std::map<std::string, Format> names = [] {
    std::map<std::string, Format> all{{"text", Format::text},
                                      {"latex", Format::latex},
                                      {"markdown", Format::markdown},
                                      {"html", Format::html},
                                      {"json", Format::json}};
    for (const std::string& system : symbolic::system_names()) all[system] = Format::system;
    return all;
  }();
  return names;
}

const std::map<std::string, ResultForm>& forms() {
  static const std::map<std::string, ResultForm> names{
      {"shortest", ResultForm::shortest},           {"nested", ResultForm::nested},
      {"storage-loss", ResultForm::storage_loss},   {"rational", ResultForm::rational},
      {"dimensionless", ResultForm::dimensionless}, {"expanded", ResultForm::expanded}};
  return names;
}

template <class Value>
Value named(const std::map<std::string, Value>& names, const std::string& asked,
            const std::string& name) {
  if (const auto found = names.find(name); found != names.end()) return found->second;
  std::string expected;
  for (const auto& [known, value] : names) expected += (expected.empty() ? "" : ", ") + known;
  throw InputError(argument(asked), '"' + name + '"', "one of " + expected);
}

// GiNaC works in one thread at a time. Who waits has let go of the interpreter, which the one that
// works may need, and hears Ctrl-C as well.
std::unique_lock<std::timed_mutex> alone() {
  static std::timed_mutex mutex;
  std::unique_lock lock(mutex, std::defer_lock);
  while (!lock.try_lock_for(std::chrono::milliseconds(50))) hear_interruption();
  return lock;
}

/// Documents without limits and sensitivities differ in markup alone, and several are asked for one
/// after the other: what was found out last is kept for them.
std::string of_last_findings(const Problem& problem, const symbolic::DocumentOptions& options) {
  struct Found {
    Problem problem;
    symbolic::Findings findings;
  };
  static auto* const last = new std::unique_ptr<Found>;  // never ended: GiNaC may end before it
  symbolic::check_options(options);
  const symbolic::AlgebraLock lock;
  const symbolic::NamesOfScene names(problem);
  if (!*last || &*(*last)->problem != &*problem || (*last)->findings.form != options.form)
    *last = std::make_unique<Found>(Found{problem, findings_of(problem, options)});
  return print_findings(problem, (*last)->findings, options.format, options.system,
                        options.standalone);
}

std::string document(const Problem& problem, const std::string& format, const std::string& form,
                     bool limits, bool sensitivities, bool standalone) {
  symbolic::DocumentOptions options;
  options.format = named(formats(), "format", format);
  options.system = format;
  options.form = named(forms(), "form", form);
  options.limits = limits;
  options.sensitivities = sensitivities;
  options.standalone = standalone;
  const OthersRun others_run;
  const auto lock = alone();
  return limits || sensitivities ? symbolic::print(problem, options)
                                 : of_last_findings(problem, options);
}

}  // namespace

void add_derivation(pybind11::module_& module) {
  using pybind11::arg;
  module.def("document", &document, arg("scene"), arg("format"), arg("form"), arg("limits"),
             arg("sensitivities"), arg("standalone"));
}

}  // namespace vcrit::python
