#pragma once

#include <cstdint>

#include "can/hub/filter/filter_index.hpp"
#include "can/hub/medium/medium.hpp"
#include "can/hub/medium/waiting.hpp"

namespace hub {

/// What a Medium keeps for one participant.
struct Station {
  Station(Participant& owner, std::uint32_t number_of_all) noexcept : participant{&owner}, number{number_of_all} {}

  Participant* participant;       ///< nullptr: it has left
  std::uint32_t number;           ///< of all that there have been, from 1 on
  FilterIndex::Place place = 0;   ///< among those who hear frames
  Identity left;                  ///< who that was, if frames met an interference then
  bool refused = false;           ///< it had to be told that there was no room
  WaitingFrames<Passage> frames;  ///< that wait for the bus
};

}  // namespace hub
