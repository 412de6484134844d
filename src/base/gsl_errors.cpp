#include "base/gsl_errors.hpp"

#include <gsl/gsl_errno.h>

#include <mutex>

namespace vcrit {

namespace {

std::mutex handler_mutex;
int errors_off = 0;  // how many are alive
gsl_error_handler_t* host_handler = nullptr;

}  // namespace

GslErrorsOff::GslErrorsOff() {
  const std::lock_guard lock(handler_mutex);
  if (errors_off++ == 0) host_handler = gsl_set_error_handler_off();
}

GslErrorsOff::~GslErrorsOff() {
  const std::lock_guard lock(handler_mutex);
  if (--errors_off == 0) gsl_set_error_handler(host_handler);
}

}  // namespace vcrit
