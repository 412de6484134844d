// Preloaded into a program, kills it before the KILLED_AT-th of its writes to files and renames (counted
// from one), as SIGKILL could at any moment.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/types.h>
#include <sys/uio.h>

static void count(void) {
  static atomic_long writes;
  const char* killed_at = getenv("KILLED_AT");
  if (killed_at != NULL && atomic_fetch_add(&writes, 1) + 1 == atol(killed_at)) raise(SIGKILL);
}

#define NEXT(name) ((__typeof__(&(name)))dlsym(RTLD_NEXT, #name))

ssize_t write(int file, const void* bytes, size_t size) {
  if (file > 2) count();
  return NEXT(write)(file, bytes, size);
}

ssize_t writev(int file, const struct iovec* parts, int number) {
  if (file > 2) count();
  return NEXT(writev)(file, parts, number);
}

ssize_t pwrite(int file, const void* bytes, size_t size, off_t offset) {
  count();
  return NEXT(pwrite)(file, bytes, size, offset);
}

int rename(const char* from, const char* to) {
  count();
  return NEXT(rename)(from, to);
}
