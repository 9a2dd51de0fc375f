#pragma once

#include <string>
#include <string_view>

#include "control/writer/protocol_text.hpp"

namespace control {

/// A parameter of a method, and what the page says of it beyond key and range.
struct ParameterText {
  Parameter row;
  std::string_view meaning;
};

/// Reads the parameter @p object that stands at @p place; its lists go to @p text.
ParameterText read_parameter(ProtocolText& text, const Json& object, const std::string& place);

}  // namespace control
