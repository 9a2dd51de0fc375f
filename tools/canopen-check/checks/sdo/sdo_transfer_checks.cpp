#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/read_ahead.hpp"
#include "tools/canopen-check/checks/shared/sdo_targets.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

using canopen::AbortCode;

constexpr std::size_t kExpedited = 4, kSegment = 7;
constexpr const char* kNoLongEntry = "no entry that can be read has more than four bytes";

/// What is wrong with an expedited answer.
struct Complaint {
  std::string expected, found;
};

/// The numbers of at most four bytes that can be uploaded; without an EDS 1000h.
std::vector<Multiplexor> short_entries(const Context& context) {
  if (context.eds().empty()) return {{object::kDeviceType, 0}};
  std::vector<Multiplexor> entries;
  for (const eds::EntryFacts& entry : context.eds().entries())
    if (entry.numeric() && entry.bytes() <= kExpedited && entry.readable() && !entry.no_read)
      entries.push_back({entry.index, entry.sub_index});
  return entries;
}

/// Uploads every number of at most four bytes; what @p judge complains about, given its length by the EDS and the
/// raw answer, is a finding.
template <class Judge>
void for_each_expedited(Context& context, Judge judge) {
  const auto complaint = [&](const Multiplexor& entry, const SdoAnswer& answer) -> std::optional<Complaint> {
    const eds::EntryFacts* const facts = context.eds().find(entry.index, entry.sub_index);
    if (!answer.done() || answer.data.size() != 8) return std::nullopt;
    return judge(facts != nullptr ? facts->bytes() : kExpedited, answer.data);
  };
  const std::vector<Multiplexor> entries = short_entries(context);
  ReadAhead answers{context, entries};
  for (const Multiplexor& entry : entries) {
    if (const auto early = answers.next_frame(); early && !complaint(entry, answer_of(early))) continue;
    answers.begin_step();
    const SdoAnswer answer = ask(context, context.sdo().request(kInitiateUpload, entry.index, entry.sub_index));
    if (answer.kind == SdoAnswer::Kind::Silent) return;
    if (auto found = complaint(entry, answer))
      context.fail(entry.index, entry.sub_index, std::move(found->expected), std::move(found->found));
  }
}

void uploads_expedited(Context& context) {
  for_each_expedited(context, [](std::size_t bytes, const std::vector<std::uint8_t>& data) {
    const auto command = static_cast<std::uint8_t>(0x43U | (kExpedited - bytes) << 2U);
    // Four bytes need not be counted, and a number of another length is a matter of device.length.
    const bool uncounted = bytes == kExpedited && data[0] == 0x42;
    const bool other_length = (data[0] & 0xF3U) == 0x43;
    return uncounted || other_length ? std::nullopt
                                     : std::optional{Complaint{fmt::format("command byte {:02X}h", command),
                                                               fmt::format("{:02X}h", data[0])}};
  });
}

void clears_unused_bytes(Context& context) {
  for_each_expedited(context, [](std::size_t bytes, const std::vector<std::uint8_t>& data) {
    const std::size_t told = (data[0] & 0xF3U) == 0x43 ? kExpedited - (data[0] >> 2U & 3U) : bytes;
    const auto unused = std::span{data}.subspan(4 + std::max(bytes, told));
    return std::ranges::all_of(unused, [](std::uint8_t byte) { return byte == 0; })
               ? std::nullopt
               : std::optional{
                     Complaint{fmt::format("zeros behind {} bytes of data", bytes), hexadecimal(unused)}};
  });
}

void announces_sizes(Context& context) {
  const std::optional<Target> target = long_entry(context, kExpedited);
  if (!target) return context.skip(kNoLongEntry);
  context.step();
  const SdoAnswer answer = context.read(target->index, target->sub_index);
  if (!answer.done() || (answer.announced && *answer.announced != answer.data.size()))
    context.fail(target->index, target->sub_index,
                 fmt::format("{} bytes, as announced", answer.announced.value_or(0)),
                 answer.done() ? std::to_string(answer.data.size()) : to_text(answer));
  if (!answer.announced) context.note("the size is not announced");
}

