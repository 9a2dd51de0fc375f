#pragma once

#include <optional>
#include <vector>

#include "sim/judges/unit_judge.hpp"

namespace sim {

struct SeenSets {
  std::optional<std::uint64_t> kept{};  ///< of the save that was answered last, or found at the start
  std::size_t begun = 0;                ///< contents that the file was given until then
};
/// The saved parameters that a unit finds at its start are those of a save that was answered, or of one that was
/// begun behind it: the old or the new ones, whole.
class StoredSets final : public UnitJudge<SeenSets> {
 public:
  using UnitJudge::UnitJudge;

  void on_power(const SimulatedUnit& unit, bool on) override;
  void on_event(const SimulatedUnit& unit, const axisd::UnitEvent& event) override;
};

struct AwaitedAxes {
  canopen::TimePoint since = canopen::kNever;
  /// Bit n: axis n + 1 has not been there yet.
  std::optional<std::uint32_t> missing{};
};
/// When the faults are over, every axis comes to Operation enabled within kLongest, in which the bus has room (one
/// that is full gives none to those with high identifiers) and no shaft is faster than its drive allows: what a
/// load has turned so fast keeps F07901 until friction has slowed it down.
class EnabledAgain final : public Judge {
 public:
  /// A guarded node has to be missed, the unit to start, faults to be acknowledged, up to eight motors to be
  /// magnetised one behind the other.
  static constexpr canopen::Duration kLongest = std::chrono::seconds{7};

  explicit EnabledAgain(std::string_view rule, std::size_t units) : Judge{rule}, awaited_(units) {}

  void on_turn(const SimulatedUnit& unit, canopen::TimePoint now, std::uint64_t allocated) override;
  void on_calm(canopen::TimePoint now) override;
  void on_full_bus(canopen::Duration lasting) override;
  void on_end(canopen::TimePoint now) override;

 private:
  std::vector<AwaitedAxes> awaited_;
};

/// A unit that runs allocates nothing.
class NoAllocation final : public Judge {
 public:
  explicit NoAllocation(std::string_view rule, std::size_t) : Judge{rule} {}

  void on_turn(const SimulatedUnit& unit, canopen::TimePoint now, std::uint64_t allocated) override;
};

struct SeenEnergy {
  bool has_begun = false;
  double start = 0.0;         ///< stored then (J)
  double before = 0.0;        ///< what had come in and gone out until then
  double spent = 0.0;         ///< in motors and inverters (J)
  double turned_over = 0.0;   ///< sum of all that passed (J)
  std::vector<long> steps{};  ///< of each axis in its cycle, when it was looked at last
};
/// Every joule from the line is somewhere: in a place that stores it, lost as heat, or at the load.
class EnergyBalance final : public UnitJudge<SeenEnergy> {
 public:
  using UnitJudge::UnitJudge;

  void on_step(const SimulatedUnit& unit) override;
  void on_cycle(const SimulatedUnit& unit, canopen::TimePoint now) override;
};

}  // namespace sim
