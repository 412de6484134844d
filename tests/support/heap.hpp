// How often a program takes memory from the heap. Linked with heap.cpp, every malloc and its kin
// of the whole program is counted, and so every new, those of libraries too.
#pragma once

namespace vcrit::test {

/// So far.
long heap_requests();

/// While work() ran.
template <class Work>
long heap_requests(const Work& work) {
  const long before = heap_requests();
  work();
  return heap_requests() - before;
}

}  // namespace vcrit::test
