#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "libcanopen/od/abort_code.hpp"
#include "tools/canopen-check/checks/shared/check_table.hpp"
#include "tools/canopen-check/checks/shared/stored_values.hpp"

namespace conformance {
namespace {

constexpr std::uint8_t kAll = 1, kCommunication = 2, kApplication = 3;

constexpr std::uint32_t number_of(canopen::AbortCode code) noexcept {
  return static_cast<std::uint32_t>(code);
}

/// Entries of @p index behind its count that the EDS has, or 1 without an EDS.
std::vector<std::uint8_t> groups_of(Context& context, std::uint16_t index) {
  if (context.eds().empty()) return {kAll};
  std::vector<std::uint8_t> groups;
  for (const eds::EntryFacts& entry : context.eds().entries_of(index))
    if (entry.sub_index != 0) groups.push_back(entry.sub_index);
  return groups;
}

void tells_its_capabilities(Context& context) {
  if (!context.need(object::kStoreParameters, kAll)) return;
  const auto judge = [&](std::uint16_t index, std::uint64_t allowed, const char* bits) {
    for (const std::uint8_t group : groups_of(context, index)) {
      context.step();
      const SdoAnswer answer = context.read(index, group);
      if (answer.done() && (answer.number() & ~allowed) != 0)
        context.fail(index, group, fmt::format("no other bits than {}", bits),
                     fmt::format("{:08X}h", answer.number()));
    }
  };
  judge(object::kStoreParameters, 3, "0 and 1");
  if (context.eds().empty() || context.eds().has(object::kRestoreParameters))
    judge(object::kRestoreParameters, 1, "0");
}

void refuses_other_signatures(Context& context) {
  if (!context.need(object::kStoreParameters, kAll)) return;
  for (const std::uint16_t index : {object::kStoreParameters, object::kRestoreParameters}) {
    if (!context.eds().empty() && !context.eds().has(index)) continue;
    context.step();
    context.expect_abort(
        order(context, index, kAll, 0x12345678),
        {number_of(canopen::AbortCode::CannotTransfer), number_of(canopen::AbortCode::DeviceState)}, index, kAll,
        "another signature");
  }
}

void saves_each_group(Context& context) {
  if (!context.need(object::kStoreParameters, kCommunication)) return;
  for (const std::uint8_t group : groups_of(context, object::kStoreParameters)) {
    if (group == kAll || (context.read(object::kStoreParameters, group).number() & 1U) == 0) continue;
    context.step();
    if (const SdoAnswer answer = order(context, object::kStoreParameters, group, kSave); !answer.done())
      context.fail(object::kStoreParameters, group, "the group can be saved", to_text(answer));
  }
}

/// A finding unless @p value holds @p wanted.
void expect_value(Context& context, const StoredValue& value, const SdoAnswer& wanted, std::uint8_t group,
                  const std::string& after) {
  context.step();
  const SdoAnswer now = context.read(value.index, value.sub_index);
  if (now.data != wanted.data)
    context.fail(object::kStoreParameters, group,
                 fmt::format("{} is {} {}", to_text(Subject{value.index, value.sub_index}),
                             hexadecimal(wanted.data), after),
                 now.done() ? hexadecimal(now.data) : to_text(now));
}

void saves_what_it_works_with(Context& context) {
  if (!context.need(object::kStoreParameters, kAll)) return;
  const auto value = communication_value(context);
  if (!value) return context.skip("no communication parameter is known that can be changed for the test");
  const StorageGuard guard{context, {*value}};
  const SdoAnswer wanted = alter(context, *value);
  context.step();
  if (const SdoAnswer answer = order(context, object::kStoreParameters, kAll, kSave); !answer.done())
    return context.fail(object::kStoreParameters, kAll, "everything can be saved", to_text(answer));
  if (!restart(context)) return;
  expect_value(context, *value, wanted, kAll, "after save and reset");
}

void saves_groups_by_themselves(Context& context) {
  if (!context.need(object::kStoreParameters, kApplication)) return;
  const auto communication = communication_value(context), application = application_value(context);
  if (!communication || !application)
    return context.skip("no parameters are known that can be changed for the test");
  const StorageGuard guard{context, {*communication, *application}};
  const SdoAnswer old = context.read(application->index, application->sub_index);
  const SdoAnswer first = alter(context, *communication);
  (void)alter(context, *application);
  if (const SdoAnswer answer = order(context, object::kStoreParameters, kCommunication, kSave); !answer.done())
    return context.skip("1010h:02 is refused: " + to_text(answer));
  if (!restart(context)) return;
  expect_value(context, *communication, first, kCommunication, "after 1010h:02 and reset");
  expect_value(context, *application, old, kCommunication, "after 1010h:02 and reset, as before");
  const SdoAnswer second = alter(context, *application);
  (void)alter(context, *communication);
  if (const SdoAnswer answer = order(context, object::kStoreParameters, kApplication, kSave); !answer.done())
    return context.skip("1010h:03 is refused: " + to_text(answer));
  if (!restart(context)) return;
  expect_value(context, *application, second, kApplication, "after 1010h:03 and reset");
  expect_value(context, *communication, first, kApplication, "after 1010h:03 and reset, as before");
}

void loads_with_the_next_reset(Context& context) {
  if (!context.need(object::kRestoreParameters, kAll)) return;
  const auto value = communication_value(context);
  if (!value) return context.skip("no communication parameter is known that can be changed for the test");
  const StorageGuard guard{context, {*value}};
  const SdoAnswer changed = alter(context, *value);
  if (const SdoAnswer answer = order(context, object::kStoreParameters, kAll, kSave); !answer.done())
    return context.skip("1010h:01 is refused: " + to_text(answer));
  context.step();
  if (const SdoAnswer answer = order(context, object::kRestoreParameters, kAll, kLoad); !answer.done())
    return context.fail(object::kRestoreParameters, kAll, "factory settings can be loaded", to_text(answer));
  const std::string name = to_text(Subject{value->index, value->sub_index});
  const SdoAnswer before = context.read(value->index, value->sub_index);
  if (before.data != changed.data)
    context.fail(object::kRestoreParameters, kAll,
                 fmt::format("{} is {} until the reset", name, hexadecimal(changed.data)),
                 hexadecimal(before.data));
  if (!restart(context)) return;
  const SdoAnswer after = context.read(value->index, value->sub_index);
  if (after.data == changed.data)
    context.fail(object::kRestoreParameters, kAll,
                 fmt::format("{} has its factory value after load and reset", name),
                 fmt::format("{}, which was saved before", hexadecimal(after.data)));
}

constexpr std::array kChecks{
    Check{.id = "storage.capabilities",
          .name = "1010h and 1011h state no reserved capabilities",
          .clause = "CiA 301 7.5.2.13, 7.5.2.14",
          .group = Group::Storage,
          .mode = Mode::ReadOnly,
          .run = tells_its_capabilities},
    Check{.id = "storage.signature",
          .name = "1010h and 1011h refuse other signatures than save and load",
          .clause = "CiA 301 7.5.2.13, 7.5.2.14",
          .group = Group::Storage,
          .stores = true,
          .run = refuses_other_signatures},
    Check{.id = "storage.group-save",
          .name = "Each group of parameters can be saved at any time",
          .clause = "CiA 301 7.5.2.13",
          .group = Group::Storage,
          .stores = true,
          .run = saves_each_group},
    Check{.id = "storage.save",
          .name = "What was saved comes back with a reset of the node",
          .clause = "CiA 301 7.5.2.13",
          .group = Group::Storage,
          .stores = true,
          .run = saves_what_it_works_with},
    Check{.id = "storage.groups",
          .name = "1010h:02 saves communication parameters only, 1010h:03 those of the application only",
          .clause = "CiA 301 7.5.2.13",
          .group = Group::Storage,
          .stores = true,
          .run = saves_groups_by_themselves},
    Check{.id = "storage.load",
          .name = "Factory settings take effect with the reset after load, not before",
          .clause = "CiA 301 7.5.2.14",
          .group = Group::Storage,
          .stores = true,
          .run = loads_with_the_next_reset},
};

}  // namespace

std::span<const Check> storage_checks() noexcept {
  return kChecks;
}

}  // namespace conformance
