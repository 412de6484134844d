#include "formula/algebra_lock.hpp"

#include <mutex>

namespace vcrit::symbolic {

namespace {

// Never destroyed: expressions in static objects of a program may end after those of this library.
std::recursive_mutex& algebra() {
  static auto* const mutex = new std::recursive_mutex;
  return *mutex;
}

}  // namespace

AlgebraLock::AlgebraLock() { guarded::lock(); }
AlgebraLock::~AlgebraLock() { guarded::unlock(); }

void guarded::lock() { algebra().lock(); }
void guarded::unlock() { algebra().unlock(); }

}  // namespace vcrit::symbolic
