#include "tools/canopen-check/checks/shared/read_ahead.hpp"

#include <algorithm>

namespace conformance {

bool fits_one_frame(const eds::Description& eds, const Multiplexor& entry) noexcept {
  constexpr std::size_t kExpedited = 4;
  const eds::EntryFacts* const facts = eds.find(entry.index, entry.sub_index);
  return facts == nullptr || (facts->numeric() && facts->bytes() <= kExpedited);
}

std::optional<canopen::Frame> ReadAhead::next_frame() {
  if (at_ == frames_.size()) ask();
  return frames_[at_++];
}

void ReadAhead::begin_step() {
  context_->session().forget();
  context_->step();
}

void ReadAhead::ask() {
  constexpr std::size_t kAtOnce = 32;
  std::vector<Multiplexor> group;
  for (std::size_t at = at_; at < entries_.size() && group.size() < kAtOnce; ++at) {
    if (!fits_one_frame(context_->eds(), entries_[at])) break;
    group.push_back(entries_[at]);
  }
  context_->session().forget();
  if (group.empty()) {
    frames_.emplace_back();
    return;
  }
  std::ranges::move(context_->sdo().ask_together(group), std::back_inserter(frames_));
}

}  // namespace conformance
