#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "record/reader.hpp"

namespace record {

/// @p record of a file with @p head as one JSON object: `type`, `t` (s since the start of the unit), and what it
/// holds (docs/reference/recording.md).
nlohmann::json json_of(const Record& record, const nlohmann::json& head);
/// The same for people, without an end of line.
std::string text_of(const Record& record, const nlohmann::json& head);

/// How a recording is shown.
enum class Form : std::uint8_t {
  Text,    ///< a line a record
  Json,    ///< a line of JSON a record, the head before them
  Candump  ///< its frames as `candump -l` writes them
};
/// Longest file that is read (bytes): above what a recording may have.
inline constexpr std::size_t kLongestFile = std::size_t{1} << 30;

/// Shows the recording at @p path line by line (without ends of lines). Gives what is to be said of its end, empty
/// if it is whole; or why it cannot be read, in one line.
tl::expected<std::string, std::string> show(const std::string& path, Form form,
                                            const std::function<void(std::string_view)>& line);

}  // namespace record
