#include "daemon/watch/streams/sample_stream.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "device/bus/unit_time.hpp"
#include "trace/settings.hpp"

namespace axisd {

SampleStream::SampleStream(CycleTap& cycles, const device::Device& device, canopen::TimePoint started) noexcept
    : cycles_{cycles}, device_{device}, started_{device::unit_time(started)} {}

tl::expected<void, trace::Problem> SampleStream::begin(std::shared_ptr<SampleBuffer> buffer) {
  Sampler sampler{.buffer = std::move(buffer), .signals = {}};
  for (const std::string& name : sampler.buffer->plan().signals) {
    const auto signal = trace::find_signal(device_.unit(), name);
    if (!signal) {
      trace::Problem problem = signal.error();
      problem.key = fmt::format("signals[{}]", sampler.signals.size());
      return tl::unexpected{std::move(problem)};
    }
    sampler.signals.push_back(signal->reader);
  }
  if (samplers_.size() == kMost || !cycles_.add(*this))
    return tl::unexpected{trace::Problem{trace::Problem::Kind::TooMuch, "batch_ms",
                                         fmt::format("at most {} subscriptions to samples of a unit", kMost)}};
  samplers_.push_back(std::move(sampler));
  return {};
}

void SampleStream::end(const SampleBuffer& buffer) noexcept {
  std::erase_if(samplers_, [&buffer](const Sampler& each) { return each.buffer.get() == &buffer; });
  if (samplers_.empty()) cycles_.remove(*this);
}

void SampleStream::on_step(long step) noexcept {
  steps_ = step;
  take_due(begin_ + step * trace::kStep);
}

void SampleStream::on_cycle_end() noexcept {
  const unit::TimePoint now = begin_ + (steps_ + 1) * trace::kStep;
  for (Sampler& sampler : samplers_)
    if (!sampler.due) sampler.due = now;
  take_due(now);
}

void SampleStream::take_due(unit::TimePoint now) noexcept {
  for (Sampler& sampler : samplers_)
    if (sampler.due && *sampler.due <= now) sampler.take(now, started_);
}

/// What was due in cycles that the unit has skipped is not known.
void SampleStream::Sampler::take(unit::TimePoint now, unit::TimePoint started) noexcept {
  const unit::Duration period = buffer->plan().period;
  const auto missed = (now - *due) / period;
  if (missed > 0) buffer->miss(static_cast<std::uint64_t>(missed));
  if (const std::span<double> values = buffer->next(now - started); !values.empty()) {
    std::ranges::transform(signals, values.begin(), [](const trace::Reader& signal) { return signal.value(); });
    buffer->publish();
  }
  *due += period * (missed + 1);
}

}  // namespace axisd
