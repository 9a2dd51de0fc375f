#pragma once

#include <array>
#include <map>

#include "drive/sequence_control/state_machine.hpp"
#include "sim/judges/unit_judge.hpp"

namespace sim {

struct SeenCommand {
  bool has_come = false;  ///< since the unit is in its state
};
/// The NMT state changes as CiA 301 7.3.2.2 says, and to another state than Initialising by a command, a boot-up,
/// or what 1029h and p8609 have for an error.
class NmtTransitions final : public UnitJudge<SeenCommand> {
 public:
  using UnitJudge::UnitJudge;

  void on_taken(const SimulatedUnit& unit, const canopen::Frame& frame, canopen::TimePoint now) override;
  void on_event(const SimulatedUnit& unit, const axisd::UnitEvent& event) override;
};

/// Whether one cycle, or one frame, can lead from a state to another.
using Reached = std::array<std::array<bool, drive::kStateCount>, drive::kStateCount>;
struct SeenStates {
  std::map<std::uint8_t, Reached> of_axis{};
  std::map<std::uint8_t, drive::State> last{};
};
/// Each change of a drive's state is in the table that the unit shows, one transition after a frame or a cycle,
/// two where the second one needs no command.
class DriveTransitions final : public UnitJudge<SeenStates> {
 public:
  using UnitJudge::UnitJudge;

  void on_event(const SimulatedUnit& unit, const axisd::UnitEvent& event) override;
  void on_cycle(const SimulatedUnit& unit, canopen::TimePoint now) override;

 private:
  void judge(const SimulatedUnit& unit, std::uint8_t axis, drive::State before, drive::State after,
             canopen::TimePoint now);
};

}  // namespace sim
