#include "tools/axisctl/runs/replay/replay.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace runs {
namespace {

/// True for what the unit sends only because it was asked: the next frame of the master is not before it.
bool is_answer(const canopen::Frame& frame, const meaning::Meaning& meaning) noexcept {
  const bool is_boot_up = meaning.role == meaning::Role::ErrorControl && frame.length == 1 && frame.data[0] == 0;
  return is_boot_up || meaning.role == meaning::Role::SdoResponse;
}

}  // namespace

Expected<void> Replay::play(LogReader& log) {
  for (;;) {
    const auto logged = log.next();
    if (!logged) return tl::unexpected{logged.error()};
    if (!*logged) break;
    log_.has_times = run_.has_times = log.has_times();
    const MasterSide::Judgement judgement = side_.judge(**logged);
    if (judgement.side == Side::Other) ++figures_.left_out;
    if (judgement.side == Side::Master)
      if (auto done = present(**logged, judgement); !done) return done;
    if (judgement.side == Side::Other || !has_begun_) continue;
    last_ = std::max(last_, (*logged)->at);
    const bool is_of_master = judgement.side == Side::Master;
    if (!is_of_master && is_answer((*logged)->frame, judgement.meaning)) {
      ++owed_[judgement.meaning];
      ++figures_.answers;
    }
    if (options_.keeps_courses)
      log_.passages.push_back({.at = (*logged)->at - first_,
                               .frame = (*logged)->frame,
                               .meaning = judgement.meaning,
                               .is_of_master = is_of_master,
                               .place = (*logged)->place,
                               .entry = judgement.entry});
  }
  if (!has_begun_)
    return fail(ExitStatus::Damaged,
                fmt::format("{}: there is no frame of a master of this unit in it", log.path()));
  if (auto done = await_answers(); !done) return done;
  if (auto done = pass(std::max(due(last_), wire_.now()) + options_.rest); !done) return done;
  figures_.late = begin_ - begun_;
  figures_.length = wire_.now() - begun_;
  return {};
}

canopen::TimePoint Replay::due(std::chrono::nanoseconds at) const noexcept {
  const std::chrono::duration<double, std::nano> behind{static_cast<double>((at - first_).count()) /
                                                        options_.speed};
  return begin_ + std::chrono::duration_cast<canopen::Duration>(behind);
}

Expected<void> Replay::present(const LoggedFrame& logged, const MasterSide::Judgement& judgement) {
  if (!has_begun_) {
    has_begun_ = true;
    first_ = last_ = logged.at;
    begin_ = begun_ = wire_.now();
  }
  if (auto done = await_answers(); !done) return done;
  // A time stamp that goes back does not make the frames before it late.
  const canopen::TimePoint when = due(std::max(logged.at, last_));
  if (auto done = pass(when); !done) return done;
  if (!wire_.send(logged.frame)) {
    if (auto up = state(); !up) return up;
    ++figures_.refused;
  }
  const canopen::TimePoint now = wire_.now();
  if (options_.keeps_courses)
    run_.passages.push_back({.at = now - begun_,
                             .frame = logged.frame,
                             .meaning = judgement.meaning,
                             .is_of_master = true,
                             .place = logged.place});
  (void)heard_.judge(logged);
  ++figures_.sent;
  return {};
}

Expected<void> Replay::await_answers() {
  const canopen::TimePoint before = wire_.now();
  for (auto& [who, owed] : owed_) {
    std::uint64_t& given = given_[who];
    const canopen::TimePoint until = wire_.now() + options_.patience;
    while (given < owed && wire_.now() < until) {
      if (const auto frame = wire_.receive(until)) hear(*frame);
      if (auto done = state(); !done) return done;
    }
    if (given >= owed) continue;
    figures_.unanswered += owed - given;
    given = owed;
  }
  // What the unit was late, all that follows is, so that no frame comes closer behind another than in the log.
  const canopen::TimePoint now = wire_.now();
  if (now > before) begin_ += std::max(canopen::Duration::zero(), now - std::max(before, due(last_)));
  return {};
}

Expected<void> Replay::pass(canopen::TimePoint until) {
  for (;;) {
    const auto frame = wire_.receive(until);
    if (frame) hear(*frame);
    if (auto done = state(); !done) return done;
    if (!frame && wire_.now() >= until) return {};
  }
}

void Replay::hear(const conformance::TimedFrame& frame) {
  LoggedFrame heard{.frame = frame.frame};
  const MasterSide::Judgement judgement = heard_.judge(heard);
  if (is_answer(frame.frame, judgement.meaning)) ++given_[judgement.meaning];
  if (!options_.keeps_courses || judgement.side != Side::Unit) return;
  run_.passages.push_back(
      {.at = frame.time - begun_, .frame = frame.frame, .meaning = judgement.meaning, .entry = judgement.entry});
}

Expected<void> Replay::state() const {
  if (!wire_.up())
    return fail(ExitStatus::CutOff, fmt::format("the bus is down, {} frames had been sent", figures_.sent));
  if (wire_.interrupted())
    return fail(ExitStatus::Failed, fmt::format("interrupted, {} frames had been sent", figures_.sent));
  return {};
}

}  // namespace runs
