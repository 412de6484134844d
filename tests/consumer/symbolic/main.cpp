// Derives v* of the scene file and puts its numbers in.
#include <cstdio>
#include <map>
#include <vcrit/scene/scene.hpp>
#include <vcrit/symbolic.hpp>
#include <vcrit/vcrit.hpp>

int main(int, char** argv) {
  namespace symbolic = vcrit::symbolic;
  const vcrit::Scene scene = vcrit::read_scene(argv[1]);
  const symbolic::Derivation derivation = symbolic::derive(scene);
  std::map<vcrit::Symbol, GiNaC::numeric> values;
  for (const auto& [symbol, value] : vcrit::resolve(scene).values())
    values[symbol] = symbolic::exact_decimal(value);
  const GiNaC::numeric v =
      symbolic::value_at(derivation.critical_velocity, derivation.definitions, values);
  std::printf("%.17g\n", v.to_double());
}
