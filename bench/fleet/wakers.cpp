// The floor of many processes with a cycle each: wakers PROCESSES MILLISECONDS SECONDS. So many processes wake
// once in every cycle, by a timer as the daemon has one, and do nothing. Prints the share of one processor that
// they take (%).
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <span>
#include <vector>

#include <poll.h>
#include <sys/resource.h>
#include <sys/timerfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/number.hpp"

namespace {

constexpr long kNsOfMs = 1'000'000;

/// Wakes until @p seconds are over.
void wake(long milliseconds, int seconds) {
  const int timer = timerfd_create(CLOCK_MONOTONIC, 0);
  if (timer < 0) _exit(1);
  const itimerspec period{{0, milliseconds * kNsOfMs}, {0, milliseconds * kNsOfMs}};
  timerfd_settime(timer, 0, &period, nullptr);
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{seconds};
  while (std::chrono::steady_clock::now() < end) {
    pollfd readable{timer, POLLIN, 0};
    poll(&readable, 1, -1);
    std::uint64_t expirations = 0;
    if (read(timer, &expirations, sizeof expirations) < 0) _exit(1);
  }
}

double processor_seconds_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

int main(int argc, char** argv) {
  const std::span words{argv, static_cast<std::size_t>(argc)};
  int processes = 0;
  int seconds = 0;
  long milliseconds = 0;
  if (argc != 4 || !bench::parse(words[1], 1, 10000, processes) ||
      !bench::parse(words[2], 1L, 999L, milliseconds) || !bench::parse(words[3], 1, 3600, seconds)) {
    std::fputs("usage: wakers PROCESSES (1..10000) MILLISECONDS (1..999) SECONDS (1..3600)\n", stderr);
    return 2;
  }
  std::vector<pid_t> children;
  for (int i = 0; i < processes; ++i) {
    const pid_t child = fork();
    if (child < 0) {
      std::perror("wakers: fork");
      for (const pid_t other : children) kill(other, SIGKILL);
      return 1;
    }
    if (child == 0) {
      wake(milliseconds, seconds);
      _exit(0);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) waitpid(child, nullptr, 0);
  std::printf("%.1f\n", 100.0 * processor_seconds_of_children() / seconds);
  return 0;
}
