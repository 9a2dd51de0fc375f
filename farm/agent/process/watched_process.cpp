#include "farm/agent/process/watched_process.hpp"

#include <chrono>
#include <csignal>
#include <utility>

#include <fmt/format.h>
#include <sys/epoll.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace farm::agent {
namespace {

/// A unit writes what it keeps to the disk before it ends.
constexpr std::chrono::seconds kLongestStop{3};

}  // namespace

WatchedProcess::WatchedProcess(axisd::ServiceEvents& events, ProcessHandle process, OnEnd on_end)
    : events_{events}, process_{std::move(process)}, on_end_{std::move(on_end)} {
  source_ = events_.watch(
      process_.descriptor.get(), EPOLLIN,
      [](sd_event_source*, int, std::uint32_t, void* self) noexcept {
        auto& it = *static_cast<WatchedProcess*>(self);
        it.source_.reset();
        const OnEnd tell = std::move(it.on_end_);
        tell(it.reap());
        return 0;
      },
      this);
}

void WatchedProcess::end() {
  send(SIGTERM);
  patience_ = events_.timer(
      [](sd_event_source*, std::uint64_t, void* self) noexcept {
        static_cast<WatchedProcess*>(self)->send(SIGKILL);
        return 0;
      },
      this);
  axisd::ServiceEvents::start(patience_, kLongestStop);
}

void WatchedProcess::send(int signal) const noexcept {
  ::syscall(SYS_pidfd_send_signal, process_.descriptor.get(), signal, nullptr, 0);
}

/// What the kernel tells of a child alone.
ProcessEnd WatchedProcess::reap() const {
  siginfo_t end{};
  const auto descriptor = static_cast<id_t>(process_.descriptor.get());
  if (::waitid(P_PIDFD, descriptor, &end, WEXITED | WNOHANG) != 0 || end.si_pid == 0)
    return {.is_good = false, .how = "has ended"};
  if (end.si_code != CLD_EXITED)
    return {.is_good = false, .how = fmt::format("was ended by signal {}", end.si_status)};
  return {.is_good = end.si_status == 0, .how = fmt::format("has ended with status {}", end.si_status)};
}

}  // namespace farm::agent
