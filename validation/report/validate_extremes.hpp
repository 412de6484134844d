// `vcrit validate --extremes`.
#pragma once

#include "report/extremes_record.hpp"
#include "report/validate.hpp"

namespace vcrit::validation::report {

/// Takes the built-in families of scenes to extremes and writes DIR/report.json and DIR/index.html
/// about it, and the figures. The request has no scenes. Throws InputError; then nothing is
/// written.
Validation validate_extremes(const Request& request, const Watch& watch);

/// The second half of it: the verdict and the files.
Validation report_extremes(const ExtremesContents& contents, const Request& request,
                           const Watch& watch);

}  // namespace vcrit::validation::report
