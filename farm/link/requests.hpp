#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "farm/link/link.hpp"

namespace farm {

/// The requests that wait for an answer. Time is told.
class Requests {
 public:
  using Time = std::chrono::nanoseconds;  ///< since any zero

  /// A number for one that waits until @p due; nothing if as many wait as may. @p on_reply is left as it was then.
  [[nodiscard]] std::optional<std::uint64_t> add(Time due, Link::OnReply& on_reply);
  /// Tells @p reply to the one with @p number, if it waits still.
  void answer(std::uint64_t number, Link::Reply reply);
  /// Tells those whose time is over.
  void advance(Time now);
  /// Tells all of them @p why.
  void end(NoReply why);
  /// When advance() is wanted; nothing while none waits.
  [[nodiscard]] std::optional<Time> due() const noexcept;

 private:
  struct Waiting {
    Time due;
    Link::OnReply on_reply;
  };

  std::map<std::uint64_t, Waiting> waiting_;
  std::set<std::pair<Time, std::uint64_t>> by_time_;
  std::uint64_t last_ = 0;
};

}  // namespace farm
