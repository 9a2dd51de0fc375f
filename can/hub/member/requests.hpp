#pragma once

#include "can/hub/member/core.hpp"
#include "can/hub/member/member.hpp"
#include "libcanopen/base/time.hpp"

namespace hub {

/// Who asks, and when.
struct Asking {
  Core& core;
  Member& member;
  canopen::TimePoint now;
};

/// Does what the Request in @p message asks for and sends the Reply to the descriptor that came with it; false if
/// the message is no request.
bool answer_request(const Asking& asking, const Inbox::Message& message) noexcept;

}  // namespace hub
