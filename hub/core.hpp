#pragma once

#include <memory>
#include <vector>

#include "hub/interfaces.hpp"
#include "hub/loop/closer.hpp"
#include "hub/loop/poll.hpp"
#include "hub/medium.hpp"
#include "hub/member/inbox.hpp"
#include "hub/source.hpp"

namespace hub {

class Member;

/// What all members of a hub have in common.
struct Core {
  /// @p bit_rate in bit/s, 0 = frames take no time; std::system_error if the kernel has no descriptor left.
  explicit Core(std::uint32_t bit_rate);
  Core(const Core&) = delete;
  Core& operator=(const Core&) = delete;
  ~Core();

  Poll poll;
  Medium medium;
  Interfaces interfaces;
  Inbox inbox;
  Closer closer;
  std::vector<std::unique_ptr<Member>> members;
  bool anyone_departed = false;  ///< some member may be destroyed
  std::vector<Source*> sources;
};

}  // namespace hub
