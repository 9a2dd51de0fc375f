#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "farm/documents/door_beat.hpp"

namespace farm {

/// On the time line of os::monotonic_time().
using Instant = std::chrono::nanoseconds;

/// Why a unit cannot be reached.
struct Absence {
  std::string host;      ///< where it was, empty: it is none of the farm
  Instant silent_for{};  ///< since when this host has told nothing
};

/// Which units a farm has, and on which hosts they are, by what the doors of the hosts tell. A host that has told
/// nothing for some time is silent: nothing is known of its units but that they were there.
class Directory {
 public:
  struct Entry {
    std::string host;
    DoorUnit unit;
    Instant since{};  ///< when it was told of first
  };

  /// Hosts are silent when they have told nothing for @p silence.
  explicit Directory(Instant silence) noexcept : silence_{silence} {}

  /// Takes in @p beat, which has come at @p now. True if units have come, gone or changed by it.
  bool take(const DoorBeat& beat, Instant now);
  /// Where @p unit is. If two hosts have it, that one has it that told of it last.
  [[nodiscard]] tl::expected<Entry, Absence> find(const UnitName& unit, Instant now) const;
  /// All units in the order of their names, without those of hosts that are silent.
  [[nodiscard]] std::vector<Entry> units(Instant now) const;
  /// The hosts that have fallen silent since the last call.
  [[nodiscard]] std::vector<std::string> take_silent(Instant now);

 private:
  using Units = std::map<UnitName, Entry>;
  struct Host {
    Instant heard{};
    bool is_silent = false;
    std::uint64_t instance = 0;
    Units units;
    Units coming;                   ///< of the parts that have come
    std::set<std::uint32_t> parts;  ///< numbers of these parts
  };

  [[nodiscard]] bool is_silent(const Host& host, Instant now) const noexcept {
    return now - host.heard > silence_;
  }

  Instant silence_;
  std::map<std::string, Host> hosts_;
};

}  // namespace farm
