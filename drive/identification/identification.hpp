#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "drive/base/object_kind.hpp"
#include "motor/identification/rotating/rotating_measurement.hpp"
#include "motor/identification/standstill/standstill_measurement.hpp"

namespace drive {
namespace explanation {
struct Reason;
}

/// p1900, p1910 and p1960 as they read.
struct IdentificationSelection {
  std::int32_t both = 0;        ///< p1900: 1 both measurements, 2 the one at standstill
  std::int32_t standstill = 0;  ///< p1910
  std::int32_t rotating = 0;    ///< p1960
};

/// Values of p1910 and p1960.
namespace selection {
inline constexpr std::int32_t kTakeOver = -3;     ///< what was found last, without measuring
inline constexpr std::int32_t kMeasureOnly = -1;  ///< the results stay in r19xx
inline constexpr std::int32_t kNone = 0;
inline constexpr std::int32_t kMeasure = 1;
inline constexpr std::int32_t kMeasureOnlyVector = 2;  ///< of p1910, on a vector axis
inline constexpr std::int32_t kMeasureCurve = 3;   ///< of p1910, saturation characteristic of an induction machine
inline constexpr std::int32_t kMeasureBlind = 2;   ///< of p1960, on a vector axis without encoder
inline constexpr std::int32_t kFirstWithLoad = 3;  ///< of p1960, on a vector axis
inline constexpr std::int32_t kBothMeasurements = 1;  ///< of p1900
}  // namespace selection

/// Whether p1960 = @p value measures on an axis of @p kind with p1300 = @p control_mode: field-oriented, and on a
/// vector axis 1 and 3 with the encoder, 2 and 4 without it.
bool can_rotate(std::int32_t value, ObjectKind kind, std::int32_t control_mode) noexcept;

/// One of the two measurements.
enum class IdentificationPart : std::uint8_t { None, Standstill, Rotating };

/// The two measurements that find the data of a motor, what is selected of them, and what they have found last.
class Identification {
 public:
  struct Settings {
    using Block = Identification;

    double speed_dynamics = 1.0;  ///< p1967, of the speed controller that p1960 computes
  };

  /// What the measurements have found since the unit was switched on.
  struct Results {
    std::optional<motor::StandstillResult> standstill{};
    std::optional<motor::RotatingResult> rotating{};
  };

  const IdentificationSelection& selection() const noexcept { return selection_; }
  /// p1910 becomes @p value, one that measures or 0.
  void select_standstill(std::int32_t value) noexcept;
  /// p1960 becomes @p value, one that measures or 0.
  void select_rotating(std::int32_t value) noexcept;
  /// p1900 becomes @p value (0..2) and sets p1910 and, if it is 1, p1960 = @p rotating (0: nothing rotates).
  void select_both(std::int32_t value, std::int32_t rotating) noexcept;
  /// Takes every selection back.
  void deselect() noexcept { selection_ = {}; }
  /// The measurement that the next ON begins.
  IdentificationPart due() const noexcept;
  /// Whether what @p part finds is meant for the parameters.
  bool is_taken_over(IdentificationPart part) const noexcept;

  /// ON came: the measurement that is due begins as soon as it can, if @p from_standstill only then.
  void prepare(bool from_standstill) noexcept;
  /// Whether a measurement leads the axis or waits for its begin.
  bool leads() const noexcept { return phase_ != Phase::Idle; }
  bool waits() const noexcept { return phase_ == Phase::Waiting; }
  /// While it waits: whether it may begin with a shaft that turns.
  bool begins_turning() const noexcept { return !from_standstill_; }
  /// The measurement that runs.
  IdentificationPart running() const noexcept {
    return phase_ == Phase::Running ? due() : IdentificationPart::None;
  }
  void start(const motor::StandstillTask& task) noexcept;
  void start(const motor::RotatingTask& task) noexcept;
  /// What leads the motor in a measurement at standstill.
  motor::Excitation& excitation() noexcept { return standstill_; }
  /// The next command of a rotating measurement.
  motor::DriveCommand step(const motor::Observation& seen) noexcept { return rotating_.step(seen); }
  double flux_share() const noexcept { return rotating_.flux_share(); }
  /// Of the measurement that runs.
  motor::MeasurementState state() const noexcept;
  /// Fault value of the measurement that runs and has failed: of F07990 or of F07985.
  std::uint16_t fault_value() const noexcept;
  /// r0047: what runs is about to do; what is selected; 0.
  std::uint16_t progress() const noexcept;
  /// The share of its steps that the measurement that runs has behind it, 0 to 1; 0 while none runs.
  double share() const noexcept;
  /// Gives the measurement up without a result; it stays selected.
  void stop() noexcept { phase_ = Phase::Idle; }
  /// The measurement that runs is done: keeps its result and takes its selection back.
  void finish() noexcept;

  const Results& results() const noexcept { return results_; }
  /// What power-off does: nothing is selected, runs or is known.
  void reset() noexcept {
    const Settings kept = settings;
    *this = {};
    settings = kept;
  }

  /// Its reasons that an axis does not turn.
  static std::span<const explanation::Reason> reasons() noexcept;

  Settings settings{};

 private:
  enum class Phase : std::uint8_t { Idle, Waiting, Running };

  void settle() noexcept;

  motor::StandstillMeasurement standstill_;
  motor::RotatingMeasurement rotating_;
  Results results_{};
  IdentificationSelection selection_{};
  Phase phase_ = Phase::Idle;
  bool from_standstill_ = false;
  double rated_flux_ = 0.0;  // of an induction machine, that the measurement began with
};

}  // namespace drive
