#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "userbus/protocol.hpp"

namespace hub {

/// The names of the bus: all of them mean the same wire. A name gets its index when it is mentioned first, and
/// keeps it as long as the hub runs.
class Interfaces {
 public:
  /// Index of the first name; high, so that it is none of a real interface.
  static constexpr int kFirstIndex = 1001;
  /// More names are not taken.
  static constexpr std::size_t kMost = 256;
  /// The name that the bus gets if a frame needs one and nobody has given any.
  static constexpr std::string_view kFallbackName = "can0";

  Interfaces();

  /// Index of @p name, which is taken up if it is new; 0 if it is no name of a CAN interface
  /// (userbus::is_can_name), or one too many.
  int index_of(std::string_view name) noexcept;
  /// Name of @p index; empty if there is none.
  [[nodiscard]] std::string_view name_of(int index) const noexcept;
  /// Index for a frame that came without a name: that of the first name.
  int common_index() noexcept;
  /// All names, in the order of their indexes.
  [[nodiscard]] std::span<const userbus::InterfaceEntry> entries() const noexcept { return entries_; }

 private:
  std::vector<userbus::InterfaceEntry> entries_;  // has room for kMost: never allocates
};

}  // namespace hub
