#include "drive/wiring.hpp"

#include <algorithm>
#include <array>

namespace drive {
namespace {

template <class Owner>
struct BinectorRow {
  std::uint16_t number;
  bool Owner::*member;
};
constexpr std::array kBinectors{
    BinectorRow<AxisInputs>{840, &AxisInputs::on},
    BinectorRow<AxisInputs>{844, &AxisInputs::no_off2},
    BinectorRow<AxisInputs>{845, &AxisInputs::no_off2_second},
    BinectorRow<AxisInputs>{848, &AxisInputs::no_off3},
    BinectorRow<AxisInputs>{849, &AxisInputs::no_off3_second},
    BinectorRow<AxisInputs>{852, &AxisInputs::enable_operation},
    BinectorRow<AxisInputs>{854, &AxisInputs::control_by_plc},
    BinectorRow<AxisInputs>{856, &AxisInputs::enable_speed_controller},
    BinectorRow<AxisInputs>{864, &AxisInputs::infeed_operates},
    BinectorRow<AxisInputs>{1020, &AxisInputs::fixed_setpoint_bit_0},
    BinectorRow<AxisInputs>{1021, &AxisInputs::fixed_setpoint_bit_1},
    BinectorRow<AxisInputs>{1022, &AxisInputs::fixed_setpoint_bit_2},
    BinectorRow<AxisInputs>{1023, &AxisInputs::fixed_setpoint_bit_3},
    BinectorRow<AxisInputs>{1055, &AxisInputs::jog_1},
    BinectorRow<AxisInputs>{1056, &AxisInputs::jog_2},
    BinectorRow<AxisInputs>{1110, &AxisInputs::inhibit_negative},
    BinectorRow<AxisInputs>{1111, &AxisInputs::inhibit_positive},
    BinectorRow<AxisInputs>{1113, &AxisInputs::invert_setpoint},
    BinectorRow<AxisInputs>{1122, &AxisInputs::bypass_ramp},
    BinectorRow<AxisInputs>{1140, &AxisInputs::enable_ramp},
    BinectorRow<AxisInputs>{1141, &AxisInputs::continue_ramp},
    BinectorRow<AxisInputs>{1142, &AxisInputs::enable_setpoint},
    BinectorRow<AxisInputs>{1143, &AxisInputs::set_ramp},
    BinectorRow<AxisInputs>{1501, &AxisInputs::torque_control},
    BinectorRow<AxisInputs>{2103, &AxisInputs::acknowledge_1},
    BinectorRow<AxisInputs>{2104, &AxisInputs::acknowledge_2},
    BinectorRow<AxisInputs>{2105, &AxisInputs::acknowledge_3},
    BinectorRow<AxisInputs>{2106, &AxisInputs::no_external_fault_1},
    BinectorRow<AxisInputs>{2107, &AxisInputs::no_external_fault_2},
    BinectorRow<AxisInputs>{2108, &AxisInputs::no_external_fault_3},
    BinectorRow<AxisInputs>{2112, &AxisInputs::no_external_alarm_1},
};
constexpr std::array kStatusBits{
    BinectorRow<AxisFeedback>{8785, &AxisFeedback::status_bit_8},
    BinectorRow<AxisFeedback>{8786, &AxisFeedback::status_bit_14},
    BinectorRow<AxisFeedback>{8787, &AxisFeedback::status_bit_15},
};

/// A connector input and the parameter that is 100 % of it.
struct ConnectorRow {
  std::uint16_t number;
  double AxisInputs::*member;
  std::uint16_t reference;
};
constexpr std::uint16_t kReferenceSpeed = 2000;
constexpr std::uint16_t kReferenceTorque = 2003;
constexpr std::array kConnectors{
    ConnectorRow{1070, &AxisInputs::main_setpoint, kReferenceSpeed},
    ConnectorRow{1075, &AxisInputs::supplementary_setpoint, kReferenceSpeed},
    ConnectorRow{1085, &AxisInputs::forward_limit, kReferenceSpeed},
    ConnectorRow{1088, &AxisInputs::backward_limit, kReferenceSpeed},
    ConnectorRow{1144, &AxisInputs::ramp_setting, kReferenceSpeed},
    ConnectorRow{1155, &AxisInputs::speed_setpoint_1, kReferenceSpeed},
    ConnectorRow{1160, &AxisInputs::speed_setpoint_2, kReferenceSpeed},
    ConnectorRow{1503, &AxisInputs::torque_setpoint, kReferenceTorque},
    ConnectorRow{1511, &AxisInputs::supplementary_torque_1, kReferenceTorque},
    ConnectorRow{1513, &AxisInputs::supplementary_torque_2, kReferenceTorque},
    ConnectorRow{1522, &AxisInputs::upper_torque_limit, kReferenceTorque},
    ConnectorRow{1523, &AxisInputs::lower_torque_limit, kReferenceTorque},
};

constexpr std::uint16_t kFirstOutput = 738;  // p0738 to p0745
constexpr std::uint16_t kAcknowledgeAll = 2102;
constexpr std::uint16_t kMessageSetpoint = 2151;
constexpr std::uint16_t kSentWords = 8851;
constexpr std::uint16_t kSentDoubleWords = 8861;
constexpr std::uint16_t kBits = 8880;  // BI, a word each
constexpr std::uint16_t kInvertBits = 8888;
constexpr std::uint16_t kInvertWords = 8898;
constexpr std::uint16_t kWords = 8899;
constexpr std::size_t kBitsOfAWord = 16;

double parameter(const DriveObject& object, std::uint16_t number, std::size_t index = 0) noexcept {
  return object.read(number, index).value_or(0.0);
}

bool has(const DriveObject& object, std::uint16_t number) noexcept {
  return find_parameter(object.kind(), number) != nullptr;
}

/// What is 100 % of a quantity with reference @p number, in SI units.
double reference(const DriveObject& object, std::uint16_t number) noexcept {
  return parameter(object, number) * (number == kReferenceSpeed ? kRpm : 1.0);
}

}  // namespace

Wiring::Wiring(DriveUnit& unit) : unit_{unit} {
  objects_.push_back({.object = &unit.control_unit()});
  for (Axis& axis : unit.axes()) objects_.push_back({.object = &axis});
  if (Infeed* const infeed = unit.infeed()) objects_.push_back({.object = infeed});
  for (Object& entry : objects_) reserve(entry);
}

void Wiring::reserve(Object& entry) {
  entry.bits.reserve(kBinectors.size());
  entry.values.reserve(kConnectors.size());
  entry.status_bits.reserve(kStatusBits.size());
  entry.words_of_bits.reserve(entry.constant_words_of_bits.size() * kBitsOfAWord);
  entry.bits_of_words.reserve(entry.inverted_words.size());
  entry.sent_words.reserve(ProcessDataImage::kSentWords);
  entry.sent_double_words.reserve(ProcessDataImage::kSentWords);
}

void Wiring::connect() noexcept {
  if (valid_) return;
  valid_ = true;
  for (Object& entry : objects_) connect(entry);
  const DriveObject& control_unit = *objects_.front().object;
  acknowledge_all_ = source(control_unit, kAcknowledgeAll);
  for (std::size_t i = 0; i < outputs_.size(); ++i)
    outputs_[i] = source(control_unit, static_cast<std::uint16_t>(kFirstOutput + i));
}

void Wiring::connect(Object& entry) noexcept {
  connect_inputs(entry);
  connect_feedback(entry);
  connect_converters(entry);
  connect_sent(entry);
}

SignalSource Wiring::source(const DriveObject& object, std::uint16_t number, std::size_t index) const noexcept {
  return {unit_, object, static_cast<std::uint32_t>(parameter(object, number, index))};
}

void Wiring::connect_inputs(Object& entry) noexcept {
  const DriveObject& object = *entry.object;
  entry.bits.clear();
  entry.values.clear();
  entry.constant_inputs = {};
  for (const auto& row : kBinectors) {
    if (!has(object, row.number)) continue;
    const SignalSource from = source(object, row.number);
    entry.constant_inputs.*row.member = from.bit();
    if (!from.is_constant()) entry.bits.push_back({row.member, from, 0.0});
  }
  for (const ConnectorRow& row : kConnectors) {
    if (!has(object, row.number)) continue;
    const SignalSource from = source(object, row.number);
    const double full = reference(object, row.reference);
    entry.constant_inputs.*row.member = from.value(full);
    if (!from.is_constant()) entry.values.push_back({row.member, from, full});
  }
}

void Wiring::connect_feedback(Object& entry) noexcept {
  const DriveObject& object = *entry.object;
  entry.status_bits.clear();
  entry.constant_feedback = {};
  if (!has(object, kMessageSetpoint)) return;
  entry.message_setpoint = source(object, kMessageSetpoint);
  entry.reference_speed = reference(object, kReferenceSpeed);
  for (const auto& row : kStatusBits) {
    const SignalSource from = source(object, row.number);
    entry.constant_feedback.*row.member = from.bit();
    if (!from.is_constant()) entry.status_bits.push_back({row.member, from, 0.0});
  }
}

void Wiring::connect_converters(Object& entry) noexcept {
  const DriveObject& object = *entry.object;
  entry.words_of_bits.clear();
  entry.bits_of_words.clear();
  for (std::size_t word = 0; word < entry.constant_words_of_bits.size(); ++word) {
    auto constant = static_cast<unsigned>(parameter(object, kInvertBits, word));
    for (std::size_t bit = 0; bit < kBitsOfAWord; ++bit) {
      const SignalSource from = source(object, static_cast<std::uint16_t>(kBits + word), bit);
      if (!from.is_constant())
        entry.words_of_bits.push_back({word, bit, from});
      else
        constant ^= static_cast<unsigned>(from.bit()) << bit;
    }
    entry.constant_words_of_bits[word] = static_cast<std::uint16_t>(constant);
  }
  for (std::size_t word = 0; word < entry.inverted_words.size(); ++word) {
    entry.inverted_words[word] = static_cast<std::uint16_t>(parameter(object, kInvertWords, word));
    entry.bits_of_words.push_back({word, 0, source(object, kWords, word)});
  }
}

void Wiring::connect_sent(Object& entry) noexcept {
  const DriveObject& object = *entry.object;
  entry.sent_words.clear();
  entry.sent_double_words.clear();
  entry.object->process_data().sent = {};
  const auto add = [&](std::uint16_t number, std::size_t count, std::vector<Place>& places) {
    for (std::size_t word = 0; word < count; ++word)
      if (parameter(object, number, word) > 0.0) places.push_back({word, 0, source(object, number, word)});
  };
  add(kSentWords, ProcessDataImage::kSentWords, entry.sent_words);
  add(kSentDoubleWords, ProcessDataImage::kSentWords - 1, entry.sent_double_words);
}

AxisInputs Wiring::inputs(std::size_t object) const noexcept {
  const Object& entry = objects_[object];
  AxisInputs inputs = entry.constant_inputs;
  for (const auto& link : entry.bits) inputs.*link.member = link.source.bit();
  for (const auto& link : entry.values) inputs.*link.member = link.source.value(link.full);
  inputs.controlword = entry.object->process_data().controlword;
  inputs.requested_mode = entry.object->process_data().requested_mode;
  return inputs;
}

AxisFeedback Wiring::feedback(std::size_t axis) const noexcept {
  const Object& entry = objects_[axis + 1];
  AxisFeedback feedback = entry.constant_feedback;
  feedback.message_setpoint = entry.message_setpoint.value(entry.reference_speed);
  for (const auto& link : entry.status_bits) feedback.*link.member = link.source.bit();
  return feedback;
}

void Wiring::convert_words() noexcept {
  for (Object& entry : objects_)
    for (const Place& place : entry.bits_of_words) {
      const auto word = static_cast<std::uint16_t>(place.source.process_data<std::int16_t>());
      entry.object->process_data().bits_of_words[place.word] =
          static_cast<std::uint16_t>(word ^ entry.inverted_words[place.word]);
    }
}

void Wiring::convert_bits() noexcept {
  for (Object& entry : objects_) {
    auto words = entry.constant_words_of_bits;
    for (const Place& place : entry.words_of_bits)
      words[place.word] =
          static_cast<std::uint16_t>(words[place.word] ^ (static_cast<unsigned>(place.source.bit()) << place.bit));
    entry.object->process_data().words_of_bits = words;
  }
}

void Wiring::lead_outputs() noexcept {
  Terminals::Word word = 0;
  for (std::size_t i = 0; i < outputs_.size(); ++i)
    word |= static_cast<Terminals::Word>(outputs_[i].bit()) << (Terminals::kFirstOutput + i);
  unit_.control_unit().terminals().sources = word;
}

void Wiring::send() noexcept {
  for (Object& entry : objects_) {
    auto& sent = entry.object->process_data().sent;
    for (const Place& place : entry.sent_words)
      sent[place.word] = static_cast<std::uint16_t>(place.source.process_data<std::int16_t>());
    for (const Place& place : entry.sent_double_words)
      ProcessDataImage::set_double_word(sent, place.word,
                                        static_cast<std::uint32_t>(place.source.process_data<std::int32_t>()));
  }
}

}  // namespace drive
