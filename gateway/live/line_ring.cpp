#include "gateway/live/line_ring.hpp"

#include <algorithm>

namespace gateway {

void LineRing::push(std::string_view text, LiveTime now) {
  forget(now);
  lines_.push_back({now, std::string{text}});
  bytes_ += text.size();
  ++last_;
  while (bytes_ > kMostBytes) drop();
}

void LineRing::forget(LiveTime now) {
  while (!lines_.empty() && now - lines_.front().since > kLongest) drop();
}

void LineRing::drop() {
  bytes_ -= lines_.front().text.size();
  lines_.pop_front();
}

std::uint64_t LineRing::copy_behind(std::uint64_t after, std::string& to) const {
  if (after >= last_) return 0;
  const std::uint64_t wanted = last_ - after;
  const std::uint64_t kept = std::min<std::uint64_t>(wanted, lines_.size());
  const auto first = lines_.end() - static_cast<std::ptrdiff_t>(kept);
  std::size_t size = to.size() + kept;
  for (auto line = first; line != lines_.end(); ++line) size += line->text.size();
  to.reserve(size);
  for (auto line = first; line != lines_.end(); ++line) {
    if (line != first) to += ',';
    to += line->text;
  }
  return wanted - kept;
}

}  // namespace gateway
