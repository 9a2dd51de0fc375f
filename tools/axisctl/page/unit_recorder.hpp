#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "tools/axisctl/connection/whole_answer.hpp"
#include "tools/axisctl/page/recording.hpp"

namespace axisctl {

/// What is recorded of a unit for a page.
struct RecordingWish {
  std::vector<std::string> signals{};  ///< empty: default_signals()
  std::optional<double> every_s{};     ///< period of their values; nothing: each process-data cycle
  std::chrono::nanoseconds length{};
};

/// The signals of a page that names none: speed, its setpoint, torque and current of the first of @p axes axes, as
/// many as a recording takes.
[[nodiscard]] std::vector<std::string> default_signals(std::size_t axes);

/// Records a unit for so long, less if SIGINT or SIGTERM comes. The unit may still write to the file then.
[[nodiscard]] Expected<void> record_unit(const Ask& ask, const RecordingWish& wish);
/// The path of the recording that has ended last, once it is written. A failure if it cannot be.
[[nodiscard]] Expected<std::string> written_file(const Ask& ask);

}  // namespace axisctl
