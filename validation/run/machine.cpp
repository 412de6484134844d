#include "run/machine.hpp"

#include <arb.h>
#include <cln/version.h>
#include <flint/flint.h>
#include <fmt/core.h>
#include <ginac/ginac.h>
#include <gsl/gsl_version.h>
#include <sys/utsname.h>
#include <tbb/version.h>

#include <Eigen/Core>
#include <boost/version.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "base/commit.hpp"

namespace vcrit::validation {

namespace {

/// What follows `key`, the separator and blanks or quotes on the first line that begins with it.
std::string entry(const char* file, const std::string& key, char separator) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind(key, 0) != 0) continue;
    const auto begin = line.find_first_not_of(" \t\"", line.find(separator) + 1);
    if (begin == line.npos) break;
    return line.substr(begin, line.find_last_not_of(" \t\"") - begin + 1);
  }
  return "unknown";
}

std::string system_name() {
  utsname kernel{};
  uname(&kernel);
  return fmt::format("{}, {} {}", entry("/etc/os-release", "PRETTY_NAME", '='), kernel.sysname,
                     kernel.release);
}

#if defined(__clang__)
constexpr const char* compiler_name = "clang";
#else
constexpr const char* compiler_name = "g++";
#endif

std::vector<std::pair<std::string, std::string>> versions() {
  return {
      {compiler_name, __VERSION__},
      {"Eigen",
       fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"GSL", GSL_VERSION},
      {"FLINT", FLINT_VERSION},
      {"Arb", arb_version},
      {"GiNaC", fmt::format("{}.{}.{}", GINACLIB_MAJOR_VERSION, GINACLIB_MINOR_VERSION,
                            GINACLIB_MICRO_VERSION)},
      {"CLN", fmt::format("{}.{}.{}", CL_VERSION_MAJOR, CL_VERSION_MINOR, CL_VERSION_PATCHLEVEL)},
      {"Boost", fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
                            BOOST_VERSION % 100)},
      {"oneTBB", fmt::format("{}.{}.{}", TBB_VERSION_MAJOR, TBB_VERSION_MINOR, TBB_VERSION_PATCH)},
      {"fmt",
       fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
      {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                                    NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)}};
}

}  // namespace

Machine this_machine() {
  return {entry("/proc/cpuinfo", "model name", ':'),
          std::thread::hardware_concurrency(),
          system_name(),
          VCRIT_VERSION,
          commit(),
          VCRIT_FLAGS,
          versions()};
}

}  // namespace vcrit::validation
