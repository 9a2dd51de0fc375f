#include "can/hub/trunk/outgoing.hpp"

#include <utility>

#include "can/hub/loop/clock.hpp"

namespace hub::trunk {

void Outgoing::take(const Passage& passage) noexcept {
  const std::uint32_t lane = lane_of(passage.station);
  const Header& begun = writer_.header();
  if (begun.origin != passage.mark.hub || begun.station() != lane ||
      writer_.frames() >= settings_.frames_a_message)
    finish_message();
  if (writer_.frames() == 0) {
    Header begin = header(Kind::Frames);
    begin.origin = passage.mark.hub;
    begin.detail = lane;
    writer_.begin(begin);
  }
  writer_.add({passage.frame, passage.mark.number});
  under_way_.push(lane, {passage, monotonic_now()});
  ++counter_;
}

void Outgoing::send(Way way, Writer& writer) noexcept {
  (stream_.*way)(writer.finish());
  is_unsent_ = true;
}

void Outgoing::finish_message() noexcept {
  if (writer_.frames() == 0) return;
  send(settings_.bit_rate != 0 ? &Stream::ask : &Stream::publish, writer_);
  writer_.begin({});
}

void Outgoing::flush() noexcept {
  finish_message();
  if (std::exchange(is_unsent_, false)) stream_.flush();
}

void Outgoing::beat(std::uint32_t own_term) noexcept {
  Header beat = header(Kind::Beat);
  beat.detail = settings_.bit_rate;
  const auto say = [&](Way way) {
    Writer writer;
    writer.begin(beat);
    writer.add_name(settings_.name);
    send(way, writer);
  };
  if (term_ != 0) {
    finish_message();  // it is counted already
    say(&Stream::ask);
    beat.counter = expected();
  }
  if (own_term != 0) {
    beat.kind = Kind::ArbiterBeat;
    beat.term = own_term;
  }
  say(&Stream::publish);
}

Header Outgoing::header(Kind kind) const noexcept {
  return {.kind = kind,
          .hub = settings_.hub,
          .epoch = epoch_,
          .origin = settings_.hub,
          .counter = counter_,
          .seen = seen_,
          .term = term_};
}

bool Outgoing::is_repeated(const Reader& reader) const noexcept {
  const Header& header = reader.header();
  if (is_beat(header.kind)) return header.seen < returned_seen_;
  return header.counter + reader.frames() <= expected();
}

std::optional<Passage> Outgoing::take_back(const Reader& reader, std::size_t number) noexcept {
  const std::uint32_t lane = lane_of(reader.header().station());
  const UnderWay::Frame* const first = under_way_.first(lane);
  if (first == nullptr || reader.header().counter + number != expected() ||
      reader.frame(number).number != first->passage.mark.number)
    return std::nullopt;
  latency_.add(monotonic_now() - first->taken);
  const Passage passage = first->passage;
  under_way_.pop(lane);
  return passage;
}

std::size_t Outgoing::drop() noexcept {
  const std::size_t count = under_way_.count();
  under_way_.clear();
  writer_.begin({});
  is_unsent_ = false;
  return count;
}

}  // namespace hub::trunk
