/* Beneath newlib, in place of a board: start, end, read and write as system calls of Linux on ARM,
   which qemu-arm answers. Compiled as Thumb. */
#include <stddef.h>
#include <sys/types.h>

static long call(long number, long a, long b, long c) {
  register long r0 __asm__("r0") = a;
  register long r1 __asm__("r1") = b;
  register long r2 __asm__("r2") = c;
  long saved;
  /* r7 has the number; it may be the frame pointer of Thumb code. */
  __asm__ volatile("mov %1, r7\n mov r7, %5\n svc 0\n mov r7, %1"
                   : "+r"(r0), "=&r"(saved)
                   : "0"(r0), "r"(r1), "r"(r2), "r"(number)
                   : "memory");
  return r0;
}

int main(void);
void* __dso_handle; /* of C++: what destroys statics; there are none */

ssize_t read(int file, void* to, size_t size) { return call(3, file, (long)to, (long)size); }
ssize_t write(int file, const void* from, size_t size) {
  return call(4, file, (long)from, (long)size);
}

void _start(void) {
  call(1, main(), 0, 0);
  for (;;) {
  }
}
