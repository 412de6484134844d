// GSL's error handler ends the program unless told otherwise; statuses are checked here instead.
#pragma once

namespace vcrit {

/// Off from the first of these alive, in any thread, to the last; then the host's handler again.
class GslErrorsOff {
 public:
  GslErrorsOff();
  ~GslErrorsOff();
  GslErrorsOff(const GslErrorsOff&) = delete;
  GslErrorsOff& operator=(const GslErrorsOff&) = delete;
};

}  // namespace vcrit
