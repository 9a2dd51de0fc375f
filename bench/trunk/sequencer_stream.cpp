#include "bench/trunk/sequencer_stream.hpp"

#include <utility>

#include "bench/trunk/sequencer_messages.hpp"
#include "bench/trunk/tcp.hpp"

namespace bench {

SequencerStream::SequencerStream(std::string_view place) : socket_{connect_to(place)} {}

SequencerStream::State SequencerStream::advance() noexcept {
  if (state_ == State::Open && read_some(socket_, given_) == Transfer::Failed) state_ = State::Lost;
  return state_;
}

bool SequencerStream::receive(Message& message) noexcept {
  given_.take(std::exchange(received_, 0));
  const auto next = first_of<GivenHead>(given_);
  if (!next) return false;
  received_ = next->size();
  if (next->head.sequence == 0) return receive(message);
  message = {.bytes = next->bytes, .sequence = next->head.sequence, .time_ns = next->head.time_ns};
  return true;
}

void SequencerStream::publish(std::span<const std::byte> bytes) noexcept {
  put_message(asked_, AskedHead{}, bytes);
}

void SequencerStream::flush() noexcept {
  if (write_all(socket_, asked_) != Transfer::Done) state_ = State::Lost;
}

}  // namespace bench
