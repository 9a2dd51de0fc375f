#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/read_ahead.hpp"
#include "tools/canopen-check/checks/shared/sdo_targets.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

constexpr std::uint8_t kStructure = 0xFF;  // sub-index
/// Uploads without an answer in a row, after which the rest of the objects is left.
constexpr int kMostSilent = 3;

bool without_eds(Context& context) {
  if (context.eds().empty()) context.skip("there is no EDS");
  return context.eds().empty();
}

std::vector<std::uint16_t> all_objects(const Context& context) {
  return context.eds().objects_within(0x0000, 0xFFFF);
}

/// Answers to one upload of 1000h:00; those that come late to others are none of them.
std::size_t answers_to_one_request(Context& context) {
  const auto belongs = [match =
                            SdoMatch{context.sdo().request(kInitiateUpload, object::kDeviceType), std::nullopt},
                        is_response = under(context.sdo().response_identifier())](const canopen::Frame& frame) {
    return is_response(frame) && match.fits(frame);
  };
  Session& session = context.session();
  session.drain();
  context.step();
  session.send(context.sdo().request(kInitiateUpload, object::kDeviceType));
  if (!session.wait_for(belongs, context.sdo().patience())) return 0;
  return 1 + session.collect(belongs, context.quiet(kQuiet)).size();
}

void is_alone(Context& context) {
  std::size_t answers = answers_to_one_request(context);
  // The first one may be a late answer to a request of before.
  if (answers != 1) answers = answers_to_one_request(context);
  if (answers == 0) context.fail("one answer", "none");
  if (answers > 1)
    context.fail("one answer to an upload of 1000h:00",
                 fmt::format("{}: two nodes have the same node-ID", answers));
}

void has_the_identity_of_the_eds(Context& context) {
  if (without_eds(context)) return;
  const eds::DeviceFacts& facts = context.eds().device();
  struct Part {
    std::uint8_t sub_index = 0;
    const char* name = nullptr;
    std::optional<std::uint64_t> stated{};
  };
  for (const Part& part : {Part{1, "VendorNumber", facts.vendor}, Part{2, "ProductNumber", facts.product},
                           Part{3, "RevisionNumber", facts.revision}}) {
    if (!part.stated || context.eds().find(object::kIdentity, part.sub_index) == nullptr) continue;
    const std::optional<std::uint64_t> value = context.number(object::kIdentity, part.sub_index);
    if (value && *value != *part.stated)
      context.fail(object::kIdentity, part.sub_index,
                   fmt::format("{:08X}h, {} of the EDS", *part.stated, part.name),
                   fmt::format("{:08X}h: the EDS may be of another device", *value));
  }
}

bool printable(std::uint8_t byte) {
  return byte >= 0x20 && byte < 0x7F;
}

void has_printable_names(Context& context) {
  bool any = false;
  for (std::uint16_t index = 0x1008; index <= 0x100A; ++index) {
    if (!context.eds().empty() && !context.eds().has(index)) continue;
    context.step();
    const SdoAnswer answer = context.read(index);
    if (!answer.done()) continue;
    any = true;
    if (!std::ranges::all_of(answer.data, printable))
      context.fail(index, 0, "printable characters of ASCII", hexadecimal(answer.data));
  }
  if (!any) context.skip("none of 1008h to 100Ah can be read");
}

void has_structures_of_the_eds(Context& context) {
  if (without_eds(context)) return;
  int found = 0, silent = 0;
  std::vector<Multiplexor> entries;
  for (const std::uint16_t index : all_objects(context))  // else it is an element like the others
    if (context.eds().find(index, kStructure) == nullptr) entries.push_back({index, kStructure});
  ReadAhead answers{context, entries};
  for (const auto& [index, sub_index] : entries) {
    const SdoAnswer answer = answers.next(&SdoAnswer::aborted);
    silent = answer.kind == SdoAnswer::Kind::Silent ? silent + 1 : 0;
    if (silent == kMostSilent) break;
    if (!answer.done()) continue;
    ++found;
    const auto code = static_cast<unsigned>(context.eds().code_of(index));
    const auto told = static_cast<unsigned>(answer.number() & 0xFFU);
    if (answer.data.size() != 4 || told != code)
      context.fail(index, kStructure, fmt::format("object code {:02X}h in four bytes", code),
                   hexadecimal(answer.data));
  }
  context.note(fmt::format("{} objects tell their structure", found));
}

