#include "tools/canopen-check/checks/drive/axis.hpp"

#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

constexpr std::uint16_t kAxes = 8;
/// Having left Operational before may be a fault, which a drive need not show at once.
constexpr canopen::Duration kAfterNmt = std::chrono::milliseconds{100};
constexpr std::array kStates{kSwitchOnDisabled,
                             kReadyToSwitchOn,
                             kSwitchedOn,
                             kOperationEnabled,
                             kQuickStopActive,
                             kFault,
                             DriveState{0x4F, 0x0F, "Fault reaction active"},
                             DriveState{0x4F, 0x00, "Not ready to switch on"}};

}  // namespace

std::string state_in(std::uint64_t statusword) {
  for (const DriveState& state : kStates)
    if (state.is(statusword)) return fmt::format("{}, {:04X}h", state.name, statusword);
  return fmt::format("{:04X}h", statusword);
}

std::vector<std::uint16_t> axes_with(Context& context, std::uint16_t object) {
  std::vector<std::uint16_t> offsets;
  for (std::uint16_t axis = 0; axis < kAxes; ++axis) {
    const auto offset = static_cast<std::uint16_t>(axis * kAxisDistance);
    const auto index = static_cast<std::uint16_t>(object + offset);
    if (context.eds().empty() ? axis == 0 && context.read(index).done() : context.eds().has(index))
      offsets.push_back(offset);
  }
  if (offsets.empty()) context.skip(fmt::format("object {:04X}h is not there: no drive", object));
  return offsets;
}

void on_each_axis(Context& context, void (*check)(Axis&)) {
  const std::vector<std::uint16_t> offsets = axes_with(context, kControlword);
  if (offsets.empty()) return;
  context.enter(canopen::NmtState::Operational);
  context.session().pass(kAfterNmt);
  std::size_t applies = 0;
  for (const std::uint16_t offset : offsets) {
    Axis axis{context, offset};
    context.step();
    if (axis.disable()) check(axis);
    axis.rest();
    if (!axis.skipped()) {
      ++applies;
    } else if (offsets.size() > 1) {
      context.note(fmt::format("{:04X}h: {}", axis.at(kControlword), *axis.skipped()));
    }
    if (axis.skipped() && !context.skipped()) context.skip(*axis.skipped());
  }
  if (applies != 0) context.unskip();
}

bool Axis::skip(std::string reason) {
  if (!skipped_) skipped_ = std::move(reason);
  return false;
}

bool Axis::fail(std::uint16_t object, std::string expected, std::string found) {
  context_->fail(at(object), 0, std::move(expected), std::move(found));
  return false;
}

bool Axis::has(std::uint16_t object, std::uint8_t sub_index) {
  return context_->eds().empty() ? context_->read(at(object), sub_index).done()
                                 : context_->eds().find(at(object), sub_index) != nullptr;
}

bool Axis::needs(std::initializer_list<std::uint16_t> objects) {
  for (const std::uint16_t object : objects)
    if (!has(object)) return skip(fmt::format("object {:04X}h is not there", at(object)));
  return true;
}

std::uint64_t Axis::number(std::uint16_t object, std::uint8_t sub_index) {
  return context_->read(at(object), sub_index).number();
}

std::int64_t Axis::value(std::uint16_t object, std::uint8_t sub_index) {
  const SdoAnswer answer = context_->read(at(object), sub_index);
  const std::size_t unused = 64 - 8 * std::min<std::size_t>(answer.data.size(), 8);
  if (unused == 64) return 0;
  return static_cast<std::int64_t>(answer.number() << unused) >> unused;
}

SdoAnswer Axis::write(std::uint16_t object, std::int64_t value, std::uint8_t sub_index) {
  return context_->write_number(at(object), sub_index, static_cast<std::uint64_t>(value));
}

bool Axis::set(std::uint16_t object, std::int64_t value, std::uint8_t sub_index) {
  const SdoAnswer answer = write(object, value, sub_index);
  if (answer.done()) return true;
  return skip(
      fmt::format("{} does not take {}: {}", to_text(Subject{at(object), sub_index}), value, to_text(answer)));
}

bool Axis::set_if_there(std::uint16_t object, std::int64_t value, std::uint8_t sub_index) {
  return !has(object, sub_index) || set(object, value, sub_index);
}

void Axis::command(std::uint16_t word) {
  (void)context_->sdo().download(at(kControlword), 0, eds::little_endian(word, 2));
}

std::uint16_t Axis::status() {
  return static_cast<std::uint16_t>(number(kStatusword));
}

bool Axis::reaches(const DriveState& state, canopen::Duration patience) {
  return await(patience, [&] { return state.is(status()); });
}

bool Axis::shows(std::uint16_t mask, std::uint16_t bits, canopen::Duration patience) {
  return await(patience, [&] { return (status() & mask) == bits; });
}

bool Axis::supports(DriveMode mode) {
  const unsigned bit = static_cast<unsigned>(mode) - 1;
  return has(kSupportedModes) && (number(kSupportedModes) >> bit & 1U) != 0;
}

bool Axis::enter(DriveMode mode) {
  const auto wanted = static_cast<std::int64_t>(mode);
  if (mode != DriveMode::None && !supports(mode))
    return skip(fmt::format("{:04X}h does not have mode {}", at(kSupportedModes), wanted));
  if (!set(kMode, wanted)) return false;
  return await(kBitPatience, [&] { return value(kModeDisplay) == wanted; }) ||
         skip(fmt::format("{:04X}h does not come to mode {}", at(kModeDisplay), wanted));
}

bool Axis::switch_off() {
  command(kDisableVoltage);
  (void)await(kStatePatience, [&] {
    const std::uint16_t word = status();
    return kSwitchOnDisabled.is(word) || kFault.is(word);
  });
  if (kSwitchOnDisabled.is(status())) return true;
  command(kFaultReset);
  const bool done = reaches(kSwitchOnDisabled);
  command(kDisableVoltage);
  return done;
}

bool Axis::disable() {
  return switch_off() || skip(fmt::format("{:04X}h: the drive does not come to {} but is in {}", at(kStatusword),
                                          kSwitchOnDisabled.name, state_in(status())));
}

bool Axis::enable() {
  for (const auto& [word, state] : {std::pair{kShutdown, kReadyToSwitchOn}, std::pair{kSwitchOn, kSwitchedOn},
                                    std::pair{kEnableOperation, kOperationEnabled}}) {
    command(word);
    if (!reaches(state))
      return skip(fmt::format("{:04X}h: the drive does not come to {} but is in {}", at(kStatusword), state.name,
                              state_in(status())));
  }
  return true;
}

void Axis::rest() {
  context_->session().clean_up(true);
  const auto moves = [&] { return kOperationEnabled.is(status()) || kQuickStopActive.is(status()); };
  if (moves()) {
    command(kQuickStop);
    const std::uint64_t slow =
        1 + (has(kVelocity) ? static_cast<std::uint64_t>(std::abs(value(kVelocity))) / 10 : 0);
    (void)await(kStatePatience, [&] {
      return !moves() || (kQuickStopActive.is(status()) && has(kVelocity) &&
                          static_cast<std::uint64_t>(std::abs(value(kVelocity))) <= slow);
    });
  }
  if (!switch_off() && !skipped_)
    context_->note(fmt::format("{:04X}h: the drive is left in {}", at(kStatusword), state_in(status())));
  context_->session().clean_up(false);
}

}  // namespace conformance
