// What compiles and runs evaluators of each language but C++.
#pragma once

#include <string>
#include <vector>

#include "emit/languages/languages.hpp"

namespace vcrit::test {

/// Words, where FOLDER/ stands for the folder of the files.
using Command = std::vector<std::string>;

struct Tool {
  std::string label;
  symbolic::Language language;
  Command present, compile, run;
  bool wide = false;         ///< knows numbers out of range
  bool is_optional = false;  ///< `./dev test` does not install it
};

inline std::vector<Tool> tools() {
  const auto with = [](Command words, const Command& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  const Command strict{"-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"};
  const auto c = [&](const char* compiler, const Command& flags) {
    return with(with({compiler}, flags),
                with(strict, {"-o", "FOLDER/c", "FOLDER/driver.c", "-lm"}));
  };
  const Command host = with({"g++", "-std=c++17", "-x", "c++"},
                            with(strict, {"-o", "FOLDER/host", "FOLDER/driver.cu"}));
  const Command nvcc{"nvcc", "-std=c++17", "-x", "cu", "-o", "FOLDER/cuda", "FOLDER/driver.cu"};
  std::vector<Tool> all{
      {"gcc",
       symbolic::Language::c99,
       {"gcc", "--version"},
       c("gcc", {"-std=c99", "-O1"}),
       {"FOLDER/c"},
       true},
      // With contraction to fma where the machine has it, which -std=c99 turns off.
      {"gcc with extensions",
       symbolic::Language::c99,
       {"gcc", "--version"},
       c("gcc", {"-std=gnu99", "-O2", "-march=native"}),
       {"FOLDER/c"},
       true},
      {"clang",
       symbolic::Language::c99,
       {"clang", "--version"},
       c("clang", {"-std=c99", "-O1"}),
       {"FOLDER/c"},
       true},
      {"CUDA on the host alone",
       symbolic::Language::cuda,
       {"g++", "--version"},
       host,
       {"FOLDER/host"},
       true},
      {"nvcc", symbolic::Language::cuda, {"nvcc", "--version"}, nvcc, {"FOLDER/cuda"}, true, true},
      {"node",
       symbolic::Language::javascript,
       {"node", "--version"},
       {},
       {"node", "FOLDER/driver.mjs"}},
  };
  // A Python of one's own may stand before the system's, which has the packages.
  for (const char* python : {"python3", "/usr/bin/python3"})
    all.push_back({python,
                   symbolic::Language::python,
                   {python, "-c", "import numpy"},
                   {},
                   {python, "-B", "FOLDER/driver.py"},
                   false,
                   python[0] != '/'});
  return all;
}

}  // namespace vcrit::test
