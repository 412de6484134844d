#include "paper/paper.hpp"

#include "paper/difference_map.hpp"
#include "paper/evidence.hpp"
#include "paper/figure4.hpp"
#include "paper/flat_punch.hpp"
#include "paper/limits.hpp"
#include "paper/misprints.hpp"
#include "paper/proofs.hpp"
#include "paper/range.hpp"
#include "paper/shapes.hpp"
#include "paper/viscosity.hpp"

namespace vcrit::validation::paper {

std::vector<Comparison> all_comparisons(const Paper& paper) {
  std::vector<Comparison> all;
  for (const auto* part :
       {&paper.proofs.comparisons, &paper.range.comparisons, &paper.figure4.comparisons,
        &paper.map.comparisons, &paper.amplitudes.comparisons, &paper.slow.comparisons,
        &paper.viscosity.comparisons, &paper.punch.comparisons, &paper.shapes.comparisons,
        &paper.misprints.comparisons, &paper.evidence.comparisons})
    all.insert(all.end(), part->begin(), part->end());
  return all;
}

std::vector<figures::Figure> all_figures(const Paper& paper) {
  std::vector<figures::Figure> all = paper.figure4.reduced;
  all.insert(all.end(), paper.figure4.full.begin(), paper.figure4.full.end());
  all.push_back(paper.map.figure);
  all.insert(all.end(), paper.viscosity.figures.begin(), paper.viscosity.figures.end());
  all.push_back(paper.punch.figure);
  return all;
}

Paper go_through(const Progress& progress) {
  Paper paper;
  progress("deriving (29) to (31)");
  paper.proofs = prove_equations();
  progress("simulating the range of (24)");
  paper.range = explore_range();
  progress("drawing Fig. 4");
  paper.figure4 = draw_figure4();
  progress("mapping the reduced model");
  paper.map = map_difference();
  progress("looking for limits");
  paper.amplitudes = find_amplitude_limits();
  paper.slow = approach_rest();
  paper.viscosity = compare_viscosities();
  paper.punch = press_flat_punch();
  paper.shapes = press_shapes();
  paper.misprints = try_misprints();
  progress("hearing three methods");
  paper.evidence = hear_witnesses();
  paper.claims = judge(paper);
  return paper;
}

}  // namespace vcrit::validation::paper
