#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace with_can {

/// Name or path of the program that interprets the script @p path: that of its line `#!`, through env(1). Empty if
/// it has no such line: then the shell does. Nothing if the file cannot be read.
std::optional<std::string> interpreter_of_script(const std::filesystem::path& path);

/// The same, from the script's @p first_line.
std::string interpreter_of_line(std::string_view first_line);

}  // namespace with_can
