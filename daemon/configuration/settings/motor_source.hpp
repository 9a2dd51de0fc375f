#pragma once

#include <optional>
#include <set>
#include <string>

#include <tl/expected.hpp>

namespace axisd {

/// Where the texts of the motors lie that a configuration names.
class MotorSource {
 public:
  virtual ~MotorSource() = default;

  /// Path of the motor file @p name from the folder of configuration file @p file.
  virtual std::string path_from(const std::string& file, const std::string& name) const = 0;
  /// Path of the preset @p name, if there is one.
  virtual std::optional<std::string> find_preset(const std::string& name) const = 0;
  /// Names of all presets.
  virtual std::set<std::string> presets() const = 0;
  /// The content of the file at @p path, or why it cannot be read: "PATH: cannot be read: WHY".
  virtual tl::expected<std::string, std::string> read(const std::string& path) const = 0;
};

}  // namespace axisd
