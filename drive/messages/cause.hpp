#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace drive {

/// On which side of its threshold a quantity is a cause.
enum class Side : std::uint8_t { Above, Below };
/// With which pulses it is judged.
enum class Pulses : std::uint8_t { Any, On, Off };

/// A number, a setting of @p Block, or what it computes.
template <class Block>
struct CauseLimit {
  using Getter = double (Block::*)() const noexcept;
  using Setting = double Block::Settings::*;

  // NOLINTBEGIN(google-explicit-constructor): a table of causes reads as one
  constexpr CauseLimit(double value) noexcept : kind{Kind::Number}, number{value} {}
  constexpr CauseLimit(Getter value) noexcept : kind{Kind::Getter}, getter{value} {}
  constexpr CauseLimit(Setting value) noexcept : kind{Kind::Setting}, setting{value} {}
  // NOLINTEND(google-explicit-constructor)

  constexpr double of(const Block& block) const noexcept {
    if (kind == Kind::Getter) return (block.*getter)();
    return kind == Kind::Setting ? block.settings.*setting : number;
  }
  /// Whether it is the number 0.
  constexpr bool is_zero() const noexcept { return kind == Kind::Number && !(number > 0.0); }

  enum class Kind : std::uint8_t { Number, Getter, Setting };
  Kind kind;
  double number = 0.0;
  Getter getter = nullptr;
  Setting setting = nullptr;
};

/// What a message value shows: a quantity of @p Block, or nothing (0).
template <class Block>
struct CauseValue {
  using Getter = double (Block::*)() const noexcept;

  // NOLINTBEGIN(google-explicit-constructor): as above
  constexpr CauseValue(std::nullptr_t) noexcept {}
  constexpr CauseValue(Getter value) noexcept : getter{value}, is_shown{true} {}
  // NOLINTEND(google-explicit-constructor)

  Getter getter = nullptr;
  bool is_shown = false;
};

/// One cause of a fault or an alarm in a quantity of @p Block. Rows of the same message belong to one block.
template <class Block>
struct CauseRow {
  using Quantity = double (Block::*)() const noexcept;

  std::uint16_t message = 0;
  Quantity quantity = nullptr;
  Side side = Side::Above;
  CauseLimit<Block> threshold = 0.0;
  double hysteresis = 0.0;        ///< what the quantity has to go back by before the cause is gone
  CauseLimit<Block> delay = 0.0;  ///< so long it has to hold (s)
  Pulses pulses = Pulses::Any;
  CauseValue<Block> value = nullptr;  ///< what the message value shows
  double value_scale = 0.0;
  std::string_view source;
};

/// The causes of @p Block, an array of CauseRow; a block that has some specialises it behind its class.
template <class Block>
inline constexpr std::array<std::byte, 0> causes_of{};

/// Words for the tables.
namespace cause {
inline constexpr double kNone = 0.0;
inline constexpr double kAtOnce = 0.0;  // s
inline constexpr double kYes = 0.5;     // between 0 and 1
}  // namespace cause

}  // namespace drive
