#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <tl/expected.hpp>

#include "daemon/watch/cycle_tap.hpp"
#include "daemon/watch/streams/sample_buffer.hpp"
#include "device/device.hpp"
#include "trace/signal/signal.hpp"

namespace axisd {

/// Takes samples of signals of a unit step by step, as a trace does, and puts them into buffers from which another
/// thread takes them. So their times are exact, also where cycles are made up for late; a unit that is sampled
/// does not rest.
class SampleStream final : private unit::CycleObserver {
 public:
  /// Buffers that are filled at a time.
  static constexpr std::size_t kMost = 16;

  /// @p cycles and @p device outlive this; @p started is zero of the times.
  SampleStream(CycleTap& cycles, const device::Device& device, canopen::TimePoint started) noexcept;
  ~SampleStream() override = default;
  SampleStream(const SampleStream&) = delete;
  SampleStream& operator=(const SampleStream&) = delete;

  /// Fills @p buffer as its plan says, from the end of the next cycle on. The problem is that the unit does not
  /// have one of the signals, or that there are too many buffers.
  [[nodiscard]] tl::expected<void, trace::Problem> begin(std::shared_ptr<SampleBuffer> buffer);
  /// Fills @p buffer no longer.
  void end(const SampleBuffer& buffer) noexcept;

 private:
  /// A buffer with what is put into it, and when that is due.
  struct Sampler {
    std::shared_ptr<SampleBuffer> buffer;
    std::vector<trace::Reader> signals;
    std::optional<unit::TimePoint> due{};  ///< nothing: at the end of the next cycle

    void take(unit::TimePoint now, unit::TimePoint started) noexcept;
  };

  void on_cycle_begin(unit::TimePoint begin) noexcept override {
    begin_ = begin;
    steps_ = 0;
  }
  void on_step(long step) noexcept override;
  void on_cycle_end() noexcept override;
  void take_due(unit::TimePoint now) noexcept;

  CycleTap& cycles_;
  const device::Device& device_;
  unit::TimePoint started_;
  std::vector<Sampler> samplers_;
  unit::TimePoint begin_{};  ///< of the cycle that runs
  long steps_ = 0;           ///< that it has done
};

}  // namespace axisd
