#include "tools/canopen-check/checks/shared/sdo_targets.hpp"

#include <algorithm>

#include "eds/sheet/object_lists.hpp"
#include "tools/canopen-check/core/run/protected_entries.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

/// Entries that are asked until one fits; a device may refuse some of them.
constexpr int kMostAsked = 30;

/// The first entry of the EDS that @p fits, and whose value @p takes.
template <class Fits, class Takes>
std::optional<Target> first_entry(Context& context, Fits fits, Takes takes) {
  int asked = 0;
  for (const eds::EntryFacts& entry : context.eds().entries()) {
    if (asked == kMostAsked || context.session().ended()) break;
    if (!fits(entry)) continue;
    ++asked;
    SdoAnswer answer = context.read(entry.index, entry.sub_index);
    if (answer.done() && takes(answer.data)) return Target{entry.index, entry.sub_index, std::move(answer.data)};
  }
  return std::nullopt;
}

}  // namespace

bool harmless(const eds::EntryFacts& entry, const Settings& settings) noexcept {
  Settings calm = settings;
  calm.allow_motion = calm.allow_store = false;
  const bool pdo = entry.index >= object::kRpdoParameter && entry.index < object::kPdosEnd;
  return entry.writable() && !pdo && eds::find_cob_id(entry.index, entry.sub_index) == nullptr &&
         write_refusal(entry, calm) == nullptr;
}

std::optional<Target> writable_number(Context& context, std::size_t bytes) {
  constexpr std::size_t kHeartbeatBytes = 2;
  const auto takes = [bytes](const std::vector<std::uint8_t>& value) { return value.size() == bytes; };
  if (context.eds().empty() && bytes == kHeartbeatBytes) {
    SdoAnswer answer = context.read(object::kHeartbeatTime);
    if (answer.done() && takes(answer.data)) return Target{object::kHeartbeatTime, 0, std::move(answer.data)};
  }
  return first_entry(
      context,
      [&](const eds::EntryFacts& entry) {
        return entry.numeric() && entry.bytes() == bytes && entry.type->bits != 1 && entry.readable() &&
               !entry.no_read && harmless(entry, context.settings());
      },
      takes);
}

std::optional<Target> writable_text(Context& context, bool domain) {
  constexpr std::uint16_t kDomain = 0x000F;
  return first_entry(
      context,
      [&](const eds::EntryFacts& entry) {
        return entry.type != nullptr && !entry.numeric() && entry.readable() && !entry.no_read &&
               (entry.type->number == kDomain) == domain && harmless(entry, context.settings());
      },
      [](const auto&) { return true; });
}

std::optional<Target> long_entry(Context& context, std::size_t bytes) {
  if (context.eds().empty()) {
    for (std::uint16_t index = object::kDeviceName; index <= object::kSoftwareVersion; ++index)
      if (SdoAnswer answer = context.read(index); answer.done() && answer.data.size() > bytes)
        return Target{index, 0, std::move(answer.data)};
    return std::nullopt;
  }
  return first_entry(
      context,
      [&](const eds::EntryFacts& entry) {
        return entry.readable() && !entry.no_read && entry.type != nullptr &&
               (!entry.numeric() || entry.bytes() > bytes);
      },
      [bytes](const std::vector<std::uint8_t>& value) { return value.size() > bytes; });
}

SdoAnswer answer_of(const std::optional<canopen::Frame>& frame) {
  if (!frame) return {};
  if (const auto code = abort_code(*frame)) return {.kind = SdoAnswer::Kind::Aborted, .abort_code = *code};
  const auto length = std::min<std::ptrdiff_t>(frame->length, 8);
  return {.kind = SdoAnswer::Kind::Done, .data = {frame->data.begin(), frame->data.begin() + length}};
}

SdoAnswer ask(Context& context, const canopen::Frame& request) {
  return answer_of(context.sdo().exchange(request));
}

canopen::Frame segment(Context& context, std::uint8_t command, std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kMost = 7;
  canopen::Frame frame = context.sdo().request(command);
  std::ranges::copy(bytes.first(std::min(bytes.size(), kMost)), frame.data.begin() + 1);
  return frame;
}

void expect_service(Context& context, const std::string& after) {
  expect_service(context, context.read(object::kDeviceType), after);
}

void expect_service(Context& context, const SdoAnswer& answer, const std::string& after) {
  if (!answer.done()) context.fail("an answer to an upload of 1000h:00 after " + after, to_text(answer));
}

}  // namespace conformance
