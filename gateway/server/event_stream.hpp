#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <string>
#include <string_view>

#include "gateway/server/event_text.hpp"

namespace gateway {

/// What waits to be sent to one viewer. A viewer that leaves too much unread is told so, and its stream ends.
class EventStream {
 public:
  /// Most that may wait (bytes); the texts are those of all viewers, only what is unread counts.
  static constexpr std::size_t kMostUnread = 256UL * 1024;

  /// @p on_change is called when there is something to send where there was nothing.
  void listen(std::function<void()> on_change) { on_change_ = std::move(on_change); }

  /// Lets @p text follow. False, now and afterwards, if the stream has ended: with this text it was too much.
  bool push(const EventText& text);
  /// Ends the stream behind what waits.
  void end();

  /// Copies what comes next to @p to, at most @p size bytes; gives how many.
  std::size_t take(char* to, std::size_t size);
  /// Nothing waits.
  [[nodiscard]] bool is_empty() const noexcept { return waiting_.empty(); }
  [[nodiscard]] bool has_ended() const noexcept { return has_ended_; }
  [[nodiscard]] bool was_cut_off() const noexcept { return was_cut_off_; }

 private:
  void add(EventText text);

  std::deque<EventText> waiting_;
  std::size_t unread_ = 0;  ///< bytes of `waiting_`
  std::size_t taken_ = 0;   ///< bytes of the first one that are on their way
  bool has_ended_ = false;
  bool was_cut_off_ = false;
  std::function<void()> on_change_;
};

}  // namespace gateway
