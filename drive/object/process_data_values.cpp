#include "drive/values/process_data_values.hpp"

#include "drive/object/drive_object.hpp"

namespace drive::process_value {

double controlword(const DriveObject& object, std::size_t) noexcept {
  return object.process_data().unplaced.controlword;
}
double vl_velocity(const DriveObject& object, std::size_t) noexcept {
  return object.process_data().unplaced.speed_rpm;
}
double velocity(const DriveObject& object, std::size_t) noexcept {
  return object.process_data().unplaced.speed_increments;
}
double torque(const DriveObject& object, std::size_t) noexcept {
  return object.process_data().unplaced.torque;
}
double free_word(const DriveObject& object, std::size_t index) noexcept {
  return object.process_data().unplaced.words[index];
}
double free_double_word(const DriveObject& object, std::size_t index) noexcept {
  return object.process_data().unplaced.double_words[index];
}
double interface_state(const DriveObject& object, std::size_t index) noexcept {
  return object.process_data().interface_state[index] ? 1.0 : 0.0;
}
double board_state(const DriveObject& object, std::size_t) noexcept {
  constexpr std::size_t kNoSetpoints = 0, kBusRuns = 2;
  constexpr double kAcyclic = 5.0, kWithoutSetpoints = 6.0, kCyclic = 255.0;
  const auto& state = object.process_data().interface_state;
  if (!state[kBusRuns]) return kAcyclic;
  return state[kNoSetpoints] ? kWithoutSetpoints : kCyclic;
}
double received_word(const DriveObject& object, std::size_t place) noexcept {
  return static_cast<std::int16_t>(object.process_data().received[place]);
}
double received_double_word(const DriveObject& object, std::size_t place) noexcept {
  return static_cast<std::int32_t>(ProcessDataImage::double_word(object.process_data().received, place));
}
double sent_word(const DriveObject& object, std::size_t place) noexcept {
  return object.process_data().sent[place];
}
double sent_double_word(const DriveObject& object, std::size_t place) noexcept {
  return ProcessDataImage::double_word(object.process_data().sent, place);
}
double word_of_bits(const DriveObject& object, std::size_t index) noexcept {
  return object.process_data().words_of_bits[index];
}

template <std::size_t Place>
double received_bits(const DriveObject& object, std::size_t) noexcept {
  return object.process_data().received[Place];
}
template double received_bits<0>(const DriveObject&, std::size_t) noexcept;
template double received_bits<1>(const DriveObject&, std::size_t) noexcept;
template double received_bits<2>(const DriveObject&, std::size_t) noexcept;
template double received_bits<3>(const DriveObject&, std::size_t) noexcept;

template <std::size_t Which>
double converted_bits(const DriveObject& object, std::size_t) noexcept {
  return object.process_data().bits_of_words[Which];
}
template double converted_bits<0>(const DriveObject&, std::size_t) noexcept;
template double converted_bits<1>(const DriveObject&, std::size_t) noexcept;

}  // namespace drive::process_value
