#pragma once

#include <string>
#include <string_view>

#include "daemon/configuration/configuration.hpp"
#include "daemon/program/motor_folders.hpp"

namespace axisd {

/// The one unit that @p text describes as the content of @p file, with the motors that the program finds.
inline Configuration parse_configuration(std::string_view text, const std::string& file) {
  return parse_configuration(text, file, MotorFolders{}).units.at(0);
}

}  // namespace axisd
