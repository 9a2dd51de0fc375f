#pragma once

#include <iosfwd>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "control/method.hpp"

namespace axisctl {

/// How a result is shown to people.
struct Style {
  bool brief = false;   ///< one line a thing, without heads
  bool colour = false;  ///< the output is a terminal, and $NO_COLOR is not set
};
/// Colours where standard output is a terminal and $NO_COLOR is not set.
[[nodiscard]] Style style_of_output(bool brief);

/// Prints @p result of @p method for people: in its own way where the method has one, else its members in the
/// order of its schema, and lists of objects as tables.
void print_result(std::ostream& out, const control::Method& method, const nlohmann::json& result, Style style);

/// Prints the result of status as aligned lines, or one line an axis.
void print_status(std::ostream& out, const nlohmann::json& result, Style style);

/// Prints the present state and the ways out of it, with what they need unless it is to be brief.
void print_state_machine(std::ostream& out, const nlohmann::json& result, Style style);

/// Prints the rules that were broken with their frames, or one line a rule if it is to be brief, and how many.
void print_audit(std::ostream& out, const nlohmann::json& result, Style style);

/// @p value in one line.
[[nodiscard]] std::string text_of(const nlohmann::json& value);
/// The member @p key of @p object in one line; empty if it has none.
[[nodiscard]] std::string text_in(const nlohmann::json& object, const char* key);
/// @p state of a drive in its colour.
[[nodiscard]] std::string coloured_state(const std::string& state, Style style);

}  // namespace axisctl
