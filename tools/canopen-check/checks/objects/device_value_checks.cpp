#include <array>

#include <fmt/format.h>

#include "eds/sheet/object_lists.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/read_ahead.hpp"
#include "tools/canopen-check/checks/shared/sdo_targets.hpp"
#include "tools/canopen-check/core/run/protected_entries.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

using canopen::AbortCode;

constexpr int kMostSilent = 3;

/// What is wrong with a value.
struct Complaint {
  std::string expected, found;
};
using Complaints = std::vector<Complaint>;

/// The entries that the EDS calls readable and @p concerns.
template <class Concerns>
std::vector<const eds::EntryFacts*> readable_entries(const Context& context, Concerns concerns) {
  std::vector<const eds::EntryFacts*> entries;
  for (const eds::EntryFacts& entry : context.eds().entries())
    if (entry.readable() && !entry.no_read && concerns(entry)) entries.push_back(&entry);
  return entries;
}

/// Skips the check without @p entries, or without an EDS.
bool any(Context& context, const std::vector<const eds::EntryFacts*>& entries) {
  if (entries.empty()) context.skip(context.eds().empty() ? "there is no EDS" : "the EDS has no such entry");
  return !entries.empty();
}

/// Uploads every entry that the EDS calls readable and @p concerns; what @p judge complains about in its answer is
/// a finding. Stops when the node has become silent.
template <class Concerns, class Judge>
void for_each_value(Context& context, Concerns concerns, Judge judge) {
  const std::vector<const eds::EntryFacts*> entries = readable_entries(context, concerns);
  if (!any(context, entries)) return;
  std::vector<Multiplexor> asked;
  for (const eds::EntryFacts* const entry : entries) asked.push_back({entry->index, entry->sub_index});
  ReadAhead answers{context, std::move(asked)};
  int silent = 0, read = 0;
  for (const eds::EntryFacts* const entry : entries) {
    const SdoAnswer answer = answers.next([&](const SdoAnswer& early) { return judge(*entry, early).empty(); });
    silent = answer.kind == SdoAnswer::Kind::Silent ? silent + 1 : 0;
    if (context.session().ended() || silent > kMostSilent) break;
    for (Complaint& complaint : judge(*entry, answer))
      context.fail(entry->index, entry->sub_index, std::move(complaint.expected), std::move(complaint.found));
    ++read;
  }
  if (read == 0) return context.skip("the EDS has no such entry");
  context.note(fmt::format("{} entries", read));
}

void reads_every_object(Context& context) {
  for_each_value(
      context, [](const eds::EntryFacts&) { return true; },
      [&](const eds::EntryFacts& entry, const SdoAnswer& answer) -> Complaints {
        // An entry without data, such as one of an empty error history.
        const bool empty = answer.aborted() && answer.abort_code == number_of(AbortCode::NoData);
        // What is no answer of the protocol is a matter of the SDO checks.
        const bool none =
            answer.aborted() || answer.kind == SdoAnswer::Kind::Silent || answer.kind == SdoAnswer::Kind::Endless;
        if (answer.kind == SdoAnswer::Kind::Cut)
          context.note(fmt::format("{}: {}", to_text(Subject{entry.index, entry.sub_index}), to_text(answer)));
        if (none && !empty) return {{"a value", to_text(answer)}};
        return {};
      });
}

void has_the_length_of_its_type(Context& context) {
  for_each_value(
      context, [](const eds::EntryFacts& entry) { return entry.numeric(); },
      [](const eds::EntryFacts& entry, const SdoAnswer& answer) -> Complaints {
        const std::size_t size = answer.announced.value_or(static_cast<std::uint32_t>(answer.data.size()));
        if (!answer.done() || size == entry.bytes()) return {};
        return {{fmt::format("{} bytes ({})", entry.bytes(), entry.type->name),
                 fmt::format("{}: {}", size, hexadecimal(answer.data))}};
      });
}

/// True if @p low is at most @p high, two numbers of one type on the node @p node_id.
bool ordered_on(std::uint8_t node_id, const eds::Value& low, const eds::Value& high) {
  if (low.kind == eds::ValueKind::Real) return !(low.real > high.real);
  const auto one = low.at(node_id), other = high.at(node_id);
  return !one || !other || *one <= *other;
}

void lies_within_its_limits(Context& context) {
  const std::uint8_t node_id = context.eds().node_id();
  for_each_value(
      context, [](const eds::EntryFacts& entry) { return entry.numeric() && (entry.low || entry.high); },
      [&](const eds::EntryFacts& entry, const SdoAnswer& answer) {
        Complaints complaints;
        if (!answer.done() || answer.data.size() != entry.bytes()) return complaints;
        const eds::Value value = decode(answer.data, *entry.type);
        if (entry.low && !ordered_on(node_id, *entry.low, value))
          complaints.push_back({"a value from LowLimit on", hexadecimal(answer.data)});
        if (entry.high && !ordered_on(node_id, value, *entry.high))
          complaints.push_back({"a value up to HighLimit", hexadecimal(answer.data)});
        return complaints;
      });
}

/// Complains if @p answer is another value than the EDS states.
Complaints judge_initial(const Context& context, const eds::EntryFacts& entry, const SdoAnswer& answer) {
  const auto initial = encode(*entry.initial, *entry.type, context.eds().node_id());
  // The length of a number is a matter of device.length.
  const bool other_length = initial && entry.numeric() && answer.data.size() != initial->size();
  if (!answer.done() || !initial || other_length || answer.data == *initial) return {};
  return {{hexadecimal(*initial) + ", the DefaultValue of the EDS",
           answer.data.empty() ? "nothing" : hexadecimal(answer.data)}};
}

