// Problem         An evaluator of v* for one scene, to be compiled into another program: slider.hpp
//                 for C++ (use_header.cpp includes it) and slider.h for C (embed.c).
// Exact solution  What these two print.
// Method          Eq. (24) as a straight-line program without subtraction, written out with its
//                 error bound.
//
//     generate scenes/elastic_drive.toml DIR
#include <cstdio>
#include <vcrit/symbolic.hpp>

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: generate SCENE DIR\n"), 2;
  namespace symbolic = vcrit::symbolic;
  const symbolic::Derivation derivation = symbolic::derive(vcrit::read_problem(argv[1]));
  symbolic::generate(derivation, argv[2], "slider");
  symbolic::generate(derivation, argv[2], "slider", {.language = "c99"});
}
