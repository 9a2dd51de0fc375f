#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "farm/agent/plan/kept_state.hpp"
#include "farm/naming/unit_name.hpp"

namespace farm::agent {

/// Where an agent has its files.
struct Folders {
  std::string runtime;  ///< sockets and configurations; gone after a start of the machine
  std::string state;    ///< what units save

  [[nodiscard]] std::string bus(const std::string& bus) const { return runtime + '/' + bus; }
  /// Socket of the hub of @p bus.
  [[nodiscard]] std::string hub(const std::string& bus) const { return this->bus(bus) + "/can-bus"; }
  /// Control socket of @p unit.
  [[nodiscard]] std::string socket(const UnitName& unit) const;
  /// Configuration file of @p unit.
  [[nodiscard]] std::string configuration(const UnitName& unit) const;
  /// Folder of what @p unit saves.
  [[nodiscard]] std::string saved(const UnitName& unit) const;
  /// What @p unit has saved: the file that axisd writes.
  [[nodiscard]] std::string parameters(const UnitName& unit) const;
  /// What the agent keeps beside it.
  [[nodiscard]] std::string note(const UnitName& unit) const;
};

/// What an agent keeps beside the state of a unit.
struct UnitNote {
  KeptState kept;
  std::string configuration;              ///< JSON, with which it was started last
  std::optional<std::uint32_t> uploaded;  ///< checksum of the parameters that are on the server; nothing: none are

  friend bool operator==(const UnitNote&, const UnitNote&) = default;
};

[[nodiscard]] std::string text_of(const UnitNote& note);
/// One that cannot be read is nothing: what lies on the server counts then.
[[nodiscard]] std::optional<UnitNote> parse_unit_note(std::string_view text);

/// Whether a file is on the disk, be it after seconds, when it is said to be written.
enum class Write : bool { ToCache, ToDisk };
/// Replaces the file at @p path as a whole, and makes its folder if it is missing, for this user alone; the error
/// is one line.
[[nodiscard]] tl::expected<void, std::string> replace_file(const std::string& path, std::string_view content,
                                                           Write write = Write::ToCache);
/// What @p unit has saved; nothing if that is nothing. The error is one line: it has, and that cannot be read now.
[[nodiscard]] tl::expected<std::optional<std::string>, std::string> read_parameters(const Folders& folders,
                                                                                    const UnitName& unit);
/// Checksum of what @p unit has saved; nothing if it has saved nothing. The error as above.
[[nodiscard]] tl::expected<std::optional<std::uint32_t>, std::string> checksum_of_parameters(
    const Folders& folders, const UnitName& unit);
/// What is kept of @p unit, by its file; nothing that counts if there is none. The error is one line: there is
/// one, and it cannot be read now.
[[nodiscard]] tl::expected<UnitNote, std::string> read_note(const Folders& folders, const UnitName& unit);

/// The configuration file of @p unit: @p configuration and what its name says. The error is one line.
[[nodiscard]] tl::expected<std::string, std::string> configuration_file(const Folders& folders,
                                                                        const UnitName& unit,
                                                                        const std::string& configuration);

}  // namespace farm::agent
