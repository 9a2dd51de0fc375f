#include "device/process_data/standard_wiring.hpp"

#include <algorithm>
#include <variant>

#include "device/process_data/process_objects.hpp"

namespace device {
namespace {

/// The inputs that a bit of the controlword leads to (p8790).
struct Command {
  std::uint16_t input;
  std::uint16_t bit;
};
constexpr std::array kCommandInputs{Command{840, 0}, Command{844, 1}, Command{848, 2}, Command{852, 3},
                                    Command{2103, 7}};

/// The inputs of setpoints, in the order of the sources behind those of the controlword.
enum Setpoint : std::size_t { kMain, kBehindRamp, kTorque, kMessage };
constexpr std::array<std::uint16_t, 4> kSetpointInputs{1070, 1155, 1503, 2151};
constexpr std::uint16_t kSentWord = 8851;
constexpr std::uint16_t kSentDoubleWord = 8861;

constexpr std::uint16_t kReceivedWord = 8850;
constexpr std::uint16_t kReceivedDoubleWord = 8860;
constexpr std::uint16_t kFirstReceivedBits = 8890;
constexpr std::size_t kWordsWithBits = 4;
constexpr std::uint16_t kWrittenControlword = 8795;
constexpr std::uint16_t kWrittenTorque = 8797;
constexpr std::uint16_t kConnectControlword = 8790;

// What "target reached" compares with: in front of the ramp, and behind it where there is none.
constexpr std::uint16_t kRampInput = 1119;
constexpr std::uint16_t kSpeedSetpoint = 1438;

constexpr std::uint32_t own(std::uint16_t number, std::size_t position) noexcept {
  return drive::pack({number, drive::kOwnObject, static_cast<std::uint16_t>(position)});
}

/// A BICO input of the axis.
struct Input {
  std::uint16_t number;
  std::size_t index;
};
Input input_at(std::size_t position) noexcept {
  if (position < kCommandInputs.size()) return {kCommandInputs[position].input, 0};
  position -= kCommandInputs.size();
  if (position < kSetpointInputs.size()) return {kSetpointInputs[position], 0};
  position -= kSetpointInputs.size();
  const bool is_word = position < ProcessDataLayout::kTransmitWords;
  return is_word ? Input{kSentWord, position}
                 : Input{kSentDoubleWord, position - ProcessDataLayout::kTransmitWords};
}

/// The last double word has no second half to lie in.
bool exists(const Input& input) noexcept {
  return input.number != kSentDoubleWord || input.index + 1 < ProcessDataLayout::kTransmitWords;
}

}  // namespace

StandardWiring::StandardWiring(drive::Axis& axis, const ProcessDataBuffers& places) noexcept
    : axis_{axis}, places_{places} {
  static_assert(kCommands == kCommandInputs.size() && kSetpoints == kSetpointInputs.size());
  wired_ = factory();
}

void StandardWiring::follow_from_factory() noexcept {
  wired_ = factory();
  follow();
}

void StandardWiring::adopt() noexcept {
  wired_ = wanted();
  // A mode that was asked for is not saved, the input that it connected is.
  const Setpoint speed = axis_.has_setpoint_channel() ? kMain : kBehindRamp;
  for (const drive::OperatingModeRow& mode : drive::kOperatingModes) {
    const std::uint32_t source = source_of(mode.setpoint, mode.written);
    const bool is_asked_for = mode.lead == drive::Lead::Speed && drive::mode_of(mode.control_mode) != mode.code;
    if (is_asked_for && connected(kSetpointInputs[speed], 0) == source) wired_[kCommands + speed] = source;
  }
}

void StandardWiring::follow() noexcept {
  const Sources now = wanted();
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Input input = input_at(i);
    if (now[i] == wired_[i] || !exists(input)) continue;
    if (connected(input.number, input.index) == wired_[i]) connect(i, now[i]);
  }
  wired_ = now;
}

void StandardWiring::connect_controlword() noexcept {
  wire_commands(wired_);
  for (std::size_t i = 0; i < kCommands; ++i) connect(i, wired_[i]);
}

void StandardWiring::connect(std::size_t input, std::uint32_t source) noexcept {
  const Input place = input_at(input);
  static_cast<void>(axis_.load(place.number, place.index, source));
}

std::uint32_t StandardWiring::connected(std::uint16_t input, std::size_t index) const noexcept {
  return static_cast<std::uint32_t>(axis_.kept_value(input, index).value_or(0.0));
}

StandardWiring::Sources StandardWiring::wanted() const noexcept {
  Sources sources = wired_;
  if (axis_.kept_value(kConnectControlword).value_or(0.0) > 0.0) wire_commands(sources);
  wire_setpoints(sources);
  wire_actual_values(sources);
  return sources;
}

StandardWiring::Sources StandardWiring::factory() const noexcept {
  Sources sources{};
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const Input input = input_at(i);
    if (!exists(input)) continue;
    const drive::ParameterRow& row = *drive::find_parameter(axis_.kind(), input.number)->row;
    sources[i] = static_cast<std::uint32_t>(drive::factory_value(row, axis_.context(), input.index));
  }
  return sources;
}

/// A controlword beyond the words that have binectors leads nowhere.
void StandardWiring::wire_commands(Sources& sources) const noexcept {
  const ProcessDataLayout::Item* const place =
      places_.received().find(object::on_axis(object::kControlword, axis_.axis_number()));
  const bool has_bits = place != nullptr && place->first < kWordsWithBits;
  const auto word = has_bits ? static_cast<std::uint16_t>(kFirstReceivedBits + place->first) : kWrittenControlword;
  for (std::size_t i = 0; i < kCommandInputs.size(); ++i) sources[i] = own(word, kCommandInputs[i].bit);
}

void StandardWiring::wire_setpoints(Sources& sources) const noexcept {
  const bool has_channel = axis_.has_setpoint_channel();
  const std::uint32_t speed = source_of(axis_.speed_setpoint().setpoint, axis_.speed_setpoint().written);
  sources[kCommands + kMain] = has_channel ? speed : 0;
  sources[kCommands + kBehindRamp] = has_channel ? 0 : speed;
  sources[kCommands + kTorque] = source_of(object::kTargetTorque, kWrittenTorque);
  sources[kCommands + kMessage] = own(has_channel ? kRampInput : kSpeedSetpoint, 0);
}

/// Where the received @p object comes from: its place in the words, or the parameter @p written without one.
std::uint32_t StandardWiring::source_of(std::uint16_t object, std::uint16_t written) const noexcept {
  const ProcessDataLayout::Item* const place =
      places_.received().find(object::on_axis(object, axis_.axis_number()));
  if (place == nullptr) return own(written, 0);
  return own(place->words == 1 ? kReceivedWord : kReceivedDoubleWord, place->first);
}

void StandardWiring::wire_actual_values(Sources& sources) const noexcept {
  constexpr std::size_t kWords = kCommands + kSetpoints;
  constexpr std::size_t kDoubleWords = kWords + kSent;
  std::fill(sources.begin() + kWords, sources.end(), 0U);
  for (const ProcessDataLayout::Item& item : places_.sent().items()) {
    if (item.object->index < object::kFirstProfileObject) continue;
    const std::uint16_t first = object::on_first_axis(item.object->index);
    const auto* const row = std::ranges::find(kSentObjects, first, &SentObject::index);
    if (row == kSentObjects.end()) continue;
    sources[(item.words == 1 ? kWords : kDoubleWords) + item.first] = own(row->parameter, 0);
  }
}

}  // namespace device
