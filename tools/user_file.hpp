#pragma once

#include <string>

namespace tools {

/// The text of the file that a user has named. Throws cli::UsageError with what read_sheet_file() says.
[[nodiscard]] std::string read_user_file(const std::string& path);

/// Throws cli::UsageError unless a report can be written to @p path: at once, not after the run that it is about.
/// An empty one is none.
void expect_writable(const std::string& path);

/// Writes @p text into the file @p path; an empty one is none. Throws cli::UsageError if it cannot be written as a
/// whole.
void write_user_file(const std::string& path, const std::string& text);

}  // namespace tools
