#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace drive {

/// What leads the setpoint; one at a time.
enum class PositionerMode : std::uint8_t { Basic, Jog, Search, Blocks, Mdi };
inline constexpr std::size_t kPositionerModes = 5;

/// What r2669 shows of a mode; MDI shows more (see MdiMode).
inline constexpr std::array<int, kPositionerModes> kModeCodes{0, 1, 2, 4, 8};
constexpr int code_of(PositionerMode mode) noexcept {
  return kModeCodes[static_cast<std::size_t>(mode)];
}
/// The modes in words.
inline constexpr std::array<std::string_view, kPositionerModes> kModeNames{"none", "jog", "reference search",
                                                                           "traversing blocks", "MDI positioning"};
constexpr std::string_view name_of(PositionerMode mode) noexcept {
  return kModeNames[static_cast<std::size_t>(mode)];
}
inline constexpr int kSettingUpCode = 0x10;
inline constexpr int kFlyingCode = 0x20;

/// What asks for a mode.
enum class ModeRequest : std::uint8_t { Jog, Search, Block, Mdi };

/// What becomes of a request while a mode is active.
struct ModeSwitch {
  enum class Kind : std::uint8_t {
    Start,  ///< the mode begins, or the mode that is active takes it as a further order
    Refuse,
    Ignore,
  };
  Kind kind = Kind::Start;
  std::uint8_t alarm_value = 0;  ///< of A07457, where it is refused
};

namespace mode_switch {
inline constexpr ModeSwitch kStart{};
inline constexpr ModeSwitch kIgnore{ModeSwitch::Kind::Ignore, 0};
constexpr ModeSwitch refuse(std::uint8_t value) noexcept {
  return {ModeSwitch::Kind::Refuse, value};
}
}  // namespace mode_switch

/// The table of requests (rows, in the order of ModeRequest) and active modes (columns, in the order of
/// PositionerMode); function diagram 3625 and the list of values of A07457.
inline constexpr std::array<std::array<ModeSwitch, kPositionerModes>, 4> kModeSwitches = [] {
  using namespace mode_switch;
  return std::array<std::array<ModeSwitch, kPositionerModes>, 4>{{
      {kStart, kStart, refuse(2), refuse(3), refuse(1)},   // jog
      {kStart, refuse(2), kIgnore, refuse(6), refuse(4)},  // search
      {kStart, refuse(3), refuse(6), kStart, refuse(5)},   // block
      {kStart, refuse(1), refuse(4), refuse(5), kStart},   // MDI
  }};
}();

/// What becomes of @p request while @p active is.
constexpr const ModeSwitch& switch_of(ModeRequest request, PositionerMode active) noexcept {
  return kModeSwitches[static_cast<std::size_t>(request)][static_cast<std::size_t>(active)];
}

/// What A07457 shows of two requests that come together.
constexpr std::uint8_t alarm_value(ModeRequest first, ModeRequest second) noexcept {
  constexpr std::array kModes{PositionerMode::Jog, PositionerMode::Search, PositionerMode::Blocks,
                              PositionerMode::Mdi};
  return switch_of(second, kModes[static_cast<std::size_t>(first)]).alarm_value;
}

}  // namespace drive
