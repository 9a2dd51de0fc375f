#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/canopen-check/core/wire.hpp"

namespace conformance {

class Context;

/// What a check is about; the word stands before the dot of its id.
enum class Group : std::uint8_t {
  Static,
  Device,
  Nmt,
  ErrorControl,
  Sdo,
  Pdo,
  Sync,
  Emcy,
  Storage,
  Lss,
  Drive,
  Robustness
};

/// Groups as --only names them, in the order of their checks.
struct GroupName {
  Group group;
  std::string_view word;
  std::string_view title;
};
inline constexpr std::array kGroups{
    GroupName{Group::Static, "static", "EDS, static"},
    GroupName{Group::Device, "device", "EDS against device"},
    GroupName{Group::Nmt, "nmt", "NMT and boot-up"},
    GroupName{Group::ErrorControl, "error-control", "Error control"},
    GroupName{Group::Sdo, "sdo", "SDO"},
    GroupName{Group::Pdo, "pdo", "PDO"},
    GroupName{Group::Sync, "sync", "SYNC and TIME"},
    GroupName{Group::Emcy, "emcy", "EMCY and error history"},
    GroupName{Group::Storage, "storage", "Store and restore"},
    GroupName{Group::Lss, "lss", "LSS"},
    GroupName{Group::Drive, "drive", "CiA 402"},
    GroupName{Group::Robustness, "robustness", "Robustness"},
};

/// The row of @p group.
[[nodiscard]] constexpr const GroupName& name_of(Group group) noexcept {
  return kGroups[static_cast<std::size_t>(group)];
}

/// How far a run may go; each mode includes those before it.
enum class Mode : std::uint8_t {
  Static,    ///< the EDS alone, no bus
  ReadOnly,  ///< reads over SDO, listens, and changes nothing on the node
  Full,      ///< writes and restores, NMT commands, resets
};

/// One check.
struct Check {
  std::string_view id;      ///< "sdo.toggle-bit": stable, in reports and lists of deviations
  std::string_view name;    ///< what is right, as a sentence
  std::string_view clause;  ///< that it rests on: "CiA 301 7.2.4.3.6"
  Group group = Group::Static;
  Mode mode = Mode::Full;  ///< least mode in which it runs
  bool stores = false;     ///< needs --allow-store
  bool moves = false;      ///< needs --allow-motion
  void (*run)(Context&) = nullptr;
};

/// True if @p word is the group of @p check, or its id begins so.
[[nodiscard]] bool is_named(const Check& check, std::string_view word) noexcept;

/// What a finding is about: an entry of the dictionary, an object, or the node as a whole.
struct Subject {
  std::optional<std::uint16_t> index{};
  std::optional<std::uint8_t> sub_index{};

  friend bool operator==(const Subject&, const Subject&) = default;
};

/// "1018h:01", "1018h", or nothing for the node as a whole.
[[nodiscard]] std::string to_text(const Subject& subject);

/// Something that is not as it should be.
struct Finding {
  Subject subject{};
  std::string expected{};
  std::string found{};
  std::vector<TimedFrame> frames{};  ///< sent and received for it, the last ones
  std::string deviation{};           ///< the reason of the known deviation that it is; else empty
};

/// What became of a check.
enum class Outcome : std::uint8_t {
  Passed,
  Deviates,  ///< every finding is a known deviation
  Failed,
  Skipped,  ///< for the reason given
  Broken,   ///< could not be ended: the bus went down, the node is gone, the user interrupted
};

/// The word for @p outcome in reports.
[[nodiscard]] std::string_view word_of(Outcome outcome) noexcept;

/// A check that was run, or not.
struct CheckResult {
  const Check* check = nullptr;
  Outcome outcome = Outcome::Passed;
  std::string reason{};  ///< of Skipped and Broken
  std::vector<Finding> findings{};
  std::vector<std::string> notes{};  ///< what was measured
  canopen::Duration time{};
};

}  // namespace conformance
