#pragma once

#include <memory>
#include <vector>

#include "can/hub/faults/faults.hpp"
#include "can/hub/loop/clock.hpp"
#include "can/hub/loop/closer.hpp"
#include "can/hub/loop/poll.hpp"
#include "can/hub/medium/interfaces.hpp"
#include "can/hub/medium/medium.hpp"
#include "can/hub/medium/source.hpp"
#include "can/hub/member/inbox.hpp"
#include "can/hub/member/link_page.hpp"
#include "can/hub/member/turns.hpp"

namespace hub {

class Member;

/// What all members of a hub have in common.
struct Core {
  /// @p bit_rate in bit/s, 0 = frames take no time; @p time: whose time it is. std::system_error if the kernel has
  /// no descriptor left.
  Core(std::uint32_t bit_rate, const userbus::TimeWish& time);
  Core(const Core&) = delete;
  Core& operator=(const Core&) = delete;
  ~Core();

  /// Sends what was gathered for members: at the end of a turn of the loop, and around a request, whose answer
  /// tells that what came before it has passed.
  void hand_over() noexcept;

  Clock clock;
  Poll poll;
  Medium medium;
  Interfaces interfaces;
  Inbox inbox;
  Closer closer;
  LinkPage link_page;
  std::vector<std::unique_ptr<Member>> members;
  std::vector<Member*> gathering;  ///< for whom frames were gathered; has room for all members
  Turns* turns = nullptr;          ///< where the bus has a time of its own that is told
  bool anyone_departed = false;    ///< some member may be destroyed
  std::vector<Source*> sources;
  faults::Faults faults;  // ends first: members and sources take part in the medium without it
};

}  // namespace hub
