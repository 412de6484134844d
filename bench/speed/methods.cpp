#include "speed/methods.hpp"

#include <exception>

namespace vcrit::speed {

namespace {

std::vector<std::string> with_scene(std::vector<std::string> flags, const Subject& subject) {
  flags.push_back("-DVCRIT_SCENE=" + subject.by_hand);
  return flags;
}

}  // namespace

TimedMethod evaluator(const std::string& method, CallMode mode,
                      std::shared_ptr<const Library> library, const std::string& function) {
  const Function call = library->function(function);
  TimedMethod result;
  result.method = method;
  result.mode = mode;
  result.run = [library, call](const Samples& samples, double* out, double* extra) {
    call(samples.columns(), samples.size(), out, extra);
  };
  return result;
}

std::vector<std::string> all_methods() {
  std::vector<std::string> names{"std::complex",
                                 "std::complex, fast-math",
                                 "by hand, real parts",
                                 "by hand, k_d - m w^2 exact",
                                 "by hand, even and odd in w",
                                 "by hand, squares in w^2",
                                 "SymPy cse",
                                 "SymPy cse, fast-math",
                                 "GiNaC compile_ex",
                                 "GiNaC compile_ex, -O3"};
  for (const char* grade : {"accurate", "fast"})
    for (const char* call :
         {"batch", "certified batch", "gradient batch", "scalar", "gradient scalar"})
      names.push_back(std::string("vcrit ") + grade + ", " + call);
  for (const char* limit : {"division", "root", "both"})
    names.push_back(std::string("machine, ") + limit);
  return names;
}

std::vector<TimedMethod> loops_by_hand(const Subject& subject,
                                       const std::filesystem::path& compiler) {
  const auto built = [&](const char* source, const std::vector<std::string>& flags) {
    return std::make_shared<const Library>(compiler, with_scene(flags, subject),
                                           peer_source(source));
  };
  const auto complex = built("complex_loop.cpp", Flags::scalar());
  const auto unsafe = built("complex_loop.cpp", Flags::unsafe());
  const auto real = built("real_loop.cpp", Flags::by_hand());
  std::vector<std::string> exact_flags = Flags::by_hand();
  exact_flags.emplace_back("-DVCRIT_EXACT_DRIVE");
  const auto exact = built("real_loop.cpp", exact_flags);
  const auto polynomial = built("polynomial_loop.cpp", Flags::by_hand());
  std::vector<TimedMethod> all;
  for (const CallMode mode : both_modes) {
    const std::string function = mode == CallMode::sweep ? "sweep" : "varying";
    all.push_back(evaluator("std::complex", mode, complex, function));
    all.push_back(evaluator("std::complex, fast-math", mode, unsafe, function));
    all.push_back(evaluator("by hand, real parts", mode, real, function));
    all.push_back(evaluator("by hand, k_d - m w^2 exact", mode, exact, function));
  }
  all.push_back(
      evaluator("by hand, even and odd in w", CallMode::sweep, polynomial, "even_and_odd"));
  all.push_back(evaluator("by hand, squares in w^2", CallMode::sweep, polynomial, "squares"));
  return all;
}

std::vector<TimedMethod> machine_limits(const std::filesystem::path& compiler) {
  const auto library =
      std::make_shared<const Library>(compiler, Flags::by_hand(), peer_source("limits.cpp"));
  std::vector<TimedMethod> all;
  for (const char* name : {"division", "root", "both"})
    for (const CallMode mode : both_modes) {
      all.push_back(evaluator(std::string("machine, ") + name, mode, library, name));
      all.back().family = MethodFamily::machine;
    }
  return all;
}

std::vector<TimedMethod> evaluators(const Subject& subject, const std::filesystem::path& compiler,
                                    std::vector<MissingMethod>& missing) {
  std::vector<TimedMethod> all;
  const auto add = [&](const char* what, const auto& make) {
    try {
      for (TimedMethod& each : make()) all.push_back(std::move(each));
    } catch (const std::exception& error) {
      missing.push_back({subject.name, what, error.what()});
    }
  };
  add("loops by hand", [&] { return loops_by_hand(subject, compiler); });
  add("SymPy", [&] { return sympy(subject, compiler); });
  add("GiNaC", [&] { return ginac(subject); });
  add("machine", [&] { return machine_limits(compiler); });
  add("vcrit", [&] { return generated(subject, compiler); });
  return all;
}

}  // namespace vcrit::speed
