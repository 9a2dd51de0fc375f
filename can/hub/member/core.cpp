#include "can/hub/member/core.hpp"

#include "can/hub/member/member.hpp"

namespace hub {

Core::Core(std::uint32_t bit_rate, const userbus::TimeWish& time)
    : clock{time}, medium{bit_rate, clock}, faults{medium, interfaces} {}

Core::~Core() = default;

void Core::hand_over() noexcept {
  if (turns != nullptr)
    for (const Member* const member : gathering) member->note_given();
  for (Member* const member : gathering) member->hand_over();
  gathering.clear();
}

}  // namespace hub
