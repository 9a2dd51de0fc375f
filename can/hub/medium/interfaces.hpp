#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "can/userbus/protocol.hpp"

namespace hub {

/// The names of the bus: all of them mean the same wire. A name gets its index when it is mentioned first, and
/// keeps it. Only if there are kMost does the one that nobody is bound to, and that was not mentioned longest,
/// make room for another, whose index is new.
class Interfaces {
 public:
  /// Index of the first name; high, so that it is none of a real interface.
  static constexpr int kFirstIndex = 1001;
  /// More names are not taken at a time.
  static constexpr std::size_t kMost = 256;
  /// The name that the bus gets if a frame needs one and nobody has given any.
  static constexpr std::string_view kFallbackName = "can0";

  Interfaces();

  /// Index of @p name, which is taken up if it is new; 0 if it is no name of a CAN interface
  /// (userbus::is_can_name), or one too many.
  int index_of(std::string_view name) noexcept;
  /// Somebody is bound to @p index; an index that is none is nobody's.
  void hold(int index) noexcept;
  /// Somebody who was is not any more.
  void release(int index) noexcept;
  /// Name of @p index; empty if there is none.
  [[nodiscard]] std::string_view name_of(int index) const noexcept;
  /// Index for a frame that came without a name: that of the first name.
  int common_index() noexcept;
  /// All names.
  [[nodiscard]] std::span<const userbus::InterfaceEntry> entries() const noexcept { return entries_; }

 private:
  /// Who cares for an entry.
  struct Use {
    std::size_t members = 0;
    std::uint64_t mentioned = 0;  // when, counted in mentions
  };

  [[nodiscard]] std::size_t place_of(int index) const noexcept;
  [[nodiscard]] std::size_t free_place() noexcept;

  std::vector<userbus::InterfaceEntry>
      entries_;  // has room for kMost: never allocates; place = index modulo kMost
  std::array<Use, kMost> uses_{};
  std::uint64_t mentions_ = 0;
};

}  // namespace hub