/// Begins an upload in segments; false, and the check is skipped, where the server does not.
bool begin_upload(Context& context, const Target& target) {
  context.step();
  const SdoAnswer answer = ask(context, context.sdo().request(kInitiateUpload, target.index, target.sub_index));
  const bool begun = begins_with(answer, 0x40) || begins_with(answer, 0x41);
  if (!begun) context.skip("no upload in segments: " + to_text(answer));
  return begun;
}

/// Begins an upload in segments of the first entry that has them; an entry that cannot be read to its end counts
/// too.
std::optional<Target> begin_any_upload(Context& context) {
  const auto begun = [&](std::uint16_t index, std::uint8_t sub_index) {
    const SdoAnswer answer = ask(context, context.sdo().request(kInitiateUpload, index, sub_index));
    return begins_with(answer, 0x40) || begins_with(answer, 0x41);
  };
  for (std::uint16_t index = object::kDeviceName; index <= object::kSoftwareVersion; ++index)
    if (begun(index, 0)) return Target{index, 0};
  for (const eds::EntryFacts& entry : context.eds().entries()) {
    const bool text = entry.type != nullptr && !entry.numeric() && entry.readable() && !entry.no_read;
    if (text && begun(entry.index, entry.sub_index)) return Target{entry.index, entry.sub_index};
  }
  return std::nullopt;
}

void alternates_toggle_bits(Context& context) {
  constexpr int kMostSegments = 20;
  context.step();
  const std::optional<Target> target = begin_any_upload(context);
  if (!target) return context.skip(kNoLongEntry);
  std::uint8_t toggle = 0;
  for (int i = 0; i < kMostSegments; ++i, toggle ^= kToggleBit) {
    const SdoAnswer answer = ask(context, context.sdo().request(kUploadSegment | toggle));
    if (!answer.done() || answer.data.empty() || (answer.data[0] & 0xF0U) != toggle) {
      context.fail(target->index, target->sub_index, fmt::format("a segment with toggle bit {}", toggle >> 4U),
                   to_text(answer));
      break;
    }
    if ((answer.data[0] & kLastSegmentBit) != 0) return;
  }
  context.sdo().abort(target->index, target->sub_index, number_of(AbortCode::ToggleBitNotAlternated));
}

void refuses_upload_toggle(Context& context) {
  const std::optional<Target> target = long_entry(context, kExpedited);
  if (!target) return context.skip(kNoLongEntry);
  if (!begin_upload(context, *target)) return;
  std::uint8_t repeated = kToggleBit;
  if (target->value.size() > kSegment) {
    (void)ask(context, context.sdo().request(kUploadSegment));
    repeated = 0;
  }
  context.expect_abort(ask(context, context.sdo().request(kUploadSegment | repeated)),
                       {number_of(AbortCode::ToggleBitNotAlternated)}, target->index, target->sub_index,
                       "a wrong toggle bit");
  context.expect_abort(ask(context, context.sdo().request(kUploadSegment | (repeated ^ kToggleBit))),
                       {number_of(AbortCode::CommandSpecifierInvalid)}, target->index, target->sub_index,
                       "a segment after the end of the transfer");
}

constexpr std::array kChecks{
    Check{.id = "sdo.expedited-upload",
          .name = "Up to four bytes are uploaded in one frame that tells their number",
          .clause = "CiA 301 7.2.4.3.6",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = uploads_expedited},
    Check{.id = "sdo.unused-bytes",
          .name = "Bytes behind the data of an expedited upload are 0",
          .clause = "CiA 301 7.2.4.3.6",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = clears_unused_bytes},
    Check{.id = "sdo.announced-size",
          .name = "An upload in segments has as many bytes as it announces",
          .clause = "CiA 301 7.2.4.3.6",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = announces_sizes},
    Check{.id = "sdo.toggle-bit",
          .name = "The toggle bit of an upload begins with 0 and alternates",
          .clause = "CiA 301 7.2.4.3.7",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = alternates_toggle_bits},
    Check{.id = "sdo.upload-toggle-error",
          .name = "A wrong toggle bit in an upload is refused with 05030000h and ends it",
          .clause = "CiA 301 7.2.4.3.7",
          .group = Group::Sdo,
          .mode = Mode::ReadOnly,
          .run = refuses_upload_toggle},
};

}  // namespace

std::span<const Check> sdo_transfer_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
