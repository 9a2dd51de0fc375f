#pragma once

#include <string>

#include <tl/expected.hpp>

namespace CLI {
class App;
}

namespace farm {

/// Gives @p app the option --host, whose word is read into @p word.
void add_host(CLI::App& app, std::string& word);
/// The host that @p word names, that of the machine if it is empty; the error is one line, which names the option.
[[nodiscard]] tl::expected<std::string, std::string> read_host(const std::string& word);

}  // namespace farm
