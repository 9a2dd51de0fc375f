#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/axisctl/connection/failure.hpp"

namespace axisctl {

/// A recording as it is put into a page.
struct Recording {
  std::string name;       ///< of its file
  std::string content{};  ///< of its file
  nlohmann::json head = nlohmann::json::object();
  std::string remark{};  ///< how it ends, with its path; empty: whole

  /// The unit that was recorded, "vcan0/5"; "?" if the head does not say it.
  [[nodiscard]] std::string unit() const;
  /// How many axes that has; 0 if the head does not say it.
  [[nodiscard]] std::size_t axes() const;
};

/// Reads the recording at @p path; one whose end is missing is taken. A failure if it cannot be read, or its head
/// is wrong.
[[nodiscard]] Expected<Recording> read_recording(const std::string& path);

/// The recording at @p path and the older half of it, if there is one, in front.
[[nodiscard]] Expected<std::vector<Recording>> read_halves(const std::string& path);

}  // namespace axisctl
