#include "modbus/connection.hpp"

#include <algorithm>

#include "modbus/functions.hpp"

namespace modbus {
namespace {

/// Takes the first @p bytes out of @p held ones.
void drop(std::span<std::uint8_t> held, std::size_t bytes) noexcept {
  std::shift_left(held.begin(), held.end(), static_cast<std::ptrdiff_t>(bytes));
}

}  // namespace

std::span<std::uint8_t> Connection::room() noexcept {
  const bool is_wanted = !has_ended_ && has_room_for_answer() && !has_request();
  return is_wanted ? std::span{input_}.subspan(held_) : std::span<std::uint8_t>{};
}

bool Connection::has_request() const noexcept {
  const auto frame = first_frame(std::span{input_}.first(held_));
  return frame && frame->has_value();
}

void Connection::answer(std::size_t most) noexcept {
  for (std::size_t i = 0; i < most && has_room_for_answer(); ++i) {
    const auto frame = first_frame(std::span{input_}.first(held_));
    if (!frame) {
      held_ = 0;
      return on_end();
    }
    if (!*frame) return;
    answer(**frame);
    drop(std::span{input_}.first(held_), (*frame)->bytes);
    held_ -= (*frame)->bytes;
  }
}

void Connection::answer(const Frame& request) noexcept {
  const std::span<std::uint8_t, kMostFrameBytes> place{output_.data() + answered_, kMostFrameBytes};
  const auto pdu = place.subspan<kHeaderBytes>();
  const std::size_t bytes = modbus::answer(request.pdu, pdu, bank_);
  ++counters_.requests;
  if ((pdu[0] & kExceptionBit) != 0) ++counters_.exceptions;
  answered_ += write_header(request, bytes, place.first<kHeaderBytes>());
}

void Connection::on_sent(std::size_t bytes) noexcept {
  drop(std::span{output_}.first(answered_), bytes);
  answered_ -= bytes;
}

}  // namespace modbus