/// Highest sub-index of @p index in the EDS, the structure FFh left out.
std::uint8_t highest_of(const eds::Description& eds, std::uint16_t index) {
  std::uint8_t highest = 0;
  for (const eds::EntryFacts& entry : eds.entries_of(index))
    if (entry.sub_index != kStructure) highest = entry.sub_index;
  return highest;
}

bool has_type_of_counts(const eds::EntryFacts& count) {
  constexpr std::uint16_t kUnsigned8 = 0x0005;
  return count.type != nullptr && count.type->number == kUnsigned8;
}

/// Sub-index 0 of every array and record.
std::vector<const eds::EntryFacts*> all_counts(const Context& context) {
  std::vector<const eds::EntryFacts*> counts;
  for (const std::uint16_t index : all_objects(context)) {
    const eds::ObjectCode code = context.eds().code_of(index);
    if (code != eds::ObjectCode::Array && code != eds::ObjectCode::Record) continue;
    if (const eds::EntryFacts* const count = context.eds().find(index)) counts.push_back(count);
  }
  return counts;
}

void judge_count(Context& context, const eds::EntryFacts& count, ReadAhead& answers) {
  const std::uint8_t highest = highest_of(context.eds(), count.index);
  // What can be written counts the entries in use: mapped objects, errors.
  const auto is_right = [&](const SdoAnswer& answer) {
    return answer.done() && (count.writable() ? answer.number() <= highest : answer.number() == highest);
  };
  const SdoAnswer answer = answers.next(is_right);
  if (!answer.done() || is_right(answer)) return;  // what cannot be read is a matter of device.readable
  context.fail(
      count.index, 0,
      fmt::format("{}{:02X}h, the highest sub-index of the EDS", count.writable() ? "at most " : "", highest),
      fmt::format("{:02X}h", answer.number()));
}

void counts_sub_indices(Context& context) {
  if (without_eds(context)) return;
  const std::vector<const eds::EntryFacts*> counts = all_counts(context);
  std::vector<Multiplexor> entries;
  for (const eds::EntryFacts* const count : counts)
    if (has_type_of_counts(*count)) entries.push_back({count->index, 0});
  ReadAhead answers{context, std::move(entries)};
  for (const eds::EntryFacts* const count : counts) {
    if (context.session().ended()) return;
    if (has_type_of_counts(*count))
      judge_count(context, *count, answers);
    else
      context.fail(count->index, 0, "an UNSIGNED8 with the highest sub-index",
                   count->type == nullptr ? "another type" : std::string{count->type->name});
  }
}

void has_no_other_sub_indices(Context& context) {
  if (without_eds(context)) return;
  std::vector<Multiplexor> entries;
  for (const std::uint16_t index : all_objects(context)) {
    const auto next = static_cast<std::uint8_t>(highest_of(context.eds(), index) + 1);
    if (next != kStructure && next != 0) entries.push_back({index, next});
  }
  int silent = 0;
  ReadAhead answers{context, entries};
  for (const auto& [index, next] : entries) {
    const SdoAnswer answer = answers.next(&SdoAnswer::aborted);
    silent = answer.kind == SdoAnswer::Kind::Silent ? silent + 1 : 0;
    if (silent == kMostSilent) break;
    if (answer.done()) context.fail(index, next, "no sub-index that the EDS does not have", to_text(answer));
  }
}

/// Longest time that the scan of all indices may take; on slow buses it ends there.
constexpr canopen::Duration kScanLimit = std::chrono::seconds{15};

