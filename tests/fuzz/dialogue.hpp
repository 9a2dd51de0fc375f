#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace fuzz {

/// Input bytes for a dialogue written as text, one event a line. Throws std::invalid_argument on anything else.
///
///     ; a remark                     world 1       the policy, only in the first line of all
///     605#4000100000000000           a frame from the bus, as candump writes it; 8 data bytes to 605h or 6A5h go
///     to
///                                    the servers of 1200h and 1202h
///     wait 150ms                     time passes (us, ms, s), deadlines are met
///     deadline 3                     time passes to the next deadline, three times
///     event 4C 10 00                 any other event by its bytes: argument and kind, then what it takes
std::vector<std::uint8_t> bytes_of_dialogue(std::string_view text);

}  // namespace fuzz
