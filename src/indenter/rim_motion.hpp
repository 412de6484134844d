// The motion of an elastic indenter on a drive that gives: from event to event, between which the
// radius inside which cells stick is a smooth function of time and of what the cells remember.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <vector>

#include "base/constants.hpp"
#include "indenter/collocation.hpp"
#include "indenter/rim.hpp"

namespace vcrit::indenter {

/// Which cells slide: all from a rim on in one direction, none, or there are none at all.
enum class RimMode { forward, backward, stick, apart };

/// What is known of a motion so far.
struct Shown {
  bool stick = false, backslip = false;
  /// The longest time in which no cell remembered anything, and its middle.
  double clear = 0, clear_at = 0;
};

class RimMotion {
 public:
  /// velocity: of the drive, in units of the contact. Both are kept by reference. whole: of which
  /// its effort is a part, none without. Whatever
  /// happens, all cells slide forward while `always_slides`.
  RimMotion(const ScaledContact& contact, const ScaledHolder& holder, double velocity,
            double tolerance, SharedEffort* whole, bool always_slides = false);

  /// Numbers of the body alone: by how much it is slower than the drive, if it has a mass, and the
  /// forces of springs, one by one.
  Eigen::Index size() const { return body_; }
  /// A body without mass and damper feels the friction at once. The force of its first spring is
  /// what the others do not take, and no number of its own: it stays as it is.
  bool first_given() const { return holder_.mass == 0 && holder_.damper == 0; }

  /// By which the body's numbers have to be multiplied for the sum of their squares to be twice the
  /// energy: its period leads numbers closer together in this measure, or leaves them.
  Eigen::VectorXd energy_weights() const;

  /// All touching cells slide forward, and none remembers anything.
  void start(double t, const StateVector& body);
  void run(double until);

  StateVector body() const { return state_.head(body_); }
  double impulse() const { return state_(impulse_); }  ///< the integral of friction since start()
  double lack() const { return state_(lack_); }  ///< of friction, less than that of sliding cells
  double travel() const { return state_(place_); }  ///< of the body since then
  bool clear() const {
    return layers_.empty() && mode_ != RimMode::stick && mode_ != RimMode::backward;
  }
  const Shown& shown() const { return shown_; }
  void show_anew() { shown_ = {}; }

  /// Of the body, at a time of a step.
  double speed(double t, const TimeStep& step) const {
    return holder_.mass > 0 ? velocity_ - step.with_rate(t, 0).value
                            : speed(contact_.at(t), step.at(t));
  }
  /// Those of a motion that always slides, from start() on.
  const std::vector<TimeStep>& kept() const { return kept_; }

 private:
  /// Cells that touched at a time: where the body and the surface were.
  struct Touched {
    double t = 0, place = 0, depth = 0;
    double level(int d) const { return place - d * depth; }
  };

  // Cells from one depth to another, by what they remember: the level at which all of them stuck,
  // after a slide in a direction; or each its own, since they touched one after the other.
  struct Layer {
    int frozen = 0;  // direction; 0: touched one after the other
    double level = 0;
    double from = 0, to = 0;        // depths
    Touched first = {}, last = {};  // of cells, once all have touched
  };

  using Moment = ScaledContact::Moment;

  /// Only a body that feels the friction at once asks what sticks.
  double speed(const Moment& now, const StateVector& state) const {
    return velocity_ - behind(now, state, first_given() ? sticking(now, state) : 0);
  }
  double behind(const Moment& now, const StateVector& state, double stuck) const;
  int direction() const;
  double level(const Moment& now, double place, int d) const { return place - d * now.depth; }
  TimeStep::WithRate place_at(double t) const;
  Touched touched_at(double t) const { return {t, place_at(t).value, contact_.depth(t)}; }
  double inner_level(const Layer& layer, int d) const;
  double touched_when(const Layer& layer, double level, int d) const;
  double stuck_to(const Moment& now, double place) const;
  double sticking(const Moment& now, const StateVector& state) const;
  const Moment& moment(double t);
  double holding_force(const StateVector& state) const;
  void rates(double t, const StateVector& state, StateVector& out);

  using Margins = boost::container::static_vector<double, 3>;
  Margins margins(double t, const StateVector& state) const;
  double least_margin(double t, const StateVector& state) const;
  bool ends_in(const TimeStep& step, double& at) const;
  void take(TimeStep step, bool ends);
  void change();
  void cut_layer(int d);
  void go_on(RimMode mode);
  void pass_kink();
  void now_clear();
  void clear_no_longer();
  double next_kink() const;

  const ScaledContact& contact_;
  const ScaledHolder& holder_;
  double velocity_;
  bool always_slides_;
  Eigen::Index body_, spring_, branches_, place_, lack_, impulse_;

  double t_ = 0;
  StateVector state_;
  RimMode mode_ = RimMode::forward;
  std::vector<Layer> layers_;      ///< from the centre outwards
  std::vector<TimeStep> history_;  ///< of times at which cells touched and stuck
  std::vector<TimeStep> kept_;
  /// Of stuck_to(), the last one while layers stay as they are: rates and margins ask again.
  struct Answer {
    double t = -infinity, place = 0, depth = 0, when = -infinity;
  };
  mutable Answer touched_;
  /// Of rates(), the last ones: a step asks for the same times again and again.
  std::array<Moment, TimeStep::nodes + 1> moments_;
  std::size_t oldest_ = 0;
  double clear_since_ = 0;
  Shown shown_;
  int at_once_ = 0;  ///< events since time last went on
  Collocation steps_;
};

}  // namespace vcrit::indenter
