#pragma once

#include <bitset>
#include <chrono>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "tools/axisctl/runs/log/log_reader.hpp"

namespace runs {

/// What is found out of a log before it is played.
class LogFacts {
 public:
  /// Looks at the next frame.
  void take(const LoggedFrame& logged);

  [[nodiscard]] std::uint64_t frames() const noexcept { return frames_; }
  /// The nodes that have answered over SDO or sent a boot-up message: index is the node-ID.
  [[nodiscard]] const std::bitset<128>& nodes() const noexcept { return nodes_; }
  /// What is to be said of its time stamps and gaps, a line each; @p bit_rate: of the bus onto which it is played
  /// (bit/s), 0: unknown.
  [[nodiscard]] std::vector<std::string> remarks(const LogReader& log, std::uint32_t bit_rate) const;

 private:
  struct Sent {
    std::chrono::nanoseconds at;
    unsigned bits;
  };
  void take_time(const LoggedFrame& logged);
  void take_load(const LoggedFrame& logged);

  std::uint64_t frames_ = 0, gaps_ = 0, same_ = 0, backward_ = 0;
  std::uint64_t longest_place_ = 0, backward_place_ = 0, densest_place_ = 0;
  std::chrono::nanoseconds last_{}, longest_{};
  std::bitset<128> nodes_{};
  std::deque<Sent> window_{};  ///< the frames of the last kLoadWindow
  std::uint64_t bits_ = 0;     ///< of those behind the first one
  double densest_ = 0;         ///< bit/s
};

/// Reads the log @p path, of which @p interface is meant, from end to end; ExitStatus::Damaged if it has no frame.
/// Its remark() is among @p remarks, as are those of its facts.
[[nodiscard]] Expected<LogFacts> check_log(const std::string& path, const std::string& interface,
                                           std::uint32_t bit_rate, std::vector<std::string>& remarks);

}  // namespace runs
