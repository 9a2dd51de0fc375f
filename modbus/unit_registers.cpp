#include "modbus/unit_registers.hpp"

#include <algorithm>
#include <utility>

namespace modbus {
namespace {

constexpr bool is_process_data(Content content) noexcept {
  return content == Content::ReceivedWord || content == Content::SentWord;
}

std::uint16_t word_of(std::span<const std::uint16_t> words, std::size_t place) noexcept {
  return place < words.size() ? words[place] : std::uint16_t{0};
}

/// Whether some of @p count registers from @p first on hold process data.
bool have_process_data(std::uint16_t first, std::size_t count) noexcept {
  return std::ranges::any_of(register_map(), [&](const RegisterRow& row) {
    return is_process_data(row.content) && first <= row.last && first + count > row.first;
  });
}

/// As a record has it; it knows one code for all limits.
std::uint16_t code_of(drive::RefusalReason reason) noexcept {
  using enum drive::RefusalReason;
  const bool is_limit = reason == BelowMinimum || reason == AboveMaximum;
  return static_cast<std::uint16_t>(is_limit ? OutOfRange : reason);
}

}  // namespace

void UnitRegisters::read(std::uint16_t first, std::span<std::uint16_t> values) noexcept {
  const drive::DriveObject* const target = face_.target();
  std::ranges::fill(values, std::uint16_t{0});
  if (target == nullptr) return;
  if (have_process_data(first, values.size())) interface_.touch(target->number());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto number = static_cast<std::uint16_t>(first + i);
    if (const RegisterRow* const row = find_register(number)) values[i] = read(*target, {*row, number});
  }
}

std::uint16_t UnitRegisters::read(const drive::DriveObject& target, const Place& place) const noexcept {
  const auto value_in = [&](std::uint8_t object) {
    const auto value = std::as_const(runner_).unit().read(object, place.row.parameter, place.offset());
    return value ? shown(place.row.scale, drive::decode(*value)) : std::uint16_t{0};
  };
  switch (place.row.content) {
    case Content::ReceivedWord:
      return word_of(interface_.received(target.number()), place.offset());
    case Content::SentWord:
      return word_of(interface_.sent(target.number()), place.offset());
    case Content::AxisParameter:
      return value_in(target.number());
    case Content::UnitParameter:
      return value_in(drive::kControlUnitNumber);
    case Content::RefusalCode:
      return refusal_code_;
    case Content::Technology:
      return 0;
    case Content::Record:
      return face_.mailbox().read(place.offset());
  }
  return 0;
}

bool UnitRegisters::refuse(drive::RefusalReason reason) noexcept {
  refusal_code_ = code_of(reason);
  return false;
}

bool UnitRegisters::exists(const drive::DriveObject& target, const Place& place) const noexcept {
  if (place.row.content == Content::Technology) return false;
  return place.row.content != Content::AxisParameter ||
         target.parameter(place.row.parameter, place.offset()).has_value();
}

bool UnitRegisters::is_writable(const drive::DriveObject& target, std::uint16_t number) noexcept {
  const RegisterRow* const row = find_register(number);
  if (row == nullptr || !exists(target, {*row, number})) return refuse(drive::RefusalReason::NoParameter);
  return row->is_writable() || refuse(drive::RefusalReason::ReadOnly);
}

/// Writable rows of different contents do not touch each other, so that the first one tells what all are.
bool UnitRegisters::write(std::uint16_t first, std::span<const std::uint16_t> values) noexcept {
  const drive::DriveObject* const target = face_.target();
  if (target == nullptr) return refuse(drive::RefusalReason::NoDriveObject);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!is_writable(*target, static_cast<std::uint16_t>(first + i))) return false;
  const RegisterRow& row = *find_register(first);
  const std::size_t offset = first - row.first;
  if (row.content == Content::AxisParameter) return write_parameters(target->number(), first, values);
  if (row.content == Content::Record) {
    face_.write_mailbox(offset, values);
    return true;
  }
  commanded_ = target->number();
  has_command_ = true;
  interface_.receive(commanded_, values, offset);
  return true;
}

bool UnitRegisters::write_parameters(std::uint8_t target, std::uint16_t first,
                                     std::span<const std::uint16_t> values) noexcept {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto number = static_cast<std::uint16_t>(first + i);
    const RegisterRow& row = *find_register(number);
    const double value = value_of(row.scale, values[i]);
    const auto written = runner_.write_parameter(
        target, row.parameter, static_cast<std::size_t>(number - row.first), value, runner_.now());
    if (!written) return refuse(written.error().reason.why);
  }
  return true;
}

bool UnitRegisters::take_command() noexcept {
  return std::exchange(has_command_, false);
}

}  // namespace modbus
