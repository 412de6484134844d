// One thread at a time in computer algebra. GiNaC counts the references to its expressions without
// atomics, and numbers like 0 and 1 are shared by all of them, so that even copies made by two
// threads must not meet.
#pragma once

#include <ginac/ginac.h>

#include <concepts>

namespace vcrit::symbolic {

/// Held by whoever works on expressions; the thread that has one may take more. All functions of
/// this library take one themselves. Needed only by code that works on GiNaC's own expressions, or
/// copies them out of an Expression, in more than one thread.
class AlgebraLock {
 public:
  AlgebraLock();
  ~AlgebraLock();
  AlgebraLock(const AlgebraLock&) = delete;
  AlgebraLock& operator=(const AlgebraLock&) = delete;
};

namespace guarded {

void lock();
void unlock();

/// Before and after the expression among the bases below: bases are made, copied and assigned from
/// the first to the last, and ended in the opposite order.
struct Before {
  Before() { lock(); }
  Before(const Before&) { lock(); }
  Before& operator=(const Before&) {
    lock();
    return *this;
  }
  ~Before() { unlock(); }
};

struct After {
  After() { unlock(); }
  After(const After&) { unlock(); }
  After& operator=(const After&) {
    unlock();
    return *this;
  }
  ~After() { lock(); }
};

}  // namespace guarded

/// An expression in a result of this library: copied, assigned and ended under an AlgebraLock.
class Expression : private guarded::Before, public GiNaC::ex, private guarded::After {
 public:
  Expression() = default;
  template <std::convertible_to<GiNaC::ex> From>
  Expression(const From& expression) : GiNaC::ex(expression) {}  // stands for it everywhere
};

}  // namespace vcrit::symbolic
