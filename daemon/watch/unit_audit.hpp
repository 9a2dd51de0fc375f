#pragma once

#include <memory>
#include <vector>

#include "daemon/watch/frame_tap.hpp"
#include "device/device.hpp"

namespace audit {
class Auditor;
struct Heard;
}  // namespace audit

namespace axisd {

/// Judges what masters do with a unit, by the frames that it receives and sends. A turn is judged when the unit
/// has finished with it: an answer does not wait for it. Allocates, a bounded amount.
class UnitAudit final : private FrameListener {
 public:
  /// The arguments outlive this; @p started is zero of the times.
  UnitAudit(const device::Device& device, FrameTap& tap, canopen::TimePoint started) noexcept;
  ~UnitAudit() override;
  UnitAudit(const UnitAudit&) = delete;
  UnitAudit& operator=(const UnitAudit&) = delete;

  /// Judges from now on. False if too many listen to the frames.
  [[nodiscard]] bool begin();
  /// What was found since begin(); nullptr before it.
  [[nodiscard]] const audit::Auditor* auditor() const noexcept { return auditor_.get(); }

 private:
  void on_frame(const canopen::Frame& frame, Direction direction, canopen::TimePoint time) noexcept override;
  void on_handled(canopen::TimePoint now) noexcept override;
  void judge() noexcept;

  const device::Device& device_;
  FrameTap& tap_;
  canopen::TimePoint started_;
  std::unique_ptr<audit::Auditor> auditor_;
  std::vector<audit::Heard> waiting_;  ///< to be judged
  std::uint64_t heard_ = 0;
  bool has_booted_ = false;  ///< since the last judgement: its values are those that it had saved
};

}  // namespace axisd
