#pragma once

#include "daemon/configuration/settings/motor_source.hpp"

namespace axisd {

/// Motor files, and the presets: those of the user ($XDG_CONFIG_HOME/axisd/motors) and those that were installed
/// or built with the program (share/axisd/motors in a folder above it).
class MotorFolders final : public MotorSource {
 public:
  std::string path_from(const std::string& file, const std::string& name) const override;
  std::optional<std::string> find_preset(const std::string& name) const override;
  std::set<std::string> presets() const override;
  tl::expected<std::string, std::string> read(const std::string& path) const override;
};

}  // namespace axisd
