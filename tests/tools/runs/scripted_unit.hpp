#pragma once

#include <deque>
#include <vector>

#include "tools/axisctl/runs/replay/master_side.hpp"
#include "tools/canopen-check/core/wire.hpp"

namespace runs_test {

/// A bus in told time with a unit that says what it says in a log: behind each frame of the master what stands
/// behind that in the log, as much later.
class ScriptedUnit final : public conformance::Wire {
 public:
  /// @p log: of node 5.
  explicit ScriptedUnit(runs::LogReader& log) {
    runs::Nodes nodes;
    nodes.set(5);
    runs::MasterSide side{nodes, {}};
    std::chrono::nanoseconds last{};
    while (const auto logged = log.next().value()) {
      if (side.judge(*logged).side == runs::Side::Master) {
        answers_.emplace_back();
        last = logged->at;
      } else if (!answers_.empty()) {
        answers_.back().push_back({.time = canopen::TimePoint{logged->at - last}, .frame = logged->frame});
      }
    }
  }

  bool send(const canopen::Frame& frame) override {
    if (!is_up || frame.id == refused) return false;
    sent.push_back({.time = now_, .frame = frame, .sent = true});
    if (sent.size() == down_after) is_up = false;
    if (sent.size() > answers_.size()) return true;
    for (const conformance::TimedFrame& answer : answers_[sent.size() - 1])
      waiting_.push_back({.time = now_ + answer.time.time_since_epoch(), .frame = answer.frame});
    return true;
  }
  std::optional<conformance::TimedFrame> receive(canopen::TimePoint until) override {
    if (!is_up || waiting_.empty() || waiting_.front().time > std::max(until, now_)) {
      now_ = std::max(now_, until);
      return std::nullopt;
    }
    const conformance::TimedFrame frame = waiting_.front();
    waiting_.pop_front();
    now_ = std::max(now_, frame.time);
    return frame;
  }
  canopen::TimePoint now() override { return now_; }
  bool up() const override { return is_up; }
  bool interrupted() const override { return sent.size() >= interrupted_after; }

  /// Frames of the master, with when they came.
  std::vector<conformance::TimedFrame> sent;
  std::size_t down_after = 0, interrupted_after = static_cast<std::size_t>(-1);
  std::uint32_t refused = 0xFFFFFFFF;
  bool is_up = true;

 private:
  canopen::TimePoint now_{std::chrono::hours{1}};
  std::vector<std::vector<conformance::TimedFrame>> answers_;
  std::deque<conformance::TimedFrame> waiting_;
};

}  // namespace runs_test
