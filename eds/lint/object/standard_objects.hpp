#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "eds/document/finding.hpp"
#include "eds/sheet/names.hpp"

/// What CiA 301 and CiA 302 say of the objects 1000h to 1FFFh.
namespace eds {

/// Which access an entry may have. A device may make constant what the standard lets a master set, so that most
/// settings may be read only; what can be written though it must not be is told apart from that.
struct AccessRule {
  std::string_view words{};  ///< what is right
  std::uint8_t allowed = 0;  ///< a bit for each canopen::Access; 0: anything
  Severity severity = Severity::Error;

  [[nodiscard]] constexpr bool allows(canopen::Access access) const noexcept {
    return allowed == 0 || (allowed >> static_cast<unsigned>(access) & 1U) != 0;
  }
};

/// Values that the standard defines.
struct ValueRule {
  struct Range {
    std::uint64_t first = 1, last = 0;  ///< of which there is none unless they say otherwise
  };
  std::string_view words{};  ///< what is right; empty: anything
  std::array<Range, 2> ranges{};
  Severity severity = Severity::Error;

  [[nodiscard]] bool allows(std::uint64_t value) const noexcept;
};

/// Sub-indices that are alike, of objects that are alike.
struct StandardEntry {
  std::uint16_t first = 0;  ///< index of the first object
  std::uint16_t last = 0;   ///< of the last one
  ObjectCode code = ObjectCode::Variable;
  std::uint8_t first_sub = 0;
  std::uint8_t last_sub = 0;
  std::uint16_t type = 0;  ///< number of the data type; 0: the standard leaves it open, or another rule has it
  std::uint16_t other_type = 0;  ///< that of another edition; 0: none
  AccessRule access{};
  ValueRule values{};
  std::optional<std::uint64_t> standard_default{};  ///< where no other one makes sense
  bool needed = false;                              ///< the object is nothing without it
  bool mappable = false;
  bool framework = false;  ///< of CiA 302, whose parts differ between editions: warnings only

  /// True when it describes @p index.
  [[nodiscard]] constexpr bool has_object(std::uint16_t index) const noexcept {
    return index >= first && index <= last;
  }
  /// True when it describes the entry.
  [[nodiscard]] constexpr bool contains(std::uint16_t index, std::uint8_t sub_index) const noexcept {
    return has_object(index) && sub_index >= first_sub && sub_index <= last_sub;
  }
};

/// Every entry of the standards, ascending by index and sub-index.
[[nodiscard]] std::span<const StandardEntry> standard_entries() noexcept;

/// The rows of object @p index; none where the standards do not define it.
[[nodiscard]] std::span<const StandardEntry> standard_entries(std::uint16_t index) noexcept;

/// The row of an entry, or null.
[[nodiscard]] const StandardEntry* find_standard_entry(std::uint16_t index, std::uint8_t sub_index) noexcept;

}  // namespace eds
