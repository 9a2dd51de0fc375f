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
double board_state(const DriveObject& object, std::size_t) noexcept {
  constexpr std::size_t kNoSetpoints = 0, kBusRuns = 2;
  constexpr double kAcyclic = 5.0, kWithoutSetpoints = 6.0, kCyclic = 255.0;
  const auto& state = object.process_data().interface_state;
  if (!state[kBusRuns]) return kAcyclic;
  return state[kNoSetpoints] ? kWithoutSetpoints : kCyclic;
}
double if1_state(const DriveObject& object, std::size_t) noexcept {
  const auto& state = object.if1().interface_state;
  double bits = 0.0;
  for (std::size_t i = 0; i < state.size(); ++i) bits += state[i] ? static_cast<double>(1U << i) : 0.0;
  return bits;
}

namespace {

template <PzdInterface Interface>
const auto& image_of(const DriveObject& object) noexcept {
  if constexpr (Interface == PzdInterface::If1)
    return object.if1();
  else
    return object.process_data();
}

}  // namespace

template <PzdInterface Interface>
double interface_state(const DriveObject& object, std::size_t index) noexcept {
  return image_of<Interface>(object).interface_state[index] ? 1.0 : 0.0;
}
template <PzdInterface Interface>
double received_word(const DriveObject& object, std::size_t place) noexcept {
  return static_cast<std::int16_t>(image_of<Interface>(object).received[place]);
}
template <PzdInterface Interface>
double received_double_word(const DriveObject& object, std::size_t place) noexcept {
  return static_cast<std::int32_t>(ProcessDataImage::double_word(image_of<Interface>(object).received, place));
}
template <PzdInterface Interface>
double sent_word(const DriveObject& object, std::size_t place) noexcept {
  return image_of<Interface>(object).sent[place];
}
template <PzdInterface Interface>
double sent_double_word(const DriveObject& object, std::size_t place) noexcept {
  return ProcessDataImage::double_word(image_of<Interface>(object).sent, place);
}
template <PzdInterface Interface>
double word_of_bits(const DriveObject& object, std::size_t index) noexcept {
  return image_of<Interface>(object).words_of_bits[index];
}
template <PzdInterface Interface, std::size_t Place>
double received_bits(const DriveObject& object, std::size_t) noexcept {
  return image_of<Interface>(object).received[Place];
}
template <PzdInterface Interface, std::size_t Which>
double converted_bits(const DriveObject& object, std::size_t) noexcept {
  return image_of<Interface>(object).bits_of_words[Which];
}

template double interface_state<PzdInterface::If1>(const DriveObject&, std::size_t) noexcept;
template double interface_state<PzdInterface::If2>(const DriveObject&, std::size_t) noexcept;
template double received_word<PzdInterface::If1>(const DriveObject&, std::size_t) noexcept;
template double received_word<PzdInterface::If2>(const DriveObject&, std::size_t) noexcept;
template double received_double_word<PzdInterface::If1>(const DriveObject&, std::size_t) noexcept;
template double received_double_word<PzdInterface::If2>(const DriveObject&, std::size_t) noexcept;
template double sent_word<PzdInterface::If1>(const DriveObject&, std::size_t) noexcept;
template double sent_word<PzdInterface::If2>(const DriveObject&, std::size_t) noexcept;
template double sent_double_word<PzdInterface::If1>(const DriveObject&, std::size_t) noexcept;
template double sent_double_word<PzdInterface::If2>(const DriveObject&, std::size_t) noexcept;
template double word_of_bits<PzdInterface::If1>(const DriveObject&, std::size_t) noexcept;
template double word_of_bits<PzdInterface::If2>(const DriveObject&, std::size_t) noexcept;
template double received_bits<PzdInterface::If1, 0>(const DriveObject&, std::size_t) noexcept;
template double received_bits<PzdInterface::If1, 1>(const DriveObject&, std::size_t) noexcept;
template double received_bits<PzdInterface::If1, 2>(const DriveObject&, std::size_t) noexcept;
template double received_bits<PzdInterface::If1, 3>(const DriveObject&, std::size_t) noexcept;
template double converted_bits<PzdInterface::If1, 0>(const DriveObject&, std::size_t) noexcept;
template double converted_bits<PzdInterface::If1, 1>(const DriveObject&, std::size_t) noexcept;
template double received_bits<PzdInterface::If2, 0>(const DriveObject&, std::size_t) noexcept;
template double received_bits<PzdInterface::If2, 1>(const DriveObject&, std::size_t) noexcept;
template double received_bits<PzdInterface::If2, 2>(const DriveObject&, std::size_t) noexcept;
template double received_bits<PzdInterface::If2, 3>(const DriveObject&, std::size_t) noexcept;
template double converted_bits<PzdInterface::If2, 0>(const DriveObject&, std::size_t) noexcept;
template double converted_bits<PzdInterface::If2, 1>(const DriveObject&, std::size_t) noexcept;

}  // namespace drive::process_value
