#include "tools/canopen-check/core/run/context.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "meaning/words.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

constexpr std::uint64_t kObservedHeartbeat = 100;  // ms: the shortest that every device is able to
constexpr canopen::Duration kGuardPatience = std::chrono::milliseconds{100};
constexpr std::uint8_t kStateBits = 0x7F;
/// Frames that a finding keeps, and findings of a check that keep any.
constexpr std::size_t kMostFrames = 60, kMostWithFrames = 20;
/// Findings of a check; one for every object of a large device has to fit, as each may be a known deviation.
constexpr std::size_t kMostFindings = 2000;
/// Characters of a text in a finding.
constexpr std::size_t kMostCharacters = 300;
/// How long a boot-up message is waited for of a node that has sent none before.
constexpr canopen::Duration kKnownSilent = std::chrono::seconds{1};

std::string fixed_text(const Subject& subject) {
  return fmt::format("{} cannot be written, as the EDS says", to_text(subject));
}

std::string bounded(std::string text) {
  if (text.size() <= kMostCharacters) return text;
  text.resize(kMostCharacters);
  return text + "...";
}

canopen::NmtCommand command_for(canopen::NmtState state) noexcept {
  switch (state) {
    case canopen::NmtState::Operational:
      return canopen::NmtCommand::Start;
    case canopen::NmtState::Stopped:
      return canopen::NmtCommand::Stop;
    case canopen::NmtState::Initialising:
    case canopen::NmtState::PreOperational:
    case canopen::NmtState::Unconfigured:
      break;
  }
  return canopen::NmtCommand::EnterPreOperational;
}

}  // namespace

std::string milliseconds(canopen::Duration time) {
  return fmt::format("{:.1f} ms", std::chrono::duration<double, std::milli>{time}.count());
}

void Context::fail(Subject subject, std::string expected, std::string found) {
  if (findings_.size() > kMostFindings) return;
  if (findings_.size() == kMostFindings) {
    findings_.push_back({.expected = "fewer findings", .found = "more, which are not listed"});
    return;
  }
  const std::span<const TimedFrame> frames =
      findings_.size() < kMostWithFrames ? session_->since(mark_) : std::span<const TimedFrame>{};
  const std::span<const TimedFrame> last = frames.last(std::min(frames.size(), kMostFrames));
  findings_.push_back({.subject = subject,
                       .expected = bounded(std::move(expected)),
                       .found = bounded(std::move(found)),
                       .frames = {last.begin(), last.end()}});
}

bool Context::need(std::uint16_t index, std::uint8_t sub_index) {
  const bool there = eds_->empty() ? read(index, sub_index).done() : eds_->find(index, sub_index) != nullptr;
  if (!there)
    skip(fmt::format("object {} is not {}", to_text(Subject{index, sub_index}),
                     eds_->empty() ? "on the node" : "in the EDS"));
  return there;
}

bool Context::is_fixed(std::uint16_t index, std::uint8_t sub_index) const noexcept {
  const eds::EntryFacts* const facts = eds_->find(index, sub_index);
  return facts != nullptr && !facts->writable();
}

std::optional<std::uint64_t> Context::number(std::uint16_t index, std::uint8_t sub_index) {
  step();
  return number_in(read(index, sub_index), index, sub_index);
}

std::optional<std::uint64_t> Context::number_in(const SdoAnswer& answer, std::uint16_t index,
                                                std::uint8_t sub_index) {
  if (answer.done()) return answer.number();
  fail(index, sub_index, "a value", to_text(answer));
  return std::nullopt;
}

SdoAnswer Context::write_number(std::uint16_t index, std::uint8_t sub_index, std::uint64_t value) {
  const eds::EntryFacts* const facts = eds_->find(index, sub_index);
  std::size_t size = facts != nullptr ? facts->bytes() : 0;
  if (size == 0) size = std::clamp<std::size_t>(read(index, sub_index).data.size(), 1, 8);
  return write(index, sub_index, eds::little_endian(value, size));
}

bool Context::set(std::uint16_t index, std::uint8_t sub_index, std::uint64_t value) {
  step();
  if (is_fixed(index, sub_index)) return skip(fixed_text({index, sub_index})), false;
  const SdoAnswer answer = write_number(index, sub_index, value);
  if (!answer.done()) fail(index, sub_index, fmt::format("{:X}h can be written", value), to_text(answer));
  return answer.done();
}

void Context::expect_abort(const SdoAnswer& answer, std::initializer_list<std::uint32_t> codes,
                           std::uint16_t index, std::uint8_t sub_index, const std::string& request) {
  constexpr std::uint32_t kGeneralError = 0x08000000;
  if (answer.aborted() && std::ranges::find(codes, answer.abort_code) != codes.end()) return;
  const bool read_only = answer.abort_code == number_of(canopen::AbortCode::ReadOnly) ||
                         answer.abort_code == number_of(canopen::AbortCode::UnsupportedAccess);
  if (answer.aborted() && read_only && is_fixed(index, sub_index)) return note(fixed_text({index, sub_index}));
  if (answer.aborted() && answer.abort_code == kGeneralError)
    return note(
        fmt::format("{}: {} is refused with the general code", to_text(Subject{index, sub_index}), request));
  std::string expected;
  for (const std::uint32_t code : codes)
    expected += (expected.empty() ? "abort " : " or ") + meaning::abort_text(code);
  fail(index, sub_index, fmt::format("{} for {}", expected, request), to_text(answer));
}

