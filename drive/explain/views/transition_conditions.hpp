#pragma once

#include <span>
#include <string>
#include <string_view>

#include "drive/explain/explain_reasons.hpp"

/// What the transitions of the sequence control need, as data.
namespace drive::explanation {

/// A set of events, one bit each.
using Events = unsigned;
template <class... Event>
constexpr Events on(Event... events) noexcept {
  return ((1U << static_cast<unsigned>(events)) | ...);
}

/// Something that a transition needs. @p events are those that bring this transition about.
struct Condition {
  States from;                 ///< of transitions that leave one of these states only
  std::string_view parameter;  ///< that it depends on first; empty: none
  std::string (*text)(const Picture& picture, Events events);
  bool (*met)(const Picture& picture, Events events);
};

/// What events need to happen.
struct Trigger {
  Events events;
  bool needs_all;  ///< it is for transitions that each of the events makes, otherwise for any of them
  bool by_itself;  ///< no command brings them about
  std::span<const Condition* const> conditions;
};

/// For each event at least one row; the first that fits a transition counts.
std::span<const Trigger> triggers() noexcept;

}  // namespace drive::explanation
