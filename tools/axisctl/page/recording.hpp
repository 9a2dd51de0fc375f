#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
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

  /// The unit that was recorded, as unit_name() has it; "?" if the head does not say it.
  [[nodiscard]] std::string unit() const;
  /// How many axes that has; 0 if the head does not say it.
  [[nodiscard]] std::size_t axes() const;
  /// Its profile; empty if the head does not say it.
  [[nodiscard]] std::string profile() const;
  /// When the unit was switched on (ns since 1970); 0 if the head does not say it.
  [[nodiscard]] std::int64_t start() const;
};

/// What a unit is called that is at node-ID @p node of @p interface, a name or a URL: "vcan0/5".
[[nodiscard]] std::string unit_name(const std::string& interface, std::string_view node);

/// Reads the recording at @p path; one whose end is missing is taken. A failure if it cannot be read, or its head
/// is wrong.
[[nodiscard]] Expected<Recording> read_recording(const std::string& path);

/// The recording at @p path and the older half of it, if there is one, in front.
[[nodiscard]] Expected<std::vector<Recording>> read_halves(const std::string& path);

}  // namespace axisctl
