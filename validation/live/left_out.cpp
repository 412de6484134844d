// What the module leaves out of the program, with what the rest asks of it.
#include "base/errors.hpp"
#include "modes/general_modes.hpp"
#include "scene/members.hpp"
#include "stiffness/drive_motion.hpp"
#include "stiffness/graph_relaxation.hpp"

namespace vcrit {

// Needs Arb: a page has no numbers of any length.
Relaxation graph_relaxation(const RelaxationGraph& graph) {
  if (graph.edges.size() == 1) return graph.edges[0];
  throw ModelError("this page cannot simulate a network with a bridge; vcrit simulate can");
}

// Needs eigenvalues in many digits, which a page is to be small without.
DriveStructure drive_structure(const Network&, const Values&, double, const Symbol&) {
  throw ModelError("this page cannot simulate a drive that holds masses; vcrit simulate can");
}

namespace {

[[noreturn]] void no_masses() { throw Bug("a drive with masses in a page"); }

}  // namespace

DriveMotion drive_motion(const DriveStructure&) { no_masses(); }
DriveStructure stiffer(DriveStructure, double) { no_masses(); }

namespace simulation {

GeneralModes general_modes(const Dense<long double>&) { no_masses(); }
List<std::complex<double>> response(const Dense<long double>&, std::complex<double>) {
  no_masses();
}

}  // namespace simulation

// The text of a scene for pages has none.
void check_indenter(const Indenter&, const Place&) { throw Bug("an indenter in a page"); }

}  // namespace vcrit
