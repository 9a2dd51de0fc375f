#include "daemon/watch/unit_recording.hpp"

#include <algorithm>
#include <ctime>
#include <span>
#include <system_error>
#include <utility>
#include <variant>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "service/clock.hpp"
#include "version/version.hpp"

namespace axisd {
namespace {

using nlohmann::json;
using std::chrono::nanoseconds;

constexpr const char* kFolder = "recordings";
constexpr double kMegabyte = 1e6;

/// Of the start of the unit, by the clock as it stands now.
nanoseconds wall_clock_at(canopen::TimePoint started) {
  return os::wall_time() - (read_clock() - started);
}

/// UTC, to the second.
std::tm calendar(nanoseconds wall_clock) {
  return fmt::gmtime(
      static_cast<std::time_t>(std::chrono::duration_cast<std::chrono::seconds>(wall_clock).count()));
}

canopen::Duration seconds(double count) {
  return std::chrono::duration_cast<canopen::Duration>(std::chrono::duration<double>{count});
}

/// As a log of candump names it: a bus that is no interface of the kernel has no such name.
std::string interface_of(const bus::Address& address) {
  const auto* const interface = std::get_if<bus::KernelInterface>(&address.place);
  return interface != nullptr ? address.text : "can0";
}

json axes_of(const Configuration& configuration) {
  json axes = json::array();
  for (const AxisConfiguration& axis : configuration.axes)
    axes.push_back({{"axis", axes.size() + 1},
                    {"name", axis.name},
                    {"type", axis.kind == drive::ObjectKind::Vector ? "vector" : "servo"}});
  return axes;
}

}  // namespace

tl::expected<std::vector<trace::Signal>, std::string> UnitRecording::signals_of(
    const RecordSettings& settings) const {
  std::vector<trace::Signal> signals;
  for (const std::string& name : settings.signals) {
    auto signal = trace::find_signal(std::as_const(unit_.device).unit(), name);
    if (!signal)
      return tl::unexpected{fmt::format("signals: expected {}, got \"{}\"", signal.error().expected, name)};
    signals.push_back(*std::move(signal));
  }
  return signals;
}

tl::expected<void, UnitRecording::Refusal> UnitRecording::start(const RecordSettings& settings,
                                                                canopen::TimePoint now) {
  using Why = Refusal::Why;
  const auto present = status();
  if (present && (is_listening_ || !present->recorder.files.is_over))
    return tl::unexpected{Refusal{
        Why::Busy, fmt::format("a recording is {}: record.stop ends it", name_of(present->recorder.state))}};
  auto signals = signals_of(settings);
  if (!signals) return tl::unexpected{Refusal{Why::NoSuchSignal, signals.error()}};
  const RecordSettings former = std::exchange(settings_, settings);
  if (settings_.name.empty()) settings_.name = fmt::format("{:%Y%m%d-%H%M%S}", calendar(os::wall_time()));
  const auto signals_before = std::exchange(signals_, *std::move(signals));
  try {
    recorder_ = std::make_unique<record::Recorder>(plan(settings_), moment(now));
    if (unit_.events.add(*this) && unit_.frames.add(*this)) is_listening_ = true;
  } catch (const std::system_error& error) {
    settings_ = former;
    signals_ = signals_before;
    return tl::unexpected{Refusal{Why::NoThread, error.what()}};
  }
  if (!is_listening_) {
    end();
    return tl::unexpected{Refusal{Why::Busy, "too many listen to the unit"}};
  }
  period_ = settings_.period ? seconds(*settings_.period) : canopen::Duration{};
  due_ = signals_.empty() || !settings_.period ? canopen::kNever : now;
  return {};
}

record::Plan UnitRecording::plan(const RecordSettings& settings) const {
  const nanoseconds wall_clock = wall_clock_at(unit_.started);
  return {.files = {.folder = unit_.folder / kFolder,
                    .name = settings.name,
                    .head = head(settings, wall_clock),
                    .interface = interface_of(unit_.configuration.address),
                    .wall_clock = wall_clock,
                    .most_bytes = static_cast<std::uint64_t>(settings.most_MB * kMegabyte),
                    .by_faults = settings.on_fault},
          .before = seconds(settings.before),
          .after = seconds(settings.after)};
}

std::string UnitRecording::head(const RecordSettings& settings, nanoseconds wall_clock) const {
  json signals = json::array();
  for (const trace::Signal& signal : signals_) signals.push_back({{"name", signal.name}, {"unit", signal.unit}});
  const auto below_second = wall_clock % std::chrono::seconds{1};
  json head{{"program", "axisd"},
            {"version", version::number()},
            {"name", settings.name},
            {"unit", fmt::format("{}/{}", unit_.configuration.address.text, unit_.device.node_id())},
            {"interface", interface_of(unit_.configuration.address)},
            {"node_id", unit_.device.node_id()},
            {"profile", name_of(unit_.configuration.profile())},
            {"axes", axes_of(unit_.configuration)},
            {"cycle_s", std::chrono::duration<double>{unit_.device.cycle()}.count()},
            {"wall_clock", fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:09}Z", calendar(wall_clock), below_second.count())},
            {"wall_clock_ns", wall_clock.count()},
            {"signals", signals},
            {"on_fault", settings.on_fault}};
  if (settings.period) head["every_s"] = *settings.period;
  if (settings.on_fault) {
    head["before_s"] = settings.before;
    head["after_s"] = settings.after;
  }
  return head.dump(-1, ' ', false, json::error_handler_t::replace);
}

void UnitRecording::stop(canopen::TimePoint now) noexcept {
  listen_no_more();
  if (recorder_) recorder_->stop(moment(now));
}

void UnitRecording::end() noexcept {
  listen_no_more();
  recorder_.reset();
}

void UnitRecording::listen_no_more() noexcept {
  unit_.events.remove(*this);
  unit_.frames.remove(*this);
  is_listening_ = false;
  due_ = canopen::kNever;
}

std::optional<UnitRecording::Status> UnitRecording::status() const {
  if (!recorder_) return std::nullopt;
  return Status{settings_, recorder_->status()};
}

std::optional<std::string> UnitRecording::take_failure() {
  if (!is_listening_ || !recorder_->has_failed()) return std::nullopt;
  std::string error = recorder_->status().files.error;
  stop(read_clock());
  return error;
}

void UnitRecording::on_frame(const canopen::Frame& frame, Direction direction, canopen::TimePoint time) noexcept {
  recorder_->on_frame(frame, direction == Direction::Sent, moment(time));
}

void UnitRecording::on_event(const UnitEvent& event) noexcept {
  recorder_->on_event(event, moment(event.time));
}

void UnitRecording::on_handled(canopen::TimePoint now) noexcept {
  recorder_->on_time(moment(now));
  if (signals_.empty()) return;
  if (period_ == canopen::Duration{}) {
    const canopen::TimePoint cycle = device::node_time(unit_.device.runner().clock().last());
    if (std::exchange(last_cycle_, cycle) != cycle) sample(cycle);
  } else if (due_ <= now) {
    sample(now);
    due_ += period_ * ((now - due_) / period_ + 1);
  }
}

canopen::TimePoint UnitRecording::next_deadline() const noexcept {
  const auto until = recorder_->until();
  return until ? std::min(due_, unit_.started + *until) : due_;
}

void UnitRecording::sample(canopen::TimePoint now) noexcept {
  std::array<double, RecordSettings::kMostSignals> values{};
  for (std::size_t i = 0; i < signals_.size(); ++i) values[i] = signals_[i].reader.value();
  recorder_->on_samples(std::span{values}.first(signals_.size()), moment(now));
}

}  // namespace axisd
