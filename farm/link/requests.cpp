#include "farm/link/requests.hpp"

namespace farm {

std::optional<std::uint64_t> Requests::add(Time due, Link::OnReply& on_reply) {
  if (waiting_.size() >= Link::kMostRequests) return std::nullopt;
  waiting_.emplace(++last_, Waiting{due, std::move(on_reply)});
  by_time_.emplace(due, last_);
  return last_;
}

void Requests::answer(std::uint64_t number, Link::Reply reply) {
  const auto found = waiting_.find(number);
  if (found == waiting_.end()) return;
  const Waiting waiting = std::move(found->second);
  by_time_.erase({waiting.due, number});
  waiting_.erase(found);
  waiting.on_reply(std::move(reply));
}

void Requests::advance(Time now) {
  while (!by_time_.empty() && by_time_.begin()->first <= now)
    answer(by_time_.begin()->second, tl::unexpected{NoReply::TooLate});
}

/// Whoever is told may ask again; that one is not meant.
void Requests::end(NoReply why) {
  by_time_.clear();
  for (auto& [number, waiting] : std::exchange(waiting_, {})) waiting.on_reply(tl::unexpected{why});
}

std::optional<Requests::Time> Requests::due() const noexcept {
  return by_time_.empty() ? std::nullopt : std::optional{by_time_.begin()->first};
}

}  // namespace farm
