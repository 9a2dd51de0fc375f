#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "trace/event.hpp"
#include "trace/frame.hpp"
#include "trace/settings.hpp"

namespace trace {

/// Arguments of a trigger, a bit each.
enum TriggerArgument : std::uint16_t {
  kTakesSignal = 0x01,
  kTakesLevel = 0x02,
  kTakesBand = 0x04,
  kTakesBits = 0x08,
  kTakesPlace = 0x10,
  kTakesNumber = 0x20,
  kTakesState = 0x40,
  kTakesFrame = 0x80,
};

/// One kind of trigger: what it is called, what it takes, and the one function that says whether it holds.
struct TriggerRow {
  TriggerKind kind;
  std::string_view name;  ///< key "on"
  std::uint16_t arguments;
  std::string_view meaning;
  /// Of the value of the signal @p before and @p now, one step apart.
  bool (*reached)(const TriggerSettings& settings, double before, double now) noexcept = nullptr;
  bool (*happened)(const TriggerSettings& settings, const Event& event) noexcept = nullptr;
  bool (*seen)(const TriggerSettings& settings, const Frame& frame) noexcept = nullptr;
};

/// One row a kind, in their order.
std::span<const TriggerRow> trigger_rows() noexcept;
const TriggerRow& row_of(TriggerKind kind) noexcept;
/// The row of the kind called @p name; nullptr if there is none.
const TriggerRow* find_trigger(std::string_view name) noexcept;

}  // namespace trace
