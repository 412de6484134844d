// The steady normal force of an indenter on a viscoelastic half-space, and its rate, at any phase.
//
// A cell is given by its place. Of two cells the inner one is pressed no less at any time: it
// touches no later and lifts off no earlier. So cells that touch are those up to one place, the
// front, which moves outwards until the indentation is largest, and then inwards. Touches of cells
// and what their branches carry are smooth functions of the place, found once; the force is the
// integral up to the front.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "base/constants.hpp"
#include "indenter/half_space.hpp"
#include "indenter/pieces.hpp"
#include "modes/contact_modes.hpp"
#include "normal/normal_cycle.hpp"

namespace vcrit::indenter {

/// Places from one to the next, with a variable s in [0, 1] in which roots at both ends are smooth.
struct Panel {
  double low = 0, high = 0;  ///< m

  double at(double s) const { return low + (high - low) * s * s * (3 - 2 * s); }
  double rate(double s) const { return (high - low) * 6 * s * (1 - s); }
};

/// Panels of cells that never open, and of those that do, from the middle outwards.
struct CellPanels {
  explicit CellPanels(const HalfSpace& half_space);

  std::vector<Panel> closed, opening;
};

/// The one touch of a cell that opens: phases in (-2 pi, pi), begin < end; forces in N/m.
struct CellTouch {
  double begin = 0, end = 0;
  simulation::Vector decays;  ///< as NormalCycle::Touch has them
};

/// Cells by their place.
class MemoryCells {
 public:
  explicit MemoryCells(const HalfSpace& half_space);

  /// Throws ModelError where a cell touches more than once in a period.
  CellTouch touch(double x) const;
  /// Of a cell that touches, at a phase between begin and end, and of its oscillation alone there,
  /// which is that of all cells.
  double force(const CellTouch& touch, double t, double swing) const;
  double swing_force(double t) const;

  const simulation::ContactModes& modes() const { return modes_; }
  std::complex<double> swing() const { return swing_; }  ///< du_z E*(i omega), N/m
  /// The phase at which a cell carries least that never opens.
  double least_phase() const { return pi - std::arg(swing_); }

 private:
  CellTouch of_rim(double depth) const;

  HalfSpace half_space_;
  simulation::ContactModes modes_;
  std::complex<double> swing_;
};

class MemoryForce {
 public:
  /// tolerance: relative, of what is interpolated. Throws ModelError where no normal force of a
  /// cell is found.
  MemoryForce(const HalfSpace& half_space, double tolerance);

  struct Sum {
    double force = 0, rate = 0;  ///< N, the rate by omega t
  };
  Sum at(double t) const;
  bool touches(double t) const;
  /// Phases in [0, 2 pi] at which the force turns sharply.
  const std::vector<double>& kinks() const { return kinks_; }
  /// Whether the rate has no bound: a direct damper at a rounded tip, whose area grows like a root.
  bool rate_unbounded() const { return rate_unbounded_; }

 private:
  /// Cells of a panel over which the force is summed at once.
  struct Span {
    double low = 0, high = 0;  ///< of s
    Eigen::MatrixXd touches;   ///< a column a place that is asked, in their order: rate, touch
  };
  struct Opening {
    Panel panel;
    Pieces touch;                          ///< by s: begin, end, decays
    std::vector<std::vector<Span>> whole;  ///< of each piece of it, when all of it touches
  };
  struct Phases {
    double begin = 0, end = 0;
    Pieces values;  ///< force and rate
  };

  void find_touches(const std::vector<Panel>& panels, double tolerance);
  void interpolate(double tolerance);
  void require_nested(const Pieces& touch) const;
  double front(const Opening& part, double t, bool& grows) const;
  void add(const Opening& part, double t, Sum& sum) const;
  std::vector<Span> spans(const Opening& part, double low, double high) const;
  void add_span(const Span& span, double t, Sum& sum) const;
  Sum summed(double t) const;
  double wrapped(double t) const;

  MemoryCells cells_;
  double closed_edge_ = 0, closed_mean_ = 0;
  double last_ = 0;  ///< the phase at which the last cell lifts off, or hardly any is left
  bool rate_unbounded_ = false;
  std::vector<Opening> openings_;
  std::vector<Phases> phases_;
  std::vector<double> kinks_;
};

}  // namespace vcrit::indenter
