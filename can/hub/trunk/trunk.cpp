#include "can/hub/trunk/trunk.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include <fmt/format.h>

#include "can/hub/loop/clock.hpp"

namespace hub::trunk {

namespace {

using canopen::TimePoint;

/// Messages that are taken before members have their turn.
constexpr int kMessagesATurn = 64;

}  // namespace

Trunk::Trunk(Medium& medium, std::unique_ptr<Stream> stream, Settings settings, OnLink on_link, Notice notice,
             std::unique_ptr<Lease> lease)
    : medium_{medium},
      stream_{std::move(stream)},
      settings_{std::move(settings)},
      on_link_{std::move(on_link)},
      notices_{settings_.url, std::move(notice)},
      outgoing_{*stream_,
                {.hub = medium.number_of_hub(),
                 .name = settings_.name,
                 .bit_rate = settings_.bit_rate,
                 .frames_a_message = settings_.frames_a_message}},
      incoming_{medium, notices_, figures_} {
  if (settings_.bit_rate != 0)
    arbitration_ = std::make_unique<Arbitration>(*stream_, std::move(lease), notices_, medium.number_of_hub(),
                                                 settings_.bit_rate);
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
  if (phase_ == Phase::Closed) open(now);
  read(now);
}

/// A hub that did not run for so long does not know what has passed meanwhile, nor how old is what members have
/// sent.
bool Trunk::stood_still(TimePoint now) noexcept {
  const TimePoint before = std::exchange(looked_, std::max(looked_, now));
  return phase_ != Phase::Closed && now - before > kPatience;
}

void Trunk::open(TimePoint now) noexcept {
  sequence_ = 0;
  outgoing_.see(0);
  heard_ = now;
  looked_ = now;
  incoming_.forgive(now);
  if (arbitration_) arbitration_->begin(now);
  join(now);
}

void Trunk::join(TimePoint now) noexcept {
  outgoing_.join();
  phase_ = Phase::Joining;
  joined_at_ = 0;
  beat(now);
}

void Trunk::come_up(TimePoint now) noexcept {
  phase_ = Phase::Up;
  is_failure_told_ = false;
  outgoing_.begin(arbitration_ ? arbitration_->term() : 0);
  notices_.tell(std::exchange(was_up_, true) ? "joined again" : "joined", now);
  on_link_(true, now);
  if (arbitration_) beat(now);  // from now on the arbiter knows this hub
}

/// What is under way is lost.
void Trunk::drop(std::string_view reason, TimePoint now) noexcept {
  if (phase_ != Phase::Up) return;
  ++figures_.cuts;
  const std::size_t dropped = outgoing_.drop();
  figures_.dropped += dropped;
  notices_.tell(fmt::format("cut: {}; {} frames were under way", reason, dropped), now);
  on_link_(false, now);
}

void Trunk::cut(std::string_view reason, TimePoint now) noexcept {
  drop(reason, now);
  outgoing_.drop();
  phase_ = Phase::Closed;
  has_more_ = false;
  if (arbitration_) arbitration_->step_down(false);
  stream_->reopen();
}

/// Cut from the others, but not from the stream.
void Trunk::part(std::string_view reason, TimePoint now) noexcept {
  drop(reason, now);
  join(now);
}

void Trunk::read(TimePoint now) noexcept {
  Stream::Message message;
  has_more_ = true;
  for (int i = 0; i < kMessagesATurn && has_more_; ++i) {
    has_more_ = phase_ != Phase::Closed && stream_->receive(message);
    if (has_more_) take_message(message, now);
  }
  if (phase_ == Phase::Up) medium_.go_on(now);
  if (arbitration_) arbitrate(now);
}

void Trunk::take_message(const Stream::Message& message, TimePoint now) noexcept {
  const std::uint64_t before = std::exchange(sequence_, message.sequence);
  if (before != 0 && message.sequence != before + 1)
    return cut(fmt::format("the stream went from message {} to {}", before, message.sequence), now);
  outgoing_.see(message.time_ns);
  std::string_view problem;
  const auto reader = Reader::read(message.bytes, problem);
  if (!reader) {
    ++figures_.malformed;
    return notices_.tell(fmt::format("message {} {}", message.sequence, problem), now);
  }
  const Header& header = reader->header();
  const bool is_stale = is_late(header, message.time_ns);
  const bool is_of_this_bus = header.is_of_bus_at(settings_.bit_rate);
  if (!is_of_this_bus && !is_stale) meet_other_bus(*reader, now);
  if (!is_of_this_bus || phase_ == Phase::Refused) return;
  if (is_of_arbiter(header.kind) && !is_obeyed(*reader, is_stale, now)) return;
  if (header.hub == medium_.number_of_hub())
    take_own(*reader, message, is_stale, now);
  else
    take_foreign(*reader, message, is_stale, now);
  if (header.kind == Kind::ArbiterBeat) follow(header, now);
}

/// Whoever was on the bus before goes on, and says at once that he is there; the other one does not join. A hub
/// without a bit rate is on the bus as soon as it says that it is there, one with a bit rate when it obeys an
/// arbiter.
void Trunk::meet_other_bus(const Reader& reader, TimePoint now) noexcept {
  const Header& header = reader.header();
  if (!is_beat(header.kind)) return;
  const bool is_on_bus = phase_ == Phase::Up && arbitration_;
  if (is_on_bus && header.term == 0) return beat(now);
  if (is_on_bus && header.term > arbitration_->term()) return;
  if (header.term != 0 || header.bit_rate() == 0) refuse(reader, now);
}

void Trunk::refuse(const Reader& reader, TimePoint now) noexcept {
  refused_until_ = now + kRefusal;
  if (phase_ == Phase::Refused) return;
  const std::string reason =
      fmt::format("{} has the bus {}, this hub is to have it {}", reader.name(),
                  text_of_bit_rate(reader.header().bit_rate()), text_of_bit_rate(settings_.bit_rate));
  if (phase_ != Phase::Up) notices_.tell("not joined: " + reason, now);
  drop(reason, now);
  phase_ = Phase::Refused;
  if (arbitration_) arbitration_->step_down(true);
}

bool Trunk::is_obeyed(const Reader& reader, bool is_stale, TimePoint now) noexcept {
  using Verdict = Arbitration::Verdict;
  const Verdict verdict = arbitration_->judge(reader.header(), is_stale, now);
  if (verdict == Verdict::Obey) return true;
  if (verdict == Verdict::Begin) {
    const bool is_here = reader.header().hub == medium_.number_of_hub();
    notices_.tell(fmt::format("{} is the arbiter", is_here ? "this hub" : reader.name()), now);
    if (phase_ == Phase::Up) part("there is another arbiter", now);
    return true;
  }
  if (verdict == Verdict::End && phase_ == Phase::Up) part("the arbiter was cut itself", now);
  figures_.stale += reader.frames();
  return false;
}

/// The arbiter has heard that this hub has joined: whoever was the arbiter before has been heard of then.
void Trunk::follow(const Header& header, TimePoint now) noexcept {
  if (phase_ == Phase::Joining && joined_at_ != 0 && header.seen >= joined_at_) come_up(now);
}

void Trunk::take_own(const Reader& reader, const Stream::Message& message, bool is_stale, TimePoint now) noexcept {
  const Header& header = reader.header();
  if (header.epoch != outgoing_.epoch()) return;  // counted when the wire was cut
  if (header.kind == Kind::Lost) return part("the arbiter has lost frames of this hub", now);
  if (outgoing_.is_repeated(reader)) {
    figures_.repeated += reader.frames();
    return;
  }
  if (header.kind != Kind::Granted) {  // this hub has sent it: the way there and back is whole
    outgoing_.note_return(header);
    if (is_stale) return cut("messages reach the stream too late", now);
    heard_ = now;
  }
  if (phase_ == Phase::Joining && joined_at_ == 0) {
    joined_at_ = message.time_ns;
    arbitration_ ? answer(header, now) : come_up(now);
  }
  for (std::size_t i = 0; i < reader.frames(); ++i) {
    auto passage = outgoing_.take_back(reader, i);
    if (!passage) return cut("frames have come back in another order", now);
    passage->time_ns = reader.time(message.time_ns);
    ++figures_.sent;
    medium_.pass(*passage, now);
  }
}

void Trunk::take_foreign(const Reader& reader, const Stream::Message& message, bool is_stale,
                         TimePoint now) noexcept {
  using Gate = Incoming::Gate;
  if (reader.header().kind == Kind::Lost) return;
  const Gate gate = is_stale ? Gate::Stale : phase_ == Phase::Up ? Gate::Open : Gate::Closed;
  const bool is_anew = incoming_.take(reader, reader.time(message.time_ns), gate, now);
  if (is_anew && arbitration_) answer(reader.header(), now);
}

/// A hub that has joined waits until it hears that the arbiter knows that.
void Trunk::answer(const Header& header, TimePoint now) noexcept {
  if (!arbitration_->is_arbiter()) return;
  arbitration_->on_beat(header);
  beat(now);
}

void Trunk::take(const Passage& passage, TimePoint now) noexcept {
  if (stood_still(now)) {
    outgoing_.skip();
    ++figures_.dropped;
    return cut("this hub was kept from running", now);
  }
  outgoing_.take(passage);
}

void Trunk::beat(TimePoint now) noexcept {
  next_beat_ = now + kBeat;
  outgoing_.beat(arbitration_ && arbitration_->is_arbiter() ? arbitration_->term() : 0);
}

void Trunk::arbitrate(TimePoint now) noexcept {
  if (phase_ != Phase::Joining && phase_ != Phase::Up) return;
  arbitration_->turn(outgoing_.seen(), now);
  if (phase_ == Phase::Up && now > arbitration_->quiet_at()) part("no arbiter has been heard for 500 ms", now);
  if (phase_ == Phase::Joining && joined_at_ != 0 && arbitration_->seek(now)) beat(now);
}

TimePoint Trunk::next_deadline() const noexcept {
  if (outgoing_.is_waiting() || has_more_) return TimePoint::min();
  if (phase_ == Phase::Closed) return notices_.due();
  if (phase_ == Phase::Refused) return std::min(refused_until_, notices_.due());
  const TimePoint next = std::min({next_beat_, heard_ + kPatience + canopen::Duration{1}, notices_.due()});
  if (!arbitration_) return next;
  const TimePoint quiet_at =
      phase_ == Phase::Up ? arbitration_->quiet_at() + canopen::Duration{1} : canopen::kNever;
  return std::min({next, quiet_at, arbitration_->next_deadline(phase_ == Phase::Joining && joined_at_ != 0)});
}

void Trunk::on_time(TimePoint now) noexcept {
  notices_.on_time(now);
  if (phase_ == Phase::Closed) return;
  if (stood_still(now)) return cut("this hub was kept from running", now);
  if (has_more_) read(now);
  outgoing_.flush();
  if (phase_ == Phase::Closed) return;
  if (phase_ == Phase::Refused) {
    if (now >= refused_until_) cut("", now);
    return;
  }
  if (now - heard_ > kPatience) return miss_own(now);
  if (arbitration_) arbitrate(now);
  if (now < next_beat_) return;
  beat(now);
  outgoing_.flush();
  incoming_.tell_gone(now);
}

/// The way there and back is broken somewhere, even if others are heard.
void Trunk::miss_own(TimePoint now) noexcept {
  if (phase_ == Phase::Joining && !std::exchange(is_failure_told_, true))
    notices_.tell("nothing that this hub sends comes back: the server is full, or does not let it publish", now);
  cut("nothing has come back for 500 ms", now);
}

}  // namespace hub::trunk
