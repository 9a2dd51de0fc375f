#pragma once

#include <string>
#include <vector>

#include "daemon/program/configuration_file.hpp"
#include "daemon/program/options.hpp"
#include "tests/daemon/configuration/parse.hpp"

namespace axisd {

/// The one unit that `axisd` takes from the command line @p words.
inline Configuration configuration_of(const std::vector<std::string>& words) {
  std::vector<const char*> arguments{"axisd"};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  return load_configuration(parse_command_line(static_cast<int>(arguments.size()), arguments.data()).value())
      .units.at(0);
}

}  // namespace axisd