std::optional<TimedFrame> Context::boot_up(canopen::Duration patience) {
  return session_->wait_for(
      [id = session_->identifier(function_code::kErrorControl)](const canopen::Frame& frame) {
        return frame.id == id && !frame.remote && frame.length == 1 && frame.data[0] == 0;
      },
      patience);
}

bool Context::may_reset() {
  if (!settings_->allow_reset) skip("it resets the node, which --no-reset forbids");
  return settings_->allow_reset;
}

std::optional<canopen::Duration> Context::reset(canopen::NmtCommand command) {
  if (!may_reset()) return std::nullopt;
  const canopen::Duration limit = manners_->boots_without_message
                                      ? std::min(kKnownSilent, settings_->boot_up_limit)
                                      : settings_->boot_up_limit;
  step();
  sdo_->forget_transfer();
  session_->drain();
  const canopen::TimePoint begin = session_->now();
  session_->command(command);
  if (const auto first = boot_up(limit)) return first->time - begin;
  const bool answers = read(object::kDeviceType).done();
  manners_->boots_without_message = manners_->boots_without_message || answers;
  fail(fmt::format("a boot-up message within {}", milliseconds(limit)),
       answers ? "none, but answers to SDO requests" : "none, and no answer to SDO requests");
  return std::nullopt;
}

bool Context::restart(canopen::NmtCommand command) {
  constexpr int kAttempts = 10;
  constexpr canopen::Duration kSoon = std::chrono::milliseconds{200};
  if (!may_reset()) return false;
  step();
  sdo_->forget_transfer();
  session_->drain();
  const canopen::TimePoint until = session_->now() + settings_->boot_up_limit;
  const canopen::Duration patience =
      manners_->boots_without_message ? kSoon : settings_->boot_up_limit / kAttempts;
  session_->command(command);
  do {
    sdo_->ask_again();
    if (boot_up(patience) || read(object::kDeviceType).done()) return true;
  } while (session_->now() < until && !session_->ended());
  skip("the node does not come back after a reset");
  return false;
}

void Context::enter(canopen::NmtState state) {
  was_operational_ = was_operational_ || state == canopen::NmtState::Operational;
  session_->command(command_for(state));
}

std::optional<canopen::NmtState> Context::guard() {
  const std::uint32_t identifier = session_->identifier(function_code::kErrorControl);
  session_->drain();
  if (!session_->carries_remote_frames() || !session_->send({.id = identifier, .length = 1, .remote = true}))
    return std::nullopt;
  const auto answer = session_->wait_for(under(identifier), kGuardPatience);
  if (!answer || answer->frame.length != 1) return std::nullopt;
  return static_cast<canopen::NmtState>(answer->frame.data[0] & kStateBits);
}

bool Context::observe_state() {
  by_guarding_ = guard().has_value();
  if (by_guarding_) return true;
  if (write_number(object::kHeartbeatTime, 0, kObservedHeartbeat).done() && state()) return true;
  skip("the node tells its state neither by guarding nor by heartbeat");
  return false;
}

std::optional<canopen::NmtState> Context::state() {
  if (by_guarding_) return guard();
  session_->drain();
  const auto beat = session_->wait_for(under(session_->identifier(function_code::kErrorControl)),
                                       5 * std::chrono::milliseconds{kObservedHeartbeat});
  if (!beat || beat->frame.length != 1) return std::nullopt;
  return static_cast<canopen::NmtState>(beat->frame.data[0] & kStateBits);
}

bool Context::expect_state(canopen::NmtState expected, const std::string& after) {
  std::optional<canopen::NmtState> now = state();
  if (now != expected) now = state();  // a heartbeat may have been under way before the command
  if (now == expected) return true;
  fail(fmt::format("{} after {}", name_of(expected), after),
       now ? fmt::format("state {} ({:02X}h)", name_of(*now), static_cast<unsigned>(*now)) : "no answer");
  return false;
}

bool Context::about(canopen::Duration measured, canopen::Duration wanted) const noexcept {
  const double allowed =
      settings_->tolerance * static_cast<double>(wanted.count()) + static_cast<double>(settings_->slack.count());
  return std::abs(static_cast<double>((measured - wanted).count())) <= allowed;
}

canopen::Duration Context::quiet(canopen::Duration most) const {
  constexpr std::ptrdiff_t kFew = 20, kLast = 100,
                           kDisturbed = 20;  // one of so many may be late for other reasons
  constexpr int kTimesAsLong = 10;
  constexpr canopen::Duration kLeast = std::chrono::milliseconds{10};
  const std::vector<canopen::Duration>& times = sdo_->response_times();
  if (std::ssize(times) < kFew) return most;
  std::vector<canopen::Duration> last(times.end() - std::min(std::ssize(times), kLast), times.end());
  const auto slow = last.end() - 1 - std::ssize(last) / kDisturbed;
  std::nth_element(last.begin(), slow, last.end());
  return std::min(most, std::max(kLeast, kTimesAsLong * *slow));
}

}  // namespace conformance
