#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "audit/base/heard.hpp"

namespace audit {

/// Something that has happened to a node.
struct Milestone {
  canopen::Duration at{};
  std::uint64_t place = 0;  ///< of the frame that shows it
  std::string text{};       ///< "boot-up", "NMT start", "EMCY: error code 8130h"
};

/// What has happened to one node: the first and the last milestones.
class TimeLine {
 public:
  /// Milestones of each end that are kept.
  static constexpr std::size_t kMostKept = 100;

  void add(const Heard& heard, std::string text);
  [[nodiscard]] const std::vector<Milestone>& first() const noexcept { return first_; }
  /// Those behind first() that are kept.
  [[nodiscard]] const std::deque<Milestone>& last() const noexcept { return last_; }
  /// How many between first() and last() are not.
  [[nodiscard]] std::uint64_t left_out() const noexcept { return left_out_; }

 private:
  std::vector<Milestone> first_{};
  std::deque<Milestone> last_{};
  std::uint64_t left_out_ = 0;
};

/// The time lines of all nodes, by node-ID; that of 0 is the bus's.
using TimeLines = std::array<TimeLine, 128>;

}  // namespace audit
