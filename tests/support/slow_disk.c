/* Preloaded into a program, it makes a slow disk: fsync(2) returns when the file named by SLOW_DISK_GATE is there.
 */
#include <stdlib.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

int fsync(int descriptor) {
  const char* const gate = getenv("SLOW_DISK_GATE");
  const struct timespec moment = {0, 1000000};
  while (gate != NULL && access(gate, F_OK) != 0) nanosleep(&moment, NULL);
  return (int)syscall(SYS_fsync, descriptor);
}
