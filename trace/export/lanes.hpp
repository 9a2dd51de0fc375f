#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "trace/export/result.hpp"
#include "trace/export/scale.hpp"

namespace trace {

/// A part of the picture with a scale of its own.
struct Lane {
  std::string unit;                  ///< of its scale, empty: none
  std::vector<std::size_t> signals;  ///< places in Result::signals
  bool is_bit = false;               ///< one signal that is 0 or 1
  double top = 0.0;                  ///< of what is drawn, below the names
  double height = 0.0;
  Scale values{0.0, 1.0, 1.0, 0.0};
};

/// Room for the names of the signals above a lane.
inline constexpr double kNameHeight = 20.0;

/// The lanes of @p result from @p top on: one a unit, and one a signal that is 0 or 1 all the time.
std::vector<Lane> lanes_of(const Result& result, double top);

/// The colour of signal @p signal, the same in every lane.
std::string_view colour_of(std::size_t signal) noexcept;

/// An event in its row of texts.
struct EventLabel {
  std::size_t event;  ///< place in Result::events
  double x;           ///< of the event
  int row;            ///< of the text, from 0; no text if it is kNoRow
  std::string text;
  bool before;  ///< the text is on the left of it, as there is no room on the right
};
inline constexpr int kNoRow = -1;

/// The events of @p result with their texts in rows where they do not lie on each other; @p right is the end of
/// the rows.
std::vector<EventLabel> event_labels(const Result& result, const Scale& time, double right);

/// "F07860 axis 1", "axis 1 Operation enabled".
std::string event_text(const Result::Event& event);
/// A colour for its kind.
std::string_view colour_of(const Result::Event& event) noexcept;

}  // namespace trace
