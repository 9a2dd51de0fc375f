#include <array>
#include <cstring>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/can/preload/conformance/can_socket.hpp"

namespace conformance {
namespace {

int exit_status_of(pid_t child) {
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Runs `sh -c SCRIPT` in a new process, with descriptor @p descriptor open in it; its exit status.
int run_shell(const std::string& script) {
  const pid_t child = fork();
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", script.c_str(), nullptr);
    _exit(127);
  }
  return exit_status_of(child);
}

TEST(Sharing, ADuplicateIsTheSameSocket) {
  const CanSocket sender, receiver;
  const int copy = dup(receiver.fd());
  can_frame received{};
  ASSERT_EQ(receiver.set(SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, 1), 0);
  int own = 0;
  socklen_t size = sizeof own;

  EXPECT_EQ(getsockopt(copy, SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, &own, &size), 0);
  EXPECT_EQ(own, 1);
  ASSERT_EQ(sender.send(frame(0x101)), 0);
  ASSERT_EQ(sender.send(frame(0x102)), 0);

  EXPECT_EQ(read(copy, &received, sizeof received), 16);
  EXPECT_EQ(received.can_id, 0x101u);
  EXPECT_EQ(receiver.receive_id(), 0x102u);
  close(copy);
}

TEST(Sharing, AForkedProcessGoesOn) {
  const CanSocket socket, other;
  const pid_t child = fork();
  if (child == 0) {
    const bool fine = socket.receive_id() == 0x101 && socket.send(frame(0x102)) == 0;
    _exit(fine ? 0 : 1);
  }

  ASSERT_EQ(other.send(frame(0x101)), 0);

  EXPECT_EQ(exit_status_of(child), 0);
  EXPECT_EQ(other.receive_id(), 0x102u);
}

TEST(Sharing, AnExecutedProgramInheritsIt) {
  const CanSocket socket, other;
  const std::string script = "exec cat <&" + std::to_string(socket.fd()) + " | head -c 16 | wc -c | grep -qw 16";
  const pid_t child = fork();
  if (child == 0) {
    execl("/bin/sh", "sh", "-c", script.c_str(), nullptr);
    _exit(127);
  }

  // a frame each until the program has its sixteen bytes and meets a pipe nobody reads
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    ASSERT_EQ(other.send(frame(0x101)), 0);
    usleep(1000);
  }

  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}

TEST(Sharing, AnExecutedProgramSendsOnIt) {
  const CanSocket socket, other;

  EXPECT_EQ(run_shell("printf '\\1\\1\\0\\0\\2\\0\\0\\0AB\\0\\0\\0\\0\\0\\0' >&" + std::to_string(socket.fd())),
            0);

  const auto received = other.receive();
  ASSERT_TRUE(received.has_value());
  EXPECT_EQ(received->can_id, 0x101u);
  EXPECT_EQ(received->data[1], 'B');
}

TEST(Sharing, IsNotWithAnExecutedProgramIfClosedOnExec) {
  const CanSocket socket{SOCK_RAW | SOCK_CLOEXEC, CAN_RAW};

  EXPECT_NE(run_shell("true 2>/dev/null <&" + std::to_string(socket.fd())), 0);
}

TEST(Sharing, ADescriptorCanBePassedOn) {
  std::array<int, 2> ends{};
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0);
  const CanSocket other;
  {
    const CanSocket passed;
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
    char letter = 'x';
    iovec part{&letter, 1};
    msghdr message{nullptr, 0, &part, 1, control.data(), control.size(), 0};
    cmsghdr* const header = CMSG_FIRSTHDR(&message);
    *header = {.cmsg_len = CMSG_LEN(sizeof(int)), .cmsg_level = SOL_SOCKET, .cmsg_type = SCM_RIGHTS};
    const int descriptor = passed.fd();
    std::memcpy(CMSG_DATA(header), &descriptor, sizeof descriptor);
    ASSERT_EQ(sendmsg(ends[0], &message, 0), 1);
  }
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  char letter = 0;
  iovec part{&letter, 1};
  msghdr message{nullptr, 0, &part, 1, control.data(), control.size(), 0};
  ASSERT_EQ(recvmsg(ends[1], &message, 0), 1);
  int arrived = -1;
  std::memcpy(&arrived, CMSG_DATA(CMSG_FIRSTHDR(&message)), sizeof arrived);
  ASSERT_EQ(other.send(frame(0x101)), 0);
  std::array<char, 64> room{};

  EXPECT_EQ(read(arrived, room.data(), room.size()), 16);

  for (const int descriptor : {arrived, ends[0], ends[1]}) close(descriptor);
}

TEST(Sharing, ThreadsSendOnOneSocket) {
  constexpr int kThreads = 4, kFrames = 50;
  const CanSocket sender, receiver;
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t)
    threads.emplace_back([&sender, t] {
      for (int i = 0; i < kFrames; ++i)
        EXPECT_EQ(sender.send(frame(static_cast<canid_t>(0x100 + t), {static_cast<std::uint8_t>(i)})), 0);
    });
  for (std::thread& thread : threads) thread.join();

  std::map<canid_t, int> next;
  for (int i = 0; i < kThreads * kFrames; ++i) {
    const auto received = receiver.receive();
    ASSERT_TRUE(received.has_value());
    EXPECT_EQ(received->data[0], next[received->can_id]++);  // in order, each thread's
  }
  EXPECT_EQ(next.size(), static_cast<std::size_t>(kThreads));
}

TEST(Sharing, OneThreadReadsWhileAnotherSetsOptions) {
  const CanSocket sender, receiver;
  canid_t received = 0;
  std::thread reader{[&] { received = receiver.receive_id(); }};

  for (int i = 0; i < 20; ++i) ASSERT_EQ(receiver.set(SOL_CAN_RAW, CAN_RAW_RECV_OWN_MSGS, i % 2), 0);
  ASSERT_EQ(receiver.set_filters({{.can_id = 0x102, .can_mask = CAN_SFF_MASK}}), 0);
  ASSERT_EQ(sender.send(frame(0x101)), 0);
  ASSERT_EQ(sender.send(frame(0x102)), 0);
  reader.join();

  EXPECT_EQ(received, 0x102u);
}

}  // namespace
}  // namespace conformance
