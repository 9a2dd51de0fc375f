#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/sdo_targets.hpp"

namespace conformance {
namespace {

using canopen::AbortCode;

constexpr std::size_t kExpedited = 4, kSegment = 7;

void confirms_expedited_downloads(Context& context) {
  bool any = false;
  for (const std::size_t bytes : {std::size_t{1}, std::size_t{2}, std::size_t{4}}) {
    const std::optional<Target> target = writable_number(context, bytes);
    if (!target) continue;
    any = true;
    context.step();
    const SdoAnswer answer = context.write(target->index, target->sub_index, target->value);
    const SdoAnswer now = context.read(target->index, target->sub_index);
    if (!answer.done()) context.fail(target->index, target->sub_index, "it takes its own value", to_text(answer));
    if (answer.done() && now.data != target->value)
      context.fail(target->index, target->sub_index, hexadecimal(target->value) + " as written", to_text(now));
  }
  if (!any) context.skip("no number that may be written");
}

void takes_downloads_without_size(Context& context) {
  constexpr std::uint8_t kExpeditedUnsized = 0x22;
  const std::optional<Target> target = writable_number(context, kExpedited);
  if (!target) return context.skip("no number of four bytes that may be written");
  const auto value = static_cast<std::uint32_t>(SdoAnswer{.data = target->value}.number());
  context.undo().keep(target->index, target->sub_index);
  context.step();
  const SdoAnswer answer =
      ask(context, context.sdo().request(kExpeditedUnsized, target->index, target->sub_index, value));
  if (!begins_with(answer, kDownloadInitiated))
    context.fail(target->index, target->sub_index, "four bytes are taken though their number is not indicated",
                 to_text(answer));
}

/// Begins a download of @p size bytes in segments; false, and the check is skipped, where the server does
/// not.
bool begin_download(Context& context, const Target& target, std::uint32_t size) {
  context.step();
  context.undo().keep(target.index, target.sub_index);
  const SdoAnswer answer =
      ask(context, context.sdo().request(kInitiateDownloadSized, target.index, target.sub_index, size));
  const bool begun = begins_with(answer, kDownloadInitiated);
  if (!begun) context.skip("no download in segments: " + to_text(answer));
  return begun;
}

/// The entry with which downloads in segments are tried: a text, else a number.
std::optional<Target> segmented_target(Context& context) {
  std::optional<Target> target = writable_text(context, false);
  for (const std::size_t bytes : {std::size_t{2}, std::size_t{4}, std::size_t{1}})
    if (!target || target->value.empty()) target = writable_number(context, bytes);
  if (!target) context.skip("no text and no number that may be written");
  return target;
}

void refuses_download_toggle(Context& context) {
  const std::optional<Target> target = segmented_target(context);
  if (!target || !begin_download(context, *target, static_cast<std::uint32_t>(target->value.size()))) return;
  context.expect_abort(ask(context, segment(context, kDownloadSegment | kToggleBit, target->value)),
                       {number_of(AbortCode::ToggleBitNotAlternated)}, target->index, target->sub_index,
                       "a wrong toggle bit");
  context.expect_abort(ask(context, segment(context, kDownloadSegment, target->value)),
                       {number_of(AbortCode::CommandSpecifierInvalid)}, target->index, target->sub_index,
                       "a segment after the end of the transfer");
}

void downloads_short_values_in_segments(Context& context) {
  const std::optional<Target> target = writable_number(context, 2);
  if (!target) return context.skip("no number of two bytes that may be written");
  context.step();
  context.undo().keep(target->index, target->sub_index);
  const SdoAnswer answer = context.sdo().download_in_segments(target->index, target->sub_index, target->value);
  if (!answer.done())
    context.fail(target->index, target->sub_index, "its own value is taken in a segment", to_text(answer));
}

void downloads_texts_in_segments(Context& context) {
  const std::optional<Target> target = writable_text(context, false);
  if (!target) return context.skip("no text that may be written");
  context.step();
  const SdoAnswer answer = context.write(target->index, target->sub_index, target->value);
  if (!answer.done())
    return context.fail(target->index, target->sub_index, "its own value is taken in segments", to_text(answer));
  const SdoAnswer now = context.read(target->index, target->sub_index);
  if (now.data != target->value)
    context.fail(target->index, target->sub_index, hexadecimal(target->value) + " as written", to_text(now));
}

void refuses_more_than_announced(Context& context) {
  const std::optional<Target> target = writable_number(context, 2);
  if (!target) return context.skip("no number of two bytes that may be written");
  if (!begin_download(context, *target, 2)) return;
  constexpr std::uint8_t kThreeBytes = (kSegment - 3) << 1U | kLastSegmentBit;
  context.expect_abort(ask(context, segment(context, kThreeBytes, target->value)),
                       {number_of(AbortCode::LengthTooHigh), number_of(AbortCode::LengthMismatch)}, target->index,
                       target->sub_index, "three bytes of two that were announced");
}

void refuses_less_than_announced(Context& context) {
  const std::optional<Target> target = writable_number(context, 2);
  if (!target) return context.skip("no number of two bytes that may be written");
  if (!begin_download(context, *target, 2)) return;
  constexpr std::uint8_t kOneByte = (kSegment - 1) << 1U | kLastSegmentBit;
  context.expect_abort(ask(context, segment(context, kOneByte, std::span{target->value}.first(1))),
                       {number_of(AbortCode::LengthTooLow), number_of(AbortCode::LengthMismatch)}, target->index,
                       target->sub_index, "one byte of two that were announced");
}

void takes_unannounced_sizes(Context& context) {
  const std::optional<Target> target = segmented_target(context);
  if (!target) return;
  context.undo().keep(target->index, target->sub_index);
  context.step();
  SdoAnswer answer = ask(context, context.sdo().request(kInitiateDownload, target->index, target->sub_index));
  std::uint8_t toggle = 0;
  std::span<const std::uint8_t> left = target->value;
  bool confirmed = begins_with(answer, kDownloadInitiated);
  while (confirmed && !left.empty()) {
    const std::size_t size = std::min(kSegment, left.size());
    const auto ending = static_cast<std::uint8_t>((kSegment - size) << 1U | (size == left.size() ? 1U : 0U));
    answer = ask(context, segment(context, ending | toggle, left.first(size)));
    confirmed = begins_with(answer, 0x20 | toggle);
    left = left.subspan(size);
    toggle ^= kToggleBit;
  }
  if (!confirmed)
    context.fail(target->index, target->sub_index, "its own value, whose size is not announced, is taken",
                 to_text(answer));
}

constexpr std::array kChecks{
    Check{.id = "sdo.download-toggle-error",
          .name = "A wrong toggle bit in a download is refused with 05030000h and ends it",
          .clause = "CiA 301 7.2.4.3.4",
          .group = Group::Sdo,
          .run = refuses_download_toggle},
    Check{.id = "sdo.expedited-download",
          .name = "Up to four bytes are downloaded in one frame",
          .clause = "CiA 301 7.2.4.3.3",
          .group = Group::Sdo,
          .run = confirms_expedited_downloads},
    Check{.id = "sdo.unsized-download",
          .name = "Four bytes in one frame are taken though their number is not indicated",
          .clause = "CiA 301 7.2.4.3.3",
          .group = Group::Sdo,
          .run = takes_downloads_without_size},
    Check{.id = "sdo.short-segmented-download",
          .name = "Two bytes are taken in a segment too",
          .clause = "CiA 301 7.2.4.3.4",
          .group = Group::Sdo,
          .run = downloads_short_values_in_segments},
    Check{.id = "sdo.segmented-download",
          .name = "A text is downloaded in segments",
          .clause = "CiA 301 7.2.4.3.4",
          .group = Group::Sdo,
          .run = downloads_texts_in_segments},
    Check{.id = "sdo.more-than-announced",
          .name = "More data than announced are refused with 06070012h",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .run = refuses_more_than_announced},
    Check{.id = "sdo.less-than-announced",
          .name = "Fewer data than announced are refused with 06070013h",
          .clause = "CiA 301 7.2.4.3.17",
          .group = Group::Sdo,
          .run = refuses_less_than_announced},
    Check{.id = "sdo.unannounced-size",
          .name = "A download in segments need not announce its size",
          .clause = "CiA 301 7.2.4.3.3",
          .group = Group::Sdo,
          .run = takes_unannounced_sizes},
};

}  // namespace

std::span<const Check> sdo_download_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
