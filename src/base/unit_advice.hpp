// What was probably meant by a text that should have been a number with a unit: the end of a
// message.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/units.hpp"

namespace vcrit {

/// The known units nearest to one that is unknown: those that differ in capitals, or in dots and
/// signs of multiplication ("Ns/m"), else those one letter away. At most two; none where none is
/// near.
std::vector<std::string> nearest_units(std::string_view unit, Dimension dimension);

/// "did you mean "28 kHz"?" of the number 28 and the unknown unit khz; empty where no unit is near.
std::string advice_on_unknown_unit(std::string_view number, std::string_view unit,
                                   Dimension dimension);

/// What stands before "pp", "p-p", "peak to peak"; empty where the unit does not end so.
std::string_view before_peak_to_peak(std::string_view unit);

/// The same of "rms".
std::string_view before_root_mean_square(std::string_view unit);

/// The same of "peak", "0-pk".
std::string_view before_peak(std::string_view unit);

/// Whether udunits knows the unit, but as another than people who write it: "gr" is the grain to
/// it.
bool is_mistaken_unit(std::string_view unit);

/// How to write "0" and ",2 um" of "0,2 um", which has a decimal comma or one between thousands.
std::string advice_on_comma(std::string_view number, std::string_view rest);

/// How to write "8" and "000 N/mm" or "'000 N/mm": without what separates thousands. Empty of
/// others.
std::string advice_on_thousands(std::string_view number, std::string_view rest);

/// Whether the text has a minus sign or dash of a typesetter's, as texts copied from pages do.
bool has_typeset_minus(std::string_view text);

}  // namespace vcrit
