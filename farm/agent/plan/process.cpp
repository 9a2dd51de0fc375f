#include "farm/agent/plan/process.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace farm::agent {
namespace {

/// Before a program is started again that has ended @p failures times in a row.
std::chrono::seconds pause_after(unsigned failures) noexcept {
  constexpr unsigned kMostDoublings = 8;
  return std::min(kFirstPause * (1U << std::min(failures - 1, kMostDoublings)), kLongestPause);
}

}  // namespace

void Process::on_started(canopen::TimePoint now) {
  state_ = State::On;
  since_ = now;
  problem_.clear();
}

void Process::on_ended(const std::string& why, canopen::TimePoint now) {
  const State before = std::exchange(state_, State::Off);
  if (before == State::Stopping || before == State::Off) return forgive();
  if (before == State::On) ++restarts_;
  if (before == State::On && now - since_ >= kGoodRun) failures_ = 0;
  const auto pause = pause_after(++failures_);
  again_ = now + pause;
  problem_ = fmt::format("{}; it is started again after {} s", why, pause.count());
}

void Process::forgive() noexcept {
  failures_ = 0;
  again_ = {};
  problem_.clear();
}

}  // namespace farm::agent
