#pragma once

#include <string>

#include <tl/expected.hpp>

#include "daemon/configuration/configuration.hpp"
#include "daemon/program/options.hpp"

namespace axisd {

/// The content of @p file, or why it cannot be read: "FILE: cannot be read: WHY".
tl::expected<std::string, std::string> read_text_file(const std::string& file);

/// The configuration that @p options ask for; reads the file they name. Throws ConfigurationError, or UsageError
/// for options that a list of units leaves no room for.
UnitsConfiguration load_configuration(const Options& options);

}  // namespace axisd