bool has_initial(const eds::EntryFacts& entry) {
  return entry.type != nullptr && entry.initial.has_value();
}

/// Sub-index 0 that counts the others.
bool counts(const Context& context, const eds::EntryFacts& entry) {
  const eds::ObjectCode code = context.eds().code_of(entry.index);
  return entry.sub_index == 0 && (code == eds::ObjectCode::Array || code == eds::ObjectCode::Record);
}

void keeps_its_constants(Context& context) {
  for_each_value(
      context,
      [&](const eds::EntryFacts& entry) {
        return has_initial(entry) && entry.access == canopen::Access::Constant && !counts(context, entry);
      },
      [&](const eds::EntryFacts& entry, const SdoAnswer& answer) {
        return judge_initial(context, entry, answer);
      });
}

void has_the_defaults_of_the_eds(Context& context) {
  constexpr std::uint64_t kLoad = 0x64616F6C;  // "load"
  if (!context.need(object::kRestoreParameters, 1)) return;
  context.step();
  const SdoAnswer loaded = context.sdo().download(object::kRestoreParameters, 1, eds::little_endian(kLoad, 4));
  if (!loaded.done()) return context.fail(object::kRestoreParameters, 1, "\"load\" is taken", to_text(loaded));
  if (!context.restart(canopen::NmtCommand::ResetNode)) return;
  // Entries that are read only change by themselves: inputs, states.
  for_each_value(
      context,
      [](const eds::EntryFacts& entry) {
        return has_initial(entry) && entry.writable() && entry.index != object::kStoreParameters &&
               entry.index != object::kRestoreParameters;
      },
      [&](const eds::EntryFacts& entry, const SdoAnswer& answer) {
        return judge_initial(context, entry, answer);
      });
  context.note("values that the node had stored are replaced by the defaults; save the ones wanted again");
}

/// Objects that are written in an order of their own, or by a word.
bool written_by_procedure(std::uint16_t index) {
  return index == object::kStoreParameters || index == object::kRestoreParameters ||
         eds::is_mapping_parameter(index);
}

bool takes_at_any_time(const eds::EntryFacts& entry, const Settings& settings) {
  return entry.writable() && entry.numeric() && !written_by_procedure(entry.index) &&
         write_refusal(entry, settings) == nullptr;
}

void takes_its_own_values(Context& context) {
  const std::vector<const eds::EntryFacts*> entries = readable_entries(
      context, [&](const eds::EntryFacts& entry) { return takes_at_any_time(entry, context.settings()); });
  if (!any(context, entries)) return;
  int refused_now = 0, silent = 0, read = 0;
  for (const eds::EntryFacts* const entry : entries) {
    context.session().forget();
    context.step();
    const SdoAnswer value = context.undo().keep(entry->index, entry->sub_index);
    silent = value.kind == SdoAnswer::Kind::Silent ? silent + 1 : 0;
    if (context.session().ended() || silent > kMostSilent) break;
    ++read;
    if (!value.done()) continue;
    const SdoAnswer answer = context.sdo().download(entry->index, entry->sub_index, value.data);
    const bool not_now = answer.aborted() && (answer.abort_code == number_of(AbortCode::DeviceState) ||
                                              answer.abort_code == number_of(AbortCode::LocalControl));
    if (not_now) ++refused_now;
    const bool refused = answer.aborted() || answer.kind == SdoAnswer::Kind::Silent;
    if (refused && !not_now)
      context.fail(entry->index, entry->sub_index, "its own value " + hexadecimal(value.data) + " is taken",
                   to_text(answer));
  }
  context.note(fmt::format("{} entries", read));
  if (refused_now > 0)
    context.note(fmt::format("{} entries cannot be written in the present state of the node", refused_now));
}

constexpr std::array kChecks{
    Check{.id = "device.readable",
          .name = "Every object that the EDS calls readable can be read",
          .clause = "CiA 301 7.4.1",
          .group = Group::Device,
          .mode = Mode::ReadOnly,
          .run = reads_every_object},
    Check{.id = "device.length",
          .name = "Every number has the length of the type that the EDS states",
          .clause = "CiA 301 7.4.7",
          .group = Group::Device,
          .mode = Mode::ReadOnly,
          .run = has_the_length_of_its_type},
    Check{.id = "device.limits",
          .name = "Every value lies within the limits of the EDS",
          .clause = "CiA 306 4.6",
          .group = Group::Device,
          .mode = Mode::ReadOnly,
          .run = lies_within_its_limits},
    Check{.id = "device.constants",
          .name = "Every constant has the default of the EDS",
          .clause = "CiA 306 4.6",
          .group = Group::Device,
          .mode = Mode::ReadOnly,
          .run = keeps_its_constants},
    Check{.id = "device.write-back",
          .name = "Every number that can be written takes the value that it has",
          .clause = "CiA 301 7.4.1",
          .group = Group::Device,
          .run = takes_its_own_values},
    Check{.id = "device.defaults",
          .name = "After \"load\" and a reset every value is the default of the EDS; stored values are lost",
          .clause = "CiA 301 7.5.2.14",
          .group = Group::Device,
          .stores = true,
          .run = has_the_defaults_of_the_eds},
};

}  // namespace

std::span<const Check> device_value_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
