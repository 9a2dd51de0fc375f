#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "drive/drive_unit.hpp"
#include "trace/signal/place.hpp"

namespace trace {

/// An entry of the list of signals: of a parameter all its indices and bits.
struct ListedSignal {
  std::string name;       ///< "1/r0063"; index and bit are put behind it
  std::string_view unit;  ///< empty: none
  std::string_view text;
  std::uint16_t indices = 1;  ///< of a parameter
  std::uint8_t bits = 0;      ///< that are signals, too: "1/r0899.0"...
  bool is_quantity = false;   ///< physical, not a parameter
};

/// A part of a list.
struct SignalPage {
  std::vector<ListedSignal> signals;
  std::size_t total = 0;  ///< of all that were asked for
};

/// What is looked for.
struct SignalSearch {
  std::string_view text{};  ///< in names and texts, letters of either case; every word has to be there
  std::size_t from = 0;     ///< the first one of the list
  std::size_t count = 100;  ///< at most
};

/// Signals of @p unit: physical quantities first, then parameters, by drive objects.
SignalPage list_signals(const drive::DriveUnit& unit, const SignalSearch& search);

}  // namespace trace
