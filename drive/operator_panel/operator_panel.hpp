#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace drive {
namespace explanation {
struct Reason;
}

/// Why an operator panel cannot take the control.
enum class PanelRefusal : std::uint8_t {
  Inhibited,    ///< by p0806
  Held,         ///< a panel has it
  InOperation,  ///< the pulses are on under the control of another
};

/// Master control by an operator panel. While it is active, ON, OFF2, OFF3, the operation enable and the speed
/// setpoint are those of the panel, whatever their inputs are connected to. A panel that falls silent is an OFF1,
/// and the control goes back at standstill.
class OperatorPanel {
 public:
  struct Inputs {
    using Block = OperatorPanel;

    bool is_inhibited = false;  ///< p0806

    friend bool operator==(const Inputs&, const Inputs&) = default;
  };

  /// Why it cannot take the control of an axis whose pulses are on if @p operates, if it cannot.
  std::optional<PanelRefusal> refusal(bool operates) const noexcept;
  /// A panel that will not be silent for longer than @p timeout (s) takes the control; refusal() says whether it
  /// can.
  void take(double timeout) noexcept;
  /// The panel gives ON or OFF1 and a speed setpoint (rad/s); false if it does not lead.
  bool command(bool on, double speed) noexcept;
  /// OFF1; the control goes back at standstill. False if no panel has it.
  bool give_back() noexcept;
  /// A cycle of @p duration (s) begins; @p operates: the pulses are on. True if the control goes back with it.
  bool begin_cycle(double duration, bool operates) noexcept;
  /// The inputs are without ON since the control went back.
  void see_off1() noexcept { awaits_off1_ = false; }
  /// Power-off: no panel has the control, and no input has come yet.
  void power_off() noexcept { *this = {}; }

  /// r0807.
  bool is_active() const noexcept { return phase_ != Phase::Away; }
  /// The control goes back at standstill.
  bool returns() const noexcept { return phase_ == Phase::Returns; }
  bool is_on() const noexcept { return on_; }  ///< as it was last told
  /// What acts: the first cycle of its control is OFF1, so that ON has its edge.
  bool gives_on() const noexcept { return gives_on_; }
  double speed() const noexcept { return speed_; }          ///< rad/s
  double timeout() const noexcept { return timeout_; }      ///< s
  double remaining() const noexcept { return remaining_; }  ///< s, until it counts as silent
  /// Since the control went back, ON at the inputs has not been seen at 0.
  bool awaits_off1() const noexcept { return awaits_off1_; }

  /// Its reasons that an axis does not turn.
  static std::span<const explanation::Reason> reasons() noexcept;

  Inputs inputs{};

 private:
  enum class Phase : std::uint8_t { Away, Leads, Returns };

  Phase phase_ = Phase::Away;
  bool on_ = false;
  bool gives_on_ = false;
  bool has_given_off1_ = false;  // for a cycle
  bool awaits_off1_ = false;
  double speed_ = 0.0;
  double timeout_ = 0.0;
  double remaining_ = 0.0;
};

}  // namespace drive
