#include "base/gsl_errors.hpp"

#include <gsl/gsl_errno.h>

#include <mutex>

namespace vcrit {

namespace {

std::mutex mutex;
int alive = 0;
gsl_error_handler_t* host = nullptr;

}  // namespace

GslErrorsOff::GslErrorsOff() {
  const std::lock_guard lock(mutex);
  if (alive++ == 0) host = gsl_set_error_handler_off();
}

GslErrorsOff::~GslErrorsOff() {
  const std::lock_guard lock(mutex);
  if (--alive == 0) gsl_set_error_handler(host);
}

}  // namespace vcrit
