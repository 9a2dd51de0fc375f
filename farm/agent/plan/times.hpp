#pragma once

#include <chrono>

#include "libcanopen/base/time.hpp"

namespace farm::agent {

/// How often an agent tells that it is there.
inline constexpr std::chrono::milliseconds kBeatPeriod{250};
/// Who is silent for so long is lost: others take its units, and it has stopped them itself.
inline constexpr std::chrono::seconds kPatience{2};
/// How long an agent listens before it takes a unit: who else is there shall have told so.
inline constexpr std::chrono::seconds kHearing{1};
/// In what time the host that is to take a unit does it, before it is another one's turn.
inline constexpr std::chrono::seconds kTurn{3};
/// Pause before a program that has ended is started again: twice as long each time, up to the longest.
inline constexpr std::chrono::seconds kFirstPause{1};
inline constexpr std::chrono::seconds kLongestPause{30};
/// What has run for so long begins with the first pause again.
inline constexpr std::chrono::seconds kGoodRun{30};
/// Pause before a write to the server that has failed is tried again.
inline constexpr std::chrono::milliseconds kWritePause{500};

}  // namespace farm::agent
