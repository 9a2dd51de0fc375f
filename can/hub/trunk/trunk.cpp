#include "can/hub/trunk/trunk.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "can/hub/loop/clock.hpp"
#include "can/hub/trunk/report.hpp"

namespace hub::trunk {

namespace {

using canopen::TimePoint;

/// Messages that are taken before members have their turn.
constexpr int kBatch = 64;

}  // namespace

Trunk::Trunk(Medium& medium, std::unique_ptr<Stream> stream, Settings settings, OnLink on_link, Notice notice)
    : medium_{medium},
      stream_{std::move(stream)},
      settings_{std::move(settings)},
      on_link_{std::move(on_link)},
      notices_{settings_.url, std::move(notice)} {
  medium_.set_carrier(this);
  on_link_(false, monotonic_now());
}

Trunk::~Trunk() {
  medium_.set_carrier(nullptr);
}

void Trunk::on_readable(TimePoint now) noexcept {
  if (stood_still(now)) return cut("this hub was kept from running", now);
  const Stream::State state = stream_->advance();
  try {
    if (const std::string problem = stream_->take_problem(); !problem.empty()) notices_.tell(problem, now);
  } catch (const std::exception&) {  // no memory for a line
  }
  if (state == Stream::State::Lost) return cut("the connection is lost", now);
  if (state != Stream::State::Open) return;
  if (phase_ == Phase::Closed) join(now);
  read(now);
}

/// A hub that did not run for so long does not know what has passed meanwhile, nor how old is what members have
/// sent.
bool Trunk::stood_still(TimePoint now) noexcept {
  const TimePoint before = std::exchange(looked_, std::max(looked_, now));
  return phase_ != Phase::Closed && now - before > kPatience;
}

void Trunk::join(TimePoint now) noexcept {
  ++epoch_;
  phase_ = Phase::Joining;
  sequence_ = 0;
  seen_ = 0;
  returned_seen_ = 0;
  heard_ = now;
  looked_ = now;
  hubs_.forgive(now);
  beat(now);
}

void Trunk::come_up(TimePoint now) noexcept {
  phase_ = Phase::Up;
  is_failure_told_ = false;
  notices_.tell(epoch_ == 1 ? "joined" : "joined again", now);
  on_link_(true, now);
}

void Trunk::cut(std::string_view reason, TimePoint now) noexcept {
  if (std::exchange(phase_, Phase::Closed) == Phase::Up) {
    ++figures_.cuts;
    notices_.tell(fmt::format("cut: {}; {} frames were under way", reason, under_way_.count()), now);
    figures_.dropped += under_way_.count();
    under_way_.clear();
    writer_.begin({});
    on_link_(false, now);
  }
  is_unsent_ = false;
  has_more_ = false;
  stream_->reopen();
}

void Trunk::read(TimePoint now) noexcept {
  Stream::Message message;
  has_more_ = true;
  for (int i = 0; i < kBatch && has_more_; ++i) {
    has_more_ = phase_ != Phase::Closed && stream_->receive(message);
    if (has_more_) take_message(message, now);
  }
  if (phase_ == Phase::Up) medium_.go_on(now);
}

void Trunk::take_message(const Stream::Message& message, TimePoint now) noexcept {
  const std::uint64_t before = std::exchange(sequence_, message.sequence);
  if (before != 0 && message.sequence != before + 1)
    return cut(fmt::format("the stream went from message {} to {}", before, message.sequence), now);
  seen_ = message.time_ns;
  std::string_view problem;
  const auto reader = Reader::read(message.bytes, problem);
  if (!reader) {
    ++figures_.malformed;
    return notices_.tell(fmt::format("message {} {}", message.sequence, problem), now);
  }
  const Header& header = reader->header();
  const bool is_stale = is_late(header, message.time_ns);
  if (header.hub == medium_.number_of_hub())
    take_own(*reader, message, is_stale, now);
  else
    take_foreign(*reader, message, is_stale, now);
}

void Trunk::take_own(const Reader& reader, const Stream::Message& message, bool is_stale, TimePoint now) noexcept {
  if (reader.header().epoch != epoch_) return;  // counted when the wire was cut
  if (has_been_here(reader)) {
    figures_.repeated += reader.frames();
    return;
  }
  returned_seen_ = reader.header().seen;
  if (is_stale) return cut("messages reach the stream too late", now);
  heard_ = now;
  if (phase_ == Phase::Joining) come_up(now);
  const TimePoint clock = monotonic_now();
  for (std::size_t i = 0; i < reader.frames(); ++i) {
    if (under_way_.empty() || under_way_.first().counter != reader.header().counter + i)
      return cut("frames have come back in another order", now);
    Passage passage = under_way_.first().passage;
    passage.time_ns = message.time_ns;
    latency_.add(clock - under_way_.first().taken);
    under_way_.pop();
    ++figures_.sent;
    medium_.pass(passage, now);
  }
}

/// Somebody else sends what this hub has sent before.
bool Trunk::has_been_here(const Reader& reader) const noexcept {
  const Header& header = reader.header();
  if (header.kind == Kind::Beat) return header.seen < returned_seen_;
  const std::uint64_t next = under_way_.empty() ? counter_ : under_way_.first().counter;
  return header.counter + reader.frames() <= next;
}

void Trunk::take_foreign(const Reader& reader, const Stream::Message& message, bool is_stale,
                         TimePoint now) noexcept {
  if (hubs_.is_outdated(reader.header())) return;
  const Hubs::Outcome outcome = hubs_.note(reader.header(), reader.frames(), now);
  if (reader.header().kind == Kind::Beat) reader.name().copy(outcome.hub.name.data(), kLongestName);
  if (reader.header().kind == Kind::Beat || outcome.news == Hubs::News::Returned) tell_news(outcome, now);
  const std::size_t fresh = reader.frames() - outcome.repeated;
  if (is_stale) {
    figures_.stale += fresh;
  } else if (phase_ != Phase::Up) {
    hubs_.miss(outcome.hub, fresh);
  } else {
    for (std::size_t i = outcome.repeated; i < reader.frames(); ++i)
      if (pass(reader, i, message.time_ns, now)) ++outcome.hub.received;
  }
}

/// False if it is not for the members of this hub.
bool Trunk::pass(const Reader& reader, std::size_t number, std::int64_t time_ns, TimePoint now) noexcept {
  const MarkedFrame marked = reader.frame(number);
  if ((marked.frame.can_id & CAN_ERR_FLAG) != 0) return false;  // those of a hub stay on it
  if (!medium_.is_new({.hub = reader.header().origin, .number = marked.number})) {
    ++figures_.returned;
    return false;
  }
  ++figures_.received;
  Passage passage;
  passage.frame = marked.frame;
  passage.local = false;
  passage.time_ns = time_ns;
  passage.mark = {.hub = reader.header().origin, .number = marked.number};
  medium_.pass(passage, now);
  return true;
}

void Trunk::tell_news(const Hubs::Outcome& outcome, TimePoint now) noexcept {
  if (outcome.news == Hubs::News::Joined) notices_.tell(fmt::format("{} is on the bus", outcome.hub.text()), now);
  if (outcome.news == Hubs::News::Returned)
    notices_.tell(fmt::format("{} is on the bus again", outcome.hub.text()), now);
}

void Trunk::take(const Passage& passage, TimePoint now) noexcept {
  if (stood_still(now)) {
    ++counter_;  // the others miss it
    ++figures_.dropped;
    return cut("this hub was kept from running", now);
  }
  const bool is_begun = writer_.frames() > 0;
  if (is_begun && (writer_.header().origin != passage.mark.hub || writer_.frames() >= settings_.frames_a_message))
    finish_message();
  if (writer_.frames() == 0) writer_.begin(header(Kind::Frames, passage.mark.hub));
  writer_.add({passage.frame, passage.mark.number});
  under_way_.push({passage, counter_++, monotonic_now()});
}

Header Trunk::header(Kind kind, std::uint32_t origin) const noexcept {
  return {.kind = kind,
          .hub = medium_.number_of_hub(),
          .epoch = epoch_,
          .origin = origin,
          .counter = counter_,
          .seen = seen_};
}

void Trunk::publish(std::span<const std::byte> message) noexcept {
  stream_->publish(message);
  is_unsent_ = true;
}

void Trunk::finish_message() noexcept {
  if (writer_.frames() == 0) return;
  publish(writer_.finish());
  writer_.begin({});
}

void Trunk::flush() noexcept {
  if (std::exchange(is_unsent_, false)) stream_->flush();
}

void Trunk::beat(TimePoint now) noexcept {
  next_beat_ = now + kBeat;
  Writer writer;
  writer.begin(header(Kind::Beat, medium_.number_of_hub()));
  writer.add_name(settings_.name);
  publish(writer.finish());
}

TimePoint Trunk::next_deadline() const noexcept {
  if (writer_.frames() > 0 || is_unsent_ || has_more_) return TimePoint::min();
  if (phase_ == Phase::Closed) return notices_.due();
  return std::min({next_beat_, heard_ + kPatience + canopen::Duration{1}, notices_.due()});
}

void Trunk::on_time(TimePoint now) noexcept {
  notices_.on_time(now);
  if (phase_ == Phase::Closed) return;
  if (stood_still(now)) return cut("this hub was kept from running", now);
  if (has_more_) read(now);
  finish_message();
  flush();
  if (phase_ == Phase::Closed) return;
  if (now - heard_ > kPatience) return miss_own(now);
  if (now < next_beat_) return;
  beat(now);
  flush();
  while (const Neighbour* const gone = hubs_.take_gone(now))
    notices_.tell(fmt::format("{} is on the bus no more", gone->text()), now);
}

/// The way there and back is broken somewhere, even if others are heard.
void Trunk::miss_own(TimePoint now) noexcept {
  if (phase_ == Phase::Joining && !std::exchange(is_failure_told_, true))
    notices_.tell("nothing that this hub sends comes back: the server is full, or does not let it publish", now);
  cut("nothing has come back for 500 ms", now);
}

Identity Trunk::identity() const noexcept {
  Identity who;
  settings_.url.copy(who.name.data(), who.name.size() - 1);
  return who;
}

std::string Trunk::report(std::size_t room) const {
  return report_of(*this, medium_.lost(), room);
}

bool Trunk::statistics(userbus::MemberStatistics& row) const noexcept {
  row = {};
  settings_.url.copy(row.name, sizeof row.name - 1);
  row.sent = figures_.received;
  row.received = figures_.sent;
  row.dropped = figures_.dropped + hubs_.missed();
  row.refused = figures_.malformed;
  return true;
}

}  // namespace hub::trunk
