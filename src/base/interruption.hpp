// How long computations can be ended from outside, by Ctrl-C in Python: they ask now and then, at
// places that take no more than some 10 ms in between.
#pragma once

namespace vcrit {

/// Asks whether to go on, and throws if not.
using Interruption = void (*)();

/// Of this thread, null where nobody interrupts. Threads that a computation starts have none.
inline thread_local Interruption interruption = nullptr;

/// Sets it for a scope.
class Interruptible {
 public:
  explicit Interruptible(Interruption asked) : before_(interruption) { interruption = asked; }
  ~Interruptible() { interruption = before_; }
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;

 private:
  Interruption before_;
};

/// Nanoseconds, unless something waits to be heard.
inline void hear_interruption() {
  if (interruption != nullptr) interruption();
}

}  // namespace vcrit
