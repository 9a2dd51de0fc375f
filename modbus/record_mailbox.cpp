#include "modbus/record_mailbox.hpp"

#include <algorithm>

#include "modbus/frame.hpp"

namespace modbus {
namespace {

constexpr std::size_t kControlPlace = 0, kHeadPlace = 1, kDataPlace = 2;
constexpr std::uint16_t kFunction = 0x2F;  // of records, above the length
constexpr unsigned kFunctionShift = 8;
constexpr std::uint16_t kLengthMask = 0xFF;

constexpr std::uint16_t function_with(std::size_t bytes) noexcept {
  return static_cast<std::uint16_t>(unsigned{kFunction} << kFunctionShift | bytes);
}

constexpr std::uint16_t number(RecordMailbox::Control control) noexcept {
  return static_cast<std::uint16_t>(control);
}
constexpr std::uint16_t number(RecordMailbox::Error error) noexcept {
  return static_cast<std::uint16_t>(error);
}

/// What @p place reads while there is nothing but an error.
std::uint16_t error_word(RecordMailbox::Control control, RecordMailbox::Error error, std::size_t place) noexcept {
  if (place == kControlPlace) return number(control);
  if (place == kHeadPlace) return function_with(0);
  return place == kDataPlace ? number(error) : std::uint16_t{0};
}

}  // namespace

std::uint16_t RecordMailbox::read(std::size_t place) const noexcept {
  if (!is_pending_) return registers_[place];
  return was_busy_ ? error_word(Control::Done, Error::WrongState, place)
                   : error_word(Control::Active, Error::NotReady, place);
}

void RecordMailbox::write(std::size_t first, std::span<const std::uint16_t> values) noexcept {
  const std::size_t count = std::min(values.size(), kRegisters - first);
  std::ranges::copy(values.first(count), registers_.begin() + static_cast<std::ptrdiff_t>(first));
  const bool has_control = first == kControlPlace && count != 0;
  if (has_control && values[kControlPlace] == number(Control::Active)) activate();
}

void RecordMailbox::activate() noexcept {
  if (is_pending_) {
    was_busy_ = true;
    return;
  }
  const std::size_t bytes = registers_[kHeadPlace] & kLengthMask;
  if (registers_[kHeadPlace] >> kFunctionShift != kFunction) return show(Control::Done, Error::WrongFunction);
  if (bytes == 0 || bytes > kMostBytes) return show(Control::Done, Error::WrongLength);
  for (std::size_t i = 0; i < kDataRegisters; ++i) put_word(request_, i * kWordBytes, registers_[kDataPlace + i]);
  request_bytes_ = bytes;
  is_pending_ = true;
  was_busy_ = false;
}

void RecordMailbox::finish(std::span<const std::uint8_t> answer) noexcept {
  is_pending_ = false;
  if (answer.empty() || answer.size() > kMostBytes) return show(Control::Done, Error::Internal);
  show(Control::Done, answer.size());
  std::array<std::uint8_t, kMostBytes> bytes{};
  std::ranges::copy(answer, bytes.begin());
  for (std::size_t i = 0; i < kDataRegisters; ++i) registers_[kDataPlace + i] = word_at(bytes, i * kWordBytes);
}

void RecordMailbox::show(Control control, std::size_t bytes) noexcept {
  registers_.fill(0);
  registers_[kControlPlace] = number(control);
  registers_[kHeadPlace] = function_with(bytes);
}

void RecordMailbox::show(Control control, Error error) noexcept {
  for (std::size_t place = 0; place < kRegisters; ++place) registers_[place] = error_word(control, error, place);
}

}  // namespace modbus
