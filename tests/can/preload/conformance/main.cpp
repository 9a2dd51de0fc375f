// Checks that AF_CAN sockets do what those of the kernel do. The program knows nothing of any library: it is run
// on the kernel's own CAN, which says what is right, and on the user-space bus, which has to do the same.
#include <cstdio>

#include <gtest/gtest.h>
#include <linux/can.h>
#include <sys/socket.h>
#include <unistd.h>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const int probe = socket(AF_CAN, SOCK_RAW, CAN_RAW);
  if (probe < 0) {
    std::perror("no CAN sockets here");
    return 1;
  }
  close(probe);
  return RUN_ALL_TESTS();
}
