#include "tools/canopen-audit/source/in_order.hpp"

#include <algorithm>

namespace audit_tool {
namespace {

/// Handed over at once; what is behind them is moved.
constexpr std::size_t kFew = 32;

}  // namespace

void InOrder::add(const audit::Heard& heard) {
  audit::Heard placed = heard;
  placed.at += offset_;
  if (kept_.empty() && auditor_.frames() == 0) end_ = placed.at;
  const canopen::Duration back = (kept_.empty() ? end_ : kept_.back().at) - placed.at;
  if (back > kWindow) {  // the clock was set back, or the time before was wrong
    offset_ += back;
    placed.at += back;
  }
  kept_.insert(std::ranges::upper_bound(kept_, placed.at, {}, &audit::Heard::at), placed);
  const canopen::Duration safe = kept_.back().at - kWindow;
  const auto ready = std::ranges::upper_bound(kept_, safe, {}, &audit::Heard::at) - kept_.begin();
  const std::size_t above = kept_.size() > kMostKept ? kept_.size() - kMostKept / 2 : 0;
  const std::size_t count = std::max(static_cast<std::size_t>(ready), above);
  if (count >= kFew) hand_over(count);
}

void InOrder::flush() {
  hand_over(kept_.size());
}

void InOrder::hand_over(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    audit::Heard heard = kept_[i];
    if (auditor_.frames() == 0) begin_ = end_ = heard.at;
    heard.at = end_ = std::max(end_, heard.at);
    auditor_.take(heard);
  }
  kept_.erase(kept_.begin(), kept_.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace audit_tool
