// Of what kinds a scene is, as far as that decides which questions have an answer; it may be of
// several at once. Those from no_static_load to sinking_opening are seen by their values.
#pragma once

#include <optional>

#include "problem/problem.hpp"

namespace vcrit::rules {

enum class SceneKind {
  measured_drive,                 ///< known at the frequencies of its table
  masses_in_drive,                ///< beside the one body
  lossy_spring,                   ///< k (1 + i eta): known at one frequency at a time
  indenter,                       ///< many contacts, each with a motion of its own
  no_indenter,                    ///< one contact
  separating,                     ///< the contact may open
  separating_without_memory,      ///< v* is Eq. 24 while it is closed where the indentation rises
                                  ///< fastest
  separating_with_memory,         ///< v* is Eq. 24 while it never opens
  no_static_load,                 ///< K_n(0) = 0
  no_static_load_below_indenter,  ///< E(0) = 0
  no_friction,                    ///< mu0 = 0
  no_indentation,                 ///< u_z0 = 0 where a spring would carry a load
  tapping,                        ///< the same of a contact that may open, and close for a while
  never_closing,                  ///< u_z0 = du_z = 0
  amplitude_too_large,            ///< (3): du_z >= u_z0 of a contact that must not open
  deep_amplitude,                 ///< the same of a contact that may
  opening,                        ///< (4) broken by a contact that must not open
  opening_below_indenter,         ///< (4) at the centre, likewise
  opening_with_memory,            ///< a contact that opens, so that v* is another one
  open_where_steepest,            ///< likewise, since it is open where u_z rises fastest
  sinking,                        ///< K_n(0) = 0 under a load: sinks, as deep as time goes on
  sinking_opening,                ///< the same of a contact that opens
  mount,                          ///< the vibrator presses through a network that gives
  separating_mount,               ///< the contact may open, below a mount; no load says how deep
  separating_with_mass,           ///< the same under any load, and a mass moves with the contact
  indenter_on_drive,  ///< on a drive that gives, through which its cells move one another
  viscoelastic_indenter_on_drive,  ///< the same, whose cells are not alike and have a memory
  measured_contact,                ///< known at the frequencies of its table
};
inline constexpr std::size_t kinds = static_cast<std::size_t>(SceneKind::measured_contact) + 1;

/// "measured_drive": a name that stays the same, for programs.
const char* name_of(SceneKind kind);

/// What a scene is, each thing found when it is first asked for.
class Facts {
 public:
  explicit Facts(const Problem& problem) : problem_(problem) {}

  /// Throws InputError where that needs values that are missing, ModelError where the motion of the
  /// contact would have to be known and is not.
  bool is(SceneKind kind) const;

  const Problem& problem() const { return problem_; }
  /// Of the contact as if closed, N: mean and amplitude of the normal force. Below an indenter
  /// they are pressures at its centre, Pa m.
  long double mean_force() const;
  long double oscillating_force() const;
  /// u_z0 of the contact as if closed, of an indenter as it is, m; infinite where it sinks.
  double indentation() const;
  double value(const Quantity& quantity) const { return problem_.value(quantity); }
  /// Whether the normal force would pull for a part of the period; below an indenter the pressure
  /// at its centre.
  bool opens() const { return oscillating_force() > mean_force(); }
  /// Whether the contact opens in each period of a scene that lets it.
  bool loses_contact() const { return is(SceneKind::separating) && opens(); }
  /// Whether u_z0 falls as the amplitude grows, since the rim of an indenter that a load presses
  /// opens and does not pull.
  bool depth_falls_with_amplitude() const;

 private:
  long double static_stiffness() const;
  bool sinks() const;
  bool open_where_steepest() const;

  Problem problem_;
  mutable std::optional<long double> static_stiffness_, oscillating_;
};

/// Whether the cells of a half-space move below an indenter, not one contact.
bool cells_move(const Problem& problem);
/// The same on a drive that gives, through which they move one another.
bool cells_move_one_another(const Problem& problem);
/// Whether a load is the mean force of the contact. Below an indenter it presses the cells by way
/// of their depth.
bool load_is_mean_force(const Problem& problem);
/// Whether springs and masses cancel inside the drive, so that its stiffness is 0 or infinite at
/// frequencies of its own.
bool drive_resonates(const Problem& problem);
/// Whether some motion that is asked for has a contact that opens: that of a scene that lets it, or
/// of cells at the edge of an indenter.
bool may_open(const Problem& problem);

}  // namespace vcrit::rules
