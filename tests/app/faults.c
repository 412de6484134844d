// Preloaded into a program, makes its FAULT_AT-th change of a file (a write, a rename, counted from
// one) go wrong: with FAULT=kill the process is killed before it, with FAULT=full the disk has no
// room from then on. With FAULT_IN=FOLDER only changes below that folder count.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

static int refused(void) {
  static atomic_long changes;
  const char *fault = getenv("FAULT"), *at = getenv("FAULT_AT");
  if (fault == NULL || at == NULL || atomic_fetch_add(&changes, 1) + 1 < atol(at)) return 0;
  if (strcmp(fault, "kill") == 0) raise(SIGKILL);
  errno = ENOSPC;
  return 1;
}

static int counts(const char* path) {
  const char* folder = getenv("FAULT_IN");
  return folder == NULL || strncmp(path, folder, strlen(folder)) == 0;
}

static int is_file(int descriptor) {
  struct stat status;
  if (fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) return 0;
  char link[64], path[4096] = "";
  snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  return readlink(link, path, sizeof path - 1) > 0 && counts(path);
}

#define NEXT(name) ((__typeof__(&(name)))dlsym(RTLD_NEXT, #name))

ssize_t write(int file, const void* bytes, size_t size) {
  return is_file(file) && refused() ? -1 : NEXT(write)(file, bytes, size);
}

ssize_t writev(int file, const struct iovec* parts, int number) {
  return is_file(file) && refused() ? -1 : NEXT(writev)(file, parts, number);
}

ssize_t pwrite(int file, const void* bytes, size_t size, off_t offset) {
  return is_file(file) && refused() ? -1 : NEXT(pwrite)(file, bytes, size, offset);
}

ssize_t pwritev(int file, const struct iovec* parts, int number, off_t offset) {
  return is_file(file) && refused() ? -1 : NEXT(pwritev)(file, parts, number, offset);
}

int rename(const char* from, const char* to) {
  return counts(to) && refused() ? -1 : NEXT(rename)(from, to);
}
