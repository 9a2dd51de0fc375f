#include "gateway/server/event_stream.hpp"

#include <algorithm>
#include <utility>

namespace gateway {

bool EventStream::push(const EventText& text) {
  if (has_ended_) return false;
  if (unread_ + text->size() <= kMostUnread) {
    add(text);
    return true;
  }
  // The event that is half sent stays; the word comes behind it.
  const std::size_t kept = taken_ == 0 ? 0 : 1;
  waiting_.resize(std::min(waiting_.size(), kept));
  unread_ = waiting_.empty() ? 0 : waiting_.front()->size();
  was_cut_off_ = true;
  add(event_text("cut-off", R"({"message":"events came faster than they were read"})"));
  end();
  return false;
}

void EventStream::end() {
  has_ended_ = true;
  if (on_change_) on_change_();
}

void EventStream::add(EventText text) {
  unread_ += text->size();
  waiting_.push_back(std::move(text));
  if (on_change_) on_change_();
}

std::size_t EventStream::take(char* to, std::size_t size) {
  std::size_t copied = 0;
  while (copied < size && !waiting_.empty()) {
    const std::string& text = *waiting_.front();
    const std::size_t part = std::min(size - copied, text.size() - taken_);
    std::copy_n(text.data() + taken_, part, to + copied);
    copied += part;
    taken_ += part;
    if (taken_ < text.size()) break;
    unread_ -= text.size();
    taken_ = 0;
    waiting_.pop_front();
  }
  return copied;
}

}  // namespace gateway
