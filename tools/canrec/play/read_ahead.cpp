#include "tools/canrec/play/read_ahead.hpp"

#include <utility>

#include "os/no_signals.hpp"

namespace canrec {

namespace {

/// Frames that are handed over at once, and how often they may wait: 32000 frames, some seconds of a full bus.
constexpr std::size_t kBlock = 500;
constexpr std::size_t kMostBlocks = 64;

}  // namespace

ReadAhead::ReadAhead(FrameSource& source) : source_{source} {
  const os::NoSignals none;
  thread_ = std::jthread{[this](const std::stop_token& stop) { work(stop); }};
}

ReadAhead::~ReadAhead() {
  thread_.request_stop();
  changed_.notify_all();
}

/// Puts the next frames into @p block; false if there are no more behind them.
bool ReadAhead::fill(Block& block) {
  block.reserve(kBlock);
  while (block.size() < kBlock) {
    auto frame = source_.next();
    if (!frame) {
      const std::scoped_lock lock{mutex_};
      failure_ = std::move(frame.error());
      return false;
    }
    if (!*frame) return false;
    block.push_back(**frame);
  }
  return true;
}

void ReadAhead::hand_over(Block block, const std::stop_token& stop) {
  std::unique_lock lock{mutex_};
  changed_.wait(lock, stop, [this] { return blocks_.size() < kMostBlocks; });
  blocks_.push_back(std::move(block));
  changed_.notify_all();
}

void ReadAhead::work(const std::stop_token& stop) {
  bool goes_on = true;
  while (goes_on && !stop.stop_requested()) {
    Block block;
    goes_on = fill(block);
    hand_over(std::move(block), stop);
  }
  const std::scoped_lock lock{mutex_};
  is_over_ = true;
  changed_.notify_all();
}

Expected<std::optional<TimedFrame>> ReadAhead::next() {
  while (given_ == block_.size()) {
    std::unique_lock lock{mutex_};
    changed_.wait(lock, [this] { return !blocks_.empty() || is_over_; });
    if (blocks_.empty()) {
      if (failure_) return tl::unexpected{*failure_};
      return std::nullopt;
    }
    block_ = std::move(blocks_.front());
    blocks_.pop_front();
    given_ = 0;
    changed_.notify_all();
  }
  return block_[given_++];
}

}  // namespace canrec
