#pragma once

#include "sim/judges/unit_judge.hpp"

namespace sim {

struct SeenSdoServer {
  unsigned owed = 0;           ///< requests without an answer: a program may read several at once
  canopen::TimePoint asked{};  ///< the last one
  unsigned put_off = 0;        ///< read while a save goes on, whose answer may be theirs, too: may have none
  /// Before, what is owed is not sure: the unit was tampered with, or a block transfer has begun.
  canopen::TimePoint known_from{};
};
/// Each request to the default SDO server is answered once, by its answer or an abort (CiA 301 7.2.4.3); a save is
/// answered when it is over. Block transfers, several frames of which one answer may confirm, are passed over, and
/// 2 s behind them.
class SdoAnswers final : public UnitJudge<SeenSdoServer> {
 public:
  using UnitJudge::UnitJudge;

  void on_taken(const SimulatedUnit& unit, const canopen::Frame& frame, canopen::TimePoint now) override;
  void on_sent(const SimulatedUnit& unit, const canopen::Frame& frame, canopen::TimePoint now) override;
  void on_event(const SimulatedUnit& unit, const axisd::UnitEvent& event) override;
  void on_turn(const SimulatedUnit& unit, canopen::TimePoint now, std::uint64_t allocated) override;

 private:
  void forget(const SimulatedUnit& unit, canopen::TimePoint now);
};

}  // namespace sim
