#pragma once

#include <optional>
#include <string>

#include "tools/axisctl/scenario/language/frame_pattern.hpp"
#include "tools/axisctl/scenario/run/context.hpp"

namespace scenario {

/// Looks whether a condition holds, as often as it is asked.
class Observation {
 public:
  /// Of frames, those from @p mark on count.
  Observation(Condition condition, std::size_t mark);

  /// Whether it holds now; of frames, whether enough have come. The error is one line: it cannot be told.
  [[nodiscard]] tl::expected<bool, std::string> holds(Context& context);
  /// What there was at the last look: "Pre-operational", "712.5", "185#3716 0.012 s after it began".
  [[nodiscard]] const std::string& found() const noexcept { return found_; }
  /// Of frames, the place behind the one that has fulfilled it.
  [[nodiscard]] std::optional<std::size_t> behind() const noexcept { return behind_; }

 private:
  bool look_at_frames(Context& context);

  Condition condition_;
  FramePattern pattern_{};
  std::size_t next_ = 0, count_ = 0, wanted_ = 1;
  std::optional<std::size_t> behind_{};
  std::string found_;
};

/// Whether @p value is what `is`, `at_least` and `at_most` among @p keys ask for; no key: true.
[[nodiscard]] bool is_wanted(const nlohmann::json& value, const nlohmann::json& keys);

}  // namespace scenario
