#include "cia402/bus/axis_objects.hpp"

#include <algorithm>
#include <array>

#include "cia402/modes/homing/homing_methods.hpp"
#include "cia402/objects/object_index.hpp"

namespace cia402 {
namespace {

using canopen::AbortCode;

/// A rule for what may be written to an object of the first axis.
struct Rule {
  std::uint16_t index;
  std::optional<AbortCode> (*objection)(const Axis& axis, std::int64_t value) noexcept;
};

constexpr unsigned kSupportedModes = 0b111'1101'1111;  // 6060h: 0 to 4, 6 to 10
constexpr std::int64_t kHighestMode = 10;
/// 60F2h: bits 0..1 what relative counts from, 4..5 the acknowledgement, 6..7 the way on a rotary axis.
constexpr std::int64_t kPositioningOptions = 0x00F3;

std::optional<AbortCode> if_not(bool allowed, AbortCode code) noexcept {
  return allowed ? std::nullopt : std::optional{code};
}
std::optional<AbortCode> only_without_operation(const Axis& axis, std::int64_t) noexcept {
  return if_not(axis.state() != State::OperationEnabled, AbortCode::DeviceState);
}

constexpr std::array kRules{
    Rule{object::kModesOfOperation,
         [](const Axis&, std::int64_t value) noexcept {
           const bool exists =
               value >= 0 && value <= kHighestMode && (kSupportedModes >> static_cast<unsigned>(value) & 1U) != 0;
           return if_not(exists, AbortCode::InvalidValue);
         }},
    Rule{object::kHomingMethod,
         [](const Axis&, std::int64_t value) noexcept {
           const bool exists = value == 0 || find_homing_method(static_cast<std::int32_t>(value)) != nullptr;
           return if_not(exists, AbortCode::InvalidValue);
         }},
    Rule{object::kPositioningOption,
         [](const Axis&, std::int64_t value) noexcept {
           const bool exists =
               (value & ~kPositioningOptions) == 0 && (value & 0x3) != 0x3 && (value & 0x30) != 0x30;
           return if_not(exists, AbortCode::InvalidValue);
         }},
    Rule{object::kPolarity, only_without_operation},
    Rule{object::kGearRatio, only_without_operation},
    Rule{object::kFeedConstant, only_without_operation},
};

/// Objects that others are relative to.
constexpr std::array kScales{object::kPolarity, object::kGearRatio, object::kFeedConstant};

}  // namespace

AxisObjects::AxisObjects(std::size_t number, canopen::Dictionary& dictionary, const AxisSetup& setup,
                         AxisListener& faults, WriteListener& writes)
    : number_{number},
      dictionary_{dictionary},
      writes_{writes},
      values_{dictionary, number},
      axis_{number, values_, setup, faults} {
  for (const canopen::Entry& entry : dictionary.entries()) {
    if (entry.index < object::kFirstProfileObject || !entry.writable || object::axis_of(entry.index) != number)
      continue;
    const std::uint16_t first = object::index_on_first_axis(entry.index);
    const bool is_ruled = std::ranges::find(kRules, first, &Rule::index) != kRules.end();
    if (acting_of(first) != 0 || is_ruled || first == object::kPositionRangeLimit)
      dictionary.own_write(entry.index, entry.sub_index, *this);
  }
}

/// What acts, acts within the write: the answer comes behind it.
canopen::Result<void> AxisObjects::write(const canopen::Entry& entry, std::int64_t value) {
  const std::uint16_t first = object::index_on_first_axis(entry.index);
  const auto* const rule = std::ranges::find(kRules, first, &Rule::index);
  if (rule != kRules.end())
    if (const auto code = rule->objection(axis_, value)) return canopen::refuse(*code);
  dictionary_.set(entry, value);
  if (std::ranges::find(kScales, first) != kScales.end()) axis_.scale();
  if (first == object::kPositionRangeLimit) axis_.show_range();
  if (const ActingSet acting = acting_of(first); acting != 0) writes_.on_acting(number_ - 1, acting);
  return {};
}

}  // namespace cia402
