#pragma once

#include <memory>
#include <vector>

#include <tl/expected.hpp>

#include "daemon/watch/frame_tap.hpp"
#include "daemon/watch/streams/sample_buffer.hpp"
#include "device/device.hpp"
#include "trace/signal/signal.hpp"

namespace axisd {

/// Takes samples of signals of a unit at times that are exact, and puts them into buffers from which another
/// thread takes them. All periods begin with a cycle of the unit, so that those who want the same one, or
/// multiples, cost no more wake-ups; a unit at rest is woken for them.
class SampleStream final : private FrameListener {
 public:
  /// Buffers that are filled at a time.
  static constexpr std::size_t kMost = 16;

  /// @p tap and @p device outlive this; @p started is zero of the times.
  SampleStream(FrameTap& tap, const device::Device& device, canopen::TimePoint started) noexcept
      : tap_{tap}, device_{device}, started_{started} {}
  ~SampleStream() override = default;
  SampleStream(const SampleStream&) = delete;
  SampleStream& operator=(const SampleStream&) = delete;

  /// Fills @p buffer from @p now on as its plan says. The problem is that the unit does not have one of the
  /// signals, or that there are too many buffers.
  [[nodiscard]] tl::expected<void, trace::Problem> begin(std::shared_ptr<SampleBuffer> buffer,
                                                         canopen::TimePoint now);
  /// Fills @p buffer no longer.
  void end(const SampleBuffer& buffer) noexcept;

 private:
  /// A buffer with what is put into it, and when that is due.
  struct Sampler {
    std::shared_ptr<SampleBuffer> buffer;
    std::vector<trace::Reader> signals;
    canopen::TimePoint due{};

    void take(canopen::TimePoint now, canopen::TimePoint started) noexcept;
  };

  void on_frame(const canopen::Frame&, Direction, canopen::TimePoint) noexcept override {}
  void on_handled(canopen::TimePoint now) noexcept override;
  canopen::TimePoint next_deadline() const noexcept override { return due_; }
  void look_for_earliest() noexcept;

  FrameTap& tap_;
  const device::Device& device_;
  canopen::TimePoint started_;
  std::vector<Sampler> samplers_;
  canopen::TimePoint due_ = canopen::kNever;  ///< the earliest of all
};

}  // namespace axisd
