// What the module leaves out of the program, with what the rest asks of it.
#include "base/errors.hpp"
#include "critical/certified.hpp"
#include "normal/pressed_cells.hpp"
#include "scene/members.hpp"
#include "simulation/system/measured_drive.hpp"
#include "stiffness/graph_relaxation.hpp"

namespace vcrit {

// Needs Arb: a page has no numbers of any length.
Relaxation graph_relaxation(const RelaxationGraph& graph) {
  if (graph.edges.size() == 1) return graph.edges[0];
  throw ModelError("this page cannot simulate a network with a bridge; vcrit simulate can");
}

// Likewise, for v* beyond doubles.
CertifiedVelocity certified_critical_velocity(const Problem&) {
  throw ModelError("this page has no v* beyond doubles; vcrit eval has");
}

// Needs the fit of a structure to the table.
void simulation::hold_by_table(System&, const Receptance&, std::optional<double>) {
  throw ModelError("this page cannot simulate a measured drive; vcrit simulate can");
}

// The text of a scene for pages has none.
void check_indenter(const Indenter&, const Place&) { throw Bug("an indenter in a page"); }
double simulation::indentation_of_cells(const Problem&) { throw Bug("an indenter in a page"); }

}  // namespace vcrit
