#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "profidrive/channel/parameter_channel.hpp"

namespace profidrive {

/// What an answer to a record breaks of the rules that hold whatever @p request is: it mirrors the header, has an
/// entry for each parameter, or one for the whole, and not a byte more, of 240 at most. Empty if nothing.
[[nodiscard]] std::string broken_rule(std::span<const std::uint8_t> request, std::span<const std::uint8_t> answer);

/// The same of a parameter channel: the answer names the parameter, and its identifier belongs to the request.
[[nodiscard]] std::string broken_rule(const ParameterChannel::Words& request,
                                      const ParameterChannel::Words& answer);

}  // namespace profidrive
