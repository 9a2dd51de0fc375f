#include "device/process_data/process_objects.hpp"

#include "drive/base/units.hpp"

namespace device {
namespace {

constexpr double kWord = 0x4000;            // 100 %
constexpr double kDoubleWord = 0x40000000;  // 100 %

std::uint32_t word(double relative) noexcept {
  return static_cast<std::uint16_t>(drive::saturated<std::int16_t>(relative * kWord));
}
std::uint32_t double_word(double relative) noexcept {
  return static_cast<std::uint32_t>(drive::saturated<std::int32_t>(relative * kDoubleWord));
}
double relative_word(std::uint32_t word) noexcept {
  return static_cast<std::int16_t>(word) / kWord;
}
double relative_double_word(std::uint32_t word) noexcept {
  return static_cast<std::int32_t>(word) / kDoubleWord;
}

}  // namespace

std::uint32_t WordScaling::words(WordForm form, std::int64_t bus) const noexcept {
  switch (form) {
    case WordForm::Speed:
      return double_word(bus_.speed_from_bus(static_cast<std::int32_t>(bus)) / speed_);
    case WordForm::Rpm:
      return word(static_cast<double>(bus) * drive::kRpm / speed_);
    case WordForm::Torque:
      return word(bus_.torque_from_bus(static_cast<std::int16_t>(bus)) / torque_);
    case WordForm::Raw:
      break;
  }
  return static_cast<std::uint32_t>(bus);
}

std::int64_t WordScaling::bus(WordForm form, std::uint32_t words) const noexcept {
  switch (form) {
    case WordForm::Speed:
      return bus_of(form, relative_double_word(words) * speed_);
    case WordForm::Rpm:
      return bus_of(form, relative_word(words) * speed_);
    case WordForm::Torque:
      return bus_of(form, relative_word(words) * torque_);
    case WordForm::Raw:
      break;
  }
  return words;
}

std::int64_t WordScaling::bus_of(WordForm form, double value) const noexcept {
  switch (form) {
    case WordForm::Speed:
      return bus_.speed_to_bus(value);
    case WordForm::Rpm:
      return drive::saturated<std::int16_t>(value / drive::kRpm);
    case WordForm::Torque:
      return bus_.torque_to_bus(value);
    case WordForm::Raw:
      break;
  }
  return static_cast<std::int64_t>(value);
}

}  // namespace device
