#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

#include "tools/axisctl/runs/compare/difference.hpp"

namespace runs {

/// What both logs have had so far, as far as it is told of a difference. Its memory does not grow with the logs.
class History {
 public:
  /// @p surroundings: frames that are kept; @p description, which outlives this, has the names.
  History(const eds::Description& description, std::size_t surroundings);

  /// Both logs have this frame.
  void take(const FramePair& pair);

  [[nodiscard]] std::vector<FramePair> surroundings() const { return {last_.begin(), last_.end()}; }
  /// The last frames of the same identifier as @p a or @p b, and the last of each service.
  [[nodiscard]] std::vector<Former> formers(const std::optional<LoggedFrame>& a,
                                            const std::optional<LoggedFrame>& b) const;
  /// What @p logged, which comes next, says.
  [[nodiscard]] std::string words_of(const std::optional<LoggedFrame>& logged) const;

 private:
  /// Identifiers of 29 bits that are remembered; those of 11 bits all are.
  static constexpr std::size_t kMostIdentifiers = 65536;
  static constexpr std::size_t kServices = 4;

  void add_former(std::vector<Former>& formers, std::string_view what, const LoggedFrame& frame) const;

  const eds::Description& description_;
  std::size_t most_;
  meaning::CobIds ids_;
  std::deque<FramePair> last_;
  std::unordered_map<std::uint32_t, LoggedFrame> by_identifier_;
  std::array<std::optional<LoggedFrame>, kServices> services_{};
  std::array<std::optional<LoggedFrame>, 128> requests_{};  ///< SDO requests by node
};

}  // namespace runs
