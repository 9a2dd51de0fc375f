#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

#include "tools/canrec/frames/frame_source.hpp"

namespace canrec {

/// The frames of another source, which a thread of its own asks, so that nobody waits for a disk or a server where
/// time counts.
class ReadAhead final : public FrameSource {
 public:
  /// Begins to ask @p source, which outlives this and which nobody else asks.
  explicit ReadAhead(FrameSource& source);
  ~ReadAhead() override;

  [[nodiscard]] Expected<std::optional<TimedFrame>> next() override;

 private:
  using Block = std::vector<TimedFrame>;

  void work(const std::stop_token& stop);
  [[nodiscard]] bool fill(Block& block);
  void hand_over(Block block, const std::stop_token& stop);

  FrameSource& source_;
  Block block_;            ///< that is being given
  std::size_t given_ = 0;  ///< frames of it

  std::mutex mutex_;  ///< of what is shared: the rest but the thread
  std::condition_variable_any changed_;
  std::deque<Block> blocks_;
  bool is_over_ = false;            ///< the source has no more
  std::optional<Failure> failure_;  ///< with which it has ended
  std::jthread thread_;
};

}  // namespace canrec
