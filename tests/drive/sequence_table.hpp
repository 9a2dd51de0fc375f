#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "drive/sequence_control/state_machine.hpp"

namespace drive {

/// tests/data/sequence_control.txt.
struct SequenceTable {
  /// Bits that are given, of a word of 16.
  struct Pattern {
    std::uint16_t mask = 0;
    std::uint16_t value = 0;

    bool matches(std::uint16_t word) const { return (word & mask) == value; }
  };
  struct Row {
    State state;
    bool still, turning;  ///< the shafts it is for
    bool only_free;
    std::string command;
    State next;
  };
  using Commands = std::multimap<std::string, Pattern>;

  Commands commands;       ///< as in a new unit
  Commands halt_commands;  ///< with p8791 = 0
  std::vector<Row> rows;
  std::map<State, std::string> statuswords;  ///< 16 symbols each, bit 15 first

  /// The statusword of @p state with its symbols replaced.
  Pattern statusword(State state, bool still, std::uint16_t controlword) const;
};

/// The states by their names in the table.
const std::map<std::string, State>& states_by_name();
/// Reads the table; throws std::runtime_error with the line where it is wrong.
SequenceTable read_sequence_table();

}  // namespace drive
