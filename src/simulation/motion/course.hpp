// A cycle whose order of motions is known and whose events are known nearly. Nothing is searched
// for: each motion lasts as long as the course says, and by how much its event is missed is passed
// on as a change of its own. So one Newton step brings state and events to their place together.
#pragma once

#include <optional>

#include "simulation/motion/trace.hpp"

namespace vcrit::simulation {

struct Course {
  struct Leg {
    Motion motion;
    double duration;
  };
  State start;        ///< where a slip begins
  List<Leg, 8> legs;  ///< from there on; each ends in an event, the last where the slip begins anew
};

/// The course of a recorded period from the beginning of its longest slip on; nothing if it has
/// none or does not repeat itself.
std::optional<Course> course_of(const Trace& trace);

/// Changes are those of the state where the cycle begins and ends. Their columns: each number of
/// the state but F, the time of the beginning, and the shift of all events onto their zeros.
struct CoursePassage : Passage {
  Matrix shifts;  ///< of each event's time, one column an event
};
CoursePassage follow(const Model& model, double velocity, const Course& course);

}  // namespace vcrit::simulation
