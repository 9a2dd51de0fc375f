#pragma once

#include <array>

#include "sim/judges/unit_judge.hpp"

namespace sim {

struct SeenBeginning {
  bool owes_boot_up = true;
  bool was_started = false;
};
/// What a unit sends first when it was switched on, or when its bus is back, is its boot-up message; and until a
/// master starts it behind that, no PDO.
class FirstFrames final : public UnitJudge<SeenBeginning> {
 public:
  using UnitJudge::UnitJudge;

  void on_sent(const SimulatedUnit& unit, const canopen::Frame& frame, canopen::TimePoint now) override;
  void on_event(const SimulatedUnit& unit, const axisd::UnitEvent& event) override;
};

struct SeenTpdo {
  canopen::TimePoint sent{};
  std::int64_t inhibit = 0;  ///< 100 us
  std::uint64_t waits = 0;   ///< how often frames of the unit have had to wait for the bus by then
  bool is_punctual = false;  ///< it has not waited itself
};
/// TPDOs that are looked at, from 1800h on.
inline constexpr std::size_t kJudgedTpdos = 8;
/// From one TPDO to the next one there is its inhibit time (CiA 301 7.5.2.37), unless a SYNC asks for it.
class InhibitTimes final : public UnitJudge<std::array<SeenTpdo, kJudgedTpdos>> {
 public:
  using UnitJudge::UnitJudge;

  void on_sent(const SimulatedUnit& unit, const canopen::Frame& frame, canopen::TimePoint now) override;
};

struct SeenHeartbeat {
  canopen::TimePoint sent = canopen::kNever;  ///< the last one; kNever: none is owed
  std::int64_t period = 0;                    ///< ms
};
/// A heartbeat comes at least in its time (1017h), however late the unit had its turns.
class HeartbeatTimes final : public UnitJudge<SeenHeartbeat> {
 public:
  using UnitJudge::UnitJudge;

  void on_sent(const SimulatedUnit& unit, const canopen::Frame& frame, canopen::TimePoint now) override;
  void on_turn(const SimulatedUnit& unit, canopen::TimePoint now, std::uint64_t allocated) override;
};

struct SeenEmergency {
  enum class Told : std::uint8_t { Unknown, None, Error };
  Told told = Told::Unknown;
  canopen::TimePoint clear_since = canopen::kNever;  ///< 1001h is 0 since then, and an error was told
};
/// EMCY 0000h (no error) comes once behind errors that were told, and is there when the unit has none any more.
class EmergencyPairs final : public UnitJudge<SeenEmergency> {
 public:
  using UnitJudge::UnitJudge;

  void on_sent(const SimulatedUnit& unit, const canopen::Frame& frame, canopen::TimePoint now) override;
  void on_event(const SimulatedUnit& unit, const axisd::UnitEvent& event) override;
  void on_turn(const SimulatedUnit& unit, canopen::TimePoint now, std::uint64_t allocated) override;
};

}  // namespace sim