bool says_absent(const SdoAnswer& answer) {
  constexpr std::array kAbsent{canopen::AbortCode::NoObject, canopen::AbortCode::NoSubIndex,
                               canopen::AbortCode::GeneralError};
  return answer.aborted() &&
         std::ranges::find(kAbsent, static_cast<canopen::AbortCode>(answer.abort_code)) != kAbsent.end();
}

/// Asks for every index from @p first to @p last that the EDS does not have; the first one that was not asked.
unsigned scan(Context& context, unsigned first, unsigned last, canopen::TimePoint until) {
  std::vector<Multiplexor> entries;
  for (unsigned index = first; index <= last; ++index)
    if (!context.eds().has(static_cast<std::uint16_t>(index)))
      entries.push_back({static_cast<std::uint16_t>(index), 0});
  int silent = 0;
  ReadAhead answers{context, entries};
  for (const auto& [object, sub_index] : entries) {
    if (context.session().now() > until || silent == kMostSilent || context.session().ended()) return object;
    const SdoAnswer answer = answers.next(says_absent);
    silent = answer.kind == SdoAnswer::Kind::Silent ? silent + 1 : 0;
    // Which code a node has for what does not exist is a matter of the SDO checks.
    if (answer.done() || (answer.aborted() && !says_absent(answer)))
      context.fail(Subject{object, std::nullopt}, "no object that the EDS does not have", to_text(answer));
  }
  return last + 1;
}

void has_no_other_objects(Context& context) {
  if (without_eds(context)) return;
  struct Area {
    unsigned first, last;
  };
  // The area of the manufacturer is his own: what he does not describe is no finding.
  constexpr std::array kAreas{Area{0x1000, 0x1FFF}, Area{0x6000, 0x9FFF}};
  const canopen::TimePoint until = context.session().now() + kScanLimit;
  for (const Area& area : kAreas) {
    const unsigned next = scan(context, area.first, area.last, until);
    if (next <= area.last) context.note(fmt::format("{:04X}h to {:04X}h were not asked for", next, area.last));
  }
}

constexpr std::array kChecks{
    Check{.id = "device.alone",
          .name = "One node answers under the node-ID",
          .clause = "CiA 301 7.3.5",
          .group = Group::Device,
          .mode = Mode::ReadOnly,
          .run = is_alone},
    Check{.id = "device.identity",
          .name = "1018h is the identity that the EDS states",
          .clause = "CiA 301 7.5.2.21",
          .group = Group::Device,
          .mode = Mode::ReadOnly,
          .run = has_the_identity_of_the_eds},
    Check{.id = "device.names",
          .name = "1008h to 100Ah are printable",
          .clause = "CiA 301 7.5.2.8",
          .group = Group::Device,
          .mode = Mode::ReadOnly,
          .run = has_printable_names},
    Check{.id = "device.sub-index-count",
          .name = "Sub-index 0 of every array and record is the highest sub-index of the EDS",
          .clause = "CiA 301 7.4.3",
          .group = Group::Device,
          .mode = Mode::ReadOnly,
          .run = counts_sub_indices},
    Check{.id = "device.other-sub-indices",
          .name = "No object goes on behind its highest sub-index of the EDS",
          .clause = "CiA 306 4.6",
          .group = Group::Device,
          .mode = Mode::ReadOnly,
          .run = has_no_other_sub_indices},
    Check{.id = "device.structure",
          .name = "Sub-index FFh tells the structure that the EDS states",
          .clause = "CiA 301 7.4.3",
          .group = Group::Device,
          .mode = Mode::ReadOnly,
          .run = has_structures_of_the_eds},
    Check{.id = "device.other-objects",
          .name = "1000h to 1FFFh and 6000h to 9FFFh have no object that the EDS does not have",
          .clause = "CiA 306 4.5",
          .group = Group::Device,
          .mode = Mode::ReadOnly,
          .run = has_no_other_objects},
};

}  // namespace

std::span<const Check> device_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
