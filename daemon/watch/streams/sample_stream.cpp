#include "daemon/watch/streams/sample_stream.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace axisd {
namespace {

/// The first time after @p now that is a number of @p periods behind @p begin.
canopen::TimePoint next_on_grid(canopen::TimePoint begin, canopen::Duration period,
                                canopen::TimePoint now) noexcept {
  return begin + period * ((now - begin) / period + 1);
}

}  // namespace

tl::expected<void, trace::Problem> SampleStream::begin(std::shared_ptr<SampleBuffer> buffer,
                                                       canopen::TimePoint now) {
  using Kind = trace::Problem::Kind;
  const SampleBuffer::Plan& plan = buffer->plan();
  Sampler sampler{.buffer = buffer, .signals = {}};
  for (const std::string& name : plan.signals) {
    const auto signal = trace::find_signal(device_.unit(), name);
    if (!signal) {
      trace::Problem problem = signal.error();
      problem.key = fmt::format("signals[{}]", sampler.signals.size());
      return tl::unexpected{std::move(problem)};
    }
    sampler.signals.push_back(signal->reader);
  }
  if (samplers_.size() == kMost || !tap_.add(*this))
    return tl::unexpected{trace::Problem{Kind::TooMuch, "batch_ms",
                                         fmt::format("at most {} subscriptions to samples of a unit", kMost)}};
  sampler.due = next_on_grid(device::node_time(device_.runner().clock().last()), plan.period, now);
  samplers_.push_back(std::move(sampler));
  look_for_earliest();
  return {};
}

void SampleStream::end(const SampleBuffer& buffer) noexcept {
  std::erase_if(samplers_, [&buffer](const Sampler& each) { return each.buffer.get() == &buffer; });
  look_for_earliest();
  if (samplers_.empty()) tap_.remove(*this);
}

void SampleStream::on_handled(canopen::TimePoint now) noexcept {
  if (now < due_) [[likely]]
    return;
  for (Sampler& sampler : samplers_)
    if (sampler.due <= now) sampler.take(now, started_);
  look_for_earliest();
}

/// What was due while the unit was kept from running cannot be known any more.
void SampleStream::Sampler::take(canopen::TimePoint now, canopen::TimePoint started) noexcept {
  const canopen::Duration period = buffer->plan().period;
  const auto missed = (now - due) / period;
  if (missed > 0) buffer->miss(static_cast<std::uint64_t>(missed));
  due += period * missed;
  if (const std::span<double> values = buffer->next(due - started); !values.empty()) {
    std::ranges::transform(signals, values.begin(), [](const trace::Reader& signal) { return signal.value(); });
    buffer->publish();
  }
  due += period;
}

void SampleStream::look_for_earliest() noexcept {
  due_ = canopen::kNever;
  for (const Sampler& sampler : samplers_) due_ = std::min(due_, sampler.due);
}

}  // namespace axisd
