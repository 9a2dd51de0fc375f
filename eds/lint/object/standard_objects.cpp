#include "eds/lint/object/standard_objects.hpp"

#include <algorithm>
#include <initializer_list>

namespace eds {
namespace {

using canopen::Access;
using enum ObjectCode;

constexpr std::uint16_t kU8 = 0x05, kU16 = 0x06, kU32 = 0x07, kText = 0x09, kBytes = 0x0A, kDomain = 0x0F,
                        kU64 = 0x1B;

constexpr std::uint8_t mask(std::initializer_list<Access> accesses) {
  unsigned bits = 0;
  for (const Access access : accesses) bits |= 1U << static_cast<unsigned>(access);
  return static_cast<std::uint8_t>(bits);
}
constexpr std::uint8_t kRead = mask({Access::ReadOnly, Access::Constant});
constexpr std::uint8_t kReadWrite = mask({Access::ReadWrite, Access::ReadWriteRead, Access::ReadWriteWrite});

constexpr AccessRule kFixed{"ro or const", kRead, Severity::Error};    // what a device is, or tells
constexpr AccessRule kCount{"const or ro", kRead, Severity::Warning};  // highest sub-index
constexpr AccessRule kName{"const or ro", kRead, Severity::Warning};   // texts of the manufacturer
constexpr AccessRule kCommand{"rw", kReadWrite, Severity::Error};      // writing is what it is for
constexpr AccessRule kSetting{"rw, or ro or const where it is fixed", kRead | kReadWrite, Severity::Error};
constexpr AccessRule kInput{"wo or rw", kReadWrite | mask({Access::WriteOnly}), Severity::Warning};

// Reserved numbers are CiA 301's: tables 67 and 71 for transmission types, 7.5.2.36 for mappings, and so on.
constexpr ValueRule kHistory{"0 to 254", {{{0, 254}}}, Severity::Warning};
constexpr ValueRule kOverflow{"0, or 2 to 240", {{{0, 0}, {2, 240}}}, Severity::Error};
constexpr ValueRule kErrorBehaviour{"0 to 2, or 128 to 255", {{{0, 2}, {128, 255}}}, Severity::Warning};
constexpr ValueRule kRpdoType{
    "0 to 240, 254 or 255; the others are reserved", {{{0, 240}, {254, 255}}}, Severity::Error};
constexpr ValueRule kTpdoType{
    "0 to 240, or 252 to 255; the others are reserved", {{{0, 240}, {252, 255}}}, Severity::Error};
constexpr ValueRule kSyncStart{"0 to 240", {{{0, 240}}}, Severity::Error};
constexpr ValueRule kMappingCount{"0 to 64, 254 or 255", {{{0, 64}, {254, 255}}}, Severity::Error};

// clang-format off
constexpr std::array kEntries{
    StandardEntry{.first = 0x1000, .last = 0x1000, .type = kU32, .access = kFixed},
    StandardEntry{.first = 0x1001, .last = 0x1001, .type = kU8, .access = kFixed, .mappable = true},
    StandardEntry{.first = 0x1002, .last = 0x1002, .type = kU32, .access = kFixed, .mappable = true},
    StandardEntry{.first = 0x1003, .last = 0x1003, .code = Array, .access = kCommand, .values = kHistory, .standard_default = 0},
    StandardEntry{.first = 0x1003, .last = 0x1003, .code = Array, .first_sub = 1, .last_sub = 254, .type = kU32, .access = kFixed, .needed = true, .mappable = true},
    StandardEntry{.first = 0x1005, .last = 0x1007, .type = kU32, .access = kSetting},
    StandardEntry{.first = 0x1008, .last = 0x100A, .type = kText, .access = kName},
    StandardEntry{.first = 0x100C, .last = 0x100C, .type = kU16, .access = kSetting},
    StandardEntry{.first = 0x100D, .last = 0x100D, .type = kU8, .access = kSetting},
    StandardEntry{.first = 0x1010, .last = 0x1011, .code = Array, .access = kCount},
    StandardEntry{.first = 0x1010, .last = 0x1011, .code = Array, .first_sub = 1, .last_sub = 127, .type = kU32, .access = kCommand, .needed = true},
    StandardEntry{.first = 0x1012, .last = 0x1012, .type = kU32, .access = kSetting},
    StandardEntry{.first = 0x1013, .last = 0x1013, .type = kU32, .access = kSetting, .mappable = true},
    StandardEntry{.first = 0x1014, .last = 0x1014, .type = kU32, .access = kSetting},
    StandardEntry{.first = 0x1015, .last = 0x1015, .type = kU16, .access = kSetting},
    StandardEntry{.first = 0x1016, .last = 0x1016, .code = Array, .access = kCount},
    StandardEntry{.first = 0x1016, .last = 0x1016, .code = Array, .first_sub = 1, .last_sub = 127, .type = kU32, .access = kSetting, .needed = true},
    StandardEntry{.first = 0x1017, .last = 0x1017, .type = kU16, .access = kSetting},
    StandardEntry{.first = 0x1018, .last = 0x1018, .code = Record, .access = kCount},
    StandardEntry{.first = 0x1018, .last = 0x1018, .code = Record, .first_sub = 1, .last_sub = 4, .type = kU32, .access = kFixed},
    StandardEntry{.first = 0x1019, .last = 0x1019, .type = kU8, .access = kSetting, .values = kOverflow},
    StandardEntry{.first = 0x1020, .last = 0x1020, .code = Array, .access = kCount},
    StandardEntry{.first = 0x1020, .last = 0x1020, .code = Array, .first_sub = 1, .last_sub = 2, .type = kU32, .access = kSetting, .needed = true},
    StandardEntry{.first = 0x1021, .last = 0x1021, .type = kDomain, .access = kFixed},
    StandardEntry{.first = 0x1022, .last = 0x1022, .type = kU16, .other_type = kU8, .access = kFixed},
    StandardEntry{.first = 0x1023, .last = 0x1023, .code = Record, .access = kCount},
    StandardEntry{.first = 0x1023, .last = 0x1023, .code = Record, .first_sub = 1, .last_sub = 1, .type = kBytes, .access = kInput, .needed = true},
    StandardEntry{.first = 0x1023, .last = 0x1023, .code = Record, .first_sub = 2, .last_sub = 2, .type = kU8, .access = kFixed, .needed = true},
    StandardEntry{.first = 0x1023, .last = 0x1023, .code = Record, .first_sub = 3, .last_sub = 3, .type = kBytes, .access = kFixed, .needed = true},
    StandardEntry{.first = 0x1024, .last = 0x1024, .type = kU8, .access = kInput},
    StandardEntry{.first = 0x1025, .last = 0x1025, .code = Record, .access = kCount},
    StandardEntry{.first = 0x1025, .last = 0x1025, .code = Record, .first_sub = 1, .last_sub = 1, .type = kBytes, .access = kInput, .needed = true},
    StandardEntry{.first = 0x1025, .last = 0x1025, .code = Record, .first_sub = 2, .last_sub = 2, .type = kU8, .access = kFixed, .needed = true},
    StandardEntry{.first = 0x1025, .last = 0x1025, .code = Record, .first_sub = 3, .last_sub = 3, .type = kBytes, .access = kFixed, .needed = true},
    StandardEntry{.first = 0x1026, .last = 0x1026, .code = Array, .access = kCount},
    StandardEntry{.first = 0x1026, .last = 0x1026, .code = Array, .first_sub = 1, .last_sub = 1, .type = kU8, .access = kInput, .needed = true, .mappable = true},
    StandardEntry{.first = 0x1026, .last = 0x1026, .code = Array, .first_sub = 2, .last_sub = 3, .type = kU8, .access = kFixed, .mappable = true},
    StandardEntry{.first = 0x1027, .last = 0x1027, .code = Array},
    StandardEntry{.first = 0x1027, .last = 0x1027, .code = Array, .first_sub = 1, .last_sub = 254, .type = kU16},
    StandardEntry{.first = 0x1028, .last = 0x1028, .code = Array, .access = kCount},
    StandardEntry{.first = 0x1028, .last = 0x1028, .code = Array, .first_sub = 1, .last_sub = 127, .type = kU32, .access = kSetting, .needed = true},
    StandardEntry{.first = 0x1029, .last = 0x1029, .code = Array, .access = kCount},
    StandardEntry{.first = 0x1029, .last = 0x1029, .code = Array, .first_sub = 1, .last_sub = 254, .type = kU8, .access = kSetting, .values = kErrorBehaviour, .needed = true},

    // SDO servers and clients. The default server is fixed.
    StandardEntry{.first = 0x1200, .last = 0x1200, .code = Record, .access = kCount},
    StandardEntry{.first = 0x1200, .last = 0x1200, .code = Record, .first_sub = 1, .last_sub = 2, .type = kU32, .access = kFixed, .needed = true, .mappable = true},
    StandardEntry{.first = 0x1201, .last = 0x127F, .code = Record, .access = kCount},
    StandardEntry{.first = 0x1201, .last = 0x127F, .code = Record, .first_sub = 1, .last_sub = 2, .type = kU32, .access = kSetting, .needed = true, .mappable = true},
    StandardEntry{.first = 0x1201, .last = 0x127F, .code = Record, .first_sub = 3, .last_sub = 3, .type = kU8, .access = kSetting},
    StandardEntry{.first = 0x1280, .last = 0x12FF, .code = Record, .access = kCount},
    StandardEntry{.first = 0x1280, .last = 0x12FF, .code = Record, .first_sub = 1, .last_sub = 2, .type = kU32, .access = kSetting, .needed = true, .mappable = true},
    StandardEntry{.first = 0x1280, .last = 0x12FF, .code = Record, .first_sub = 3, .last_sub = 3, .type = kU8, .access = kSetting},

    // PDOs: COB-ID, transmission type, inhibit time, compatibility entry, event timer, SYNC start value.
    StandardEntry{.first = 0x1400, .last = 0x15FF, .code = Record, .access = kCount},
    StandardEntry{.first = 0x1400, .last = 0x15FF, .code = Record, .first_sub = 1, .last_sub = 1, .type = kU32, .access = kSetting, .needed = true},
    StandardEntry{.first = 0x1400, .last = 0x15FF, .code = Record, .first_sub = 2, .last_sub = 2, .type = kU8, .access = kSetting, .values = kRpdoType, .needed = true},
    StandardEntry{.first = 0x1400, .last = 0x15FF, .code = Record, .first_sub = 3, .last_sub = 3, .type = kU16, .access = kSetting},
    StandardEntry{.first = 0x1400, .last = 0x15FF, .code = Record, .first_sub = 4, .last_sub = 4, .type = kU8, .access = kSetting},
    StandardEntry{.first = 0x1400, .last = 0x15FF, .code = Record, .first_sub = 5, .last_sub = 5, .type = kU16, .access = kSetting},
    StandardEntry{.first = 0x1400, .last = 0x15FF, .code = Record, .first_sub = 6, .last_sub = 6, .type = kU8, .access = kSetting},
    StandardEntry{.first = 0x1600, .last = 0x17FF, .code = Record, .access = kSetting, .values = kMappingCount},
    StandardEntry{.first = 0x1600, .last = 0x17FF, .code = Record, .first_sub = 1, .last_sub = 64, .type = kU32, .access = kSetting},
    StandardEntry{.first = 0x1800, .last = 0x19FF, .code = Record, .access = kCount},
    StandardEntry{.first = 0x1800, .last = 0x19FF, .code = Record, .first_sub = 1, .last_sub = 1, .type = kU32, .access = kSetting, .needed = true},
    StandardEntry{.first = 0x1800, .last = 0x19FF, .code = Record, .first_sub = 2, .last_sub = 2, .type = kU8, .access = kSetting, .values = kTpdoType, .needed = true},
    StandardEntry{.first = 0x1800, .last = 0x19FF, .code = Record, .first_sub = 3, .last_sub = 3, .type = kU16, .access = kSetting},
    StandardEntry{.first = 0x1800, .last = 0x19FF, .code = Record, .first_sub = 4, .last_sub = 4, .type = kU8, .access = kSetting},
    StandardEntry{.first = 0x1800, .last = 0x19FF, .code = Record, .first_sub = 5, .last_sub = 5, .type = kU16, .access = kSetting},
    StandardEntry{.first = 0x1800, .last = 0x19FF, .code = Record, .first_sub = 6, .last_sub = 6, .type = kU8, .access = kSetting, .values = kSyncStart},
    StandardEntry{.first = 0x1A00, .last = 0x1BFF, .code = Record, .access = kSetting, .values = kMappingCount},
    StandardEntry{.first = 0x1A00, .last = 0x1BFF, .code = Record, .first_sub = 1, .last_sub = 64, .type = kU32, .access = kSetting},

    // Configuration manager (CiA 302-3): DCF, format, concise DCF, EDS, format, command, expected date and time.
    StandardEntry{.first = 0x1F20, .last = 0x1F20, .code = Array, .framework = true},
    StandardEntry{.first = 0x1F20, .last = 0x1F20, .code = Array, .first_sub = 1, .last_sub = 127, .type = kDomain, .framework = true},
    StandardEntry{.first = 0x1F21, .last = 0x1F21, .code = Array, .framework = true},
    StandardEntry{.first = 0x1F21, .last = 0x1F21, .code = Array, .first_sub = 1, .last_sub = 127, .type = kU8, .framework = true},
    StandardEntry{.first = 0x1F22, .last = 0x1F23, .code = Array, .framework = true},
    StandardEntry{.first = 0x1F22, .last = 0x1F23, .code = Array, .first_sub = 1, .last_sub = 127, .type = kDomain, .framework = true},
    StandardEntry{.first = 0x1F24, .last = 0x1F24, .code = Array, .framework = true},
    StandardEntry{.first = 0x1F24, .last = 0x1F24, .code = Array, .first_sub = 1, .last_sub = 127, .type = kU8, .framework = true},
    StandardEntry{.first = 0x1F25, .last = 0x1F25, .code = Array, .framework = true},
    StandardEntry{.first = 0x1F25, .last = 0x1F25, .code = Array, .first_sub = 1, .last_sub = 128, .type = kU32, .framework = true},
    StandardEntry{.first = 0x1F26, .last = 0x1F27, .code = Array, .framework = true},
    StandardEntry{.first = 0x1F26, .last = 0x1F27, .code = Array, .first_sub = 1, .last_sub = 127, .type = kU32, .framework = true},

    // Program download (CiA 302-3): data, control, verification, expected date, time and identification, state.
    StandardEntry{.first = 0x1F50, .last = 0x1F50, .code = Array, .framework = true},
    StandardEntry{.first = 0x1F50, .last = 0x1F50, .code = Array, .first_sub = 1, .last_sub = 254, .type = kDomain, .framework = true},
    StandardEntry{.first = 0x1F51, .last = 0x1F51, .code = Array, .framework = true},
    StandardEntry{.first = 0x1F51, .last = 0x1F51, .code = Array, .first_sub = 1, .last_sub = 254, .type = kU8, .framework = true},
    StandardEntry{.first = 0x1F52, .last = 0x1F52, .code = Array, .framework = true},
    StandardEntry{.first = 0x1F52, .last = 0x1F52, .code = Array, .first_sub = 1, .last_sub = 2, .type = kU32, .framework = true},
    StandardEntry{.first = 0x1F53, .last = 0x1F55, .code = Array, .framework = true},
    StandardEntry{.first = 0x1F53, .last = 0x1F55, .code = Array, .first_sub = 1, .last_sub = 127, .type = kU32, .framework = true},
    StandardEntry{.first = 0x1F56, .last = 0x1F57, .code = Array, .framework = true},
    StandardEntry{.first = 0x1F56, .last = 0x1F57, .code = Array, .first_sub = 1, .last_sub = 254, .type = kU32, .framework = true},

    // NMT master (CiA 302-2): startup, assignment, requests, expected identity of the slaves, boot time.
    StandardEntry{.first = 0x1F80, .last = 0x1F80, .type = kU32, .framework = true},
    StandardEntry{.first = 0x1F81, .last = 0x1F81, .code = Array, .framework = true},
    StandardEntry{.first = 0x1F81, .last = 0x1F81, .code = Array, .first_sub = 1, .last_sub = 127, .type = kU32, .framework = true},
    StandardEntry{.first = 0x1F82, .last = 0x1F83, .code = Array, .framework = true},
    StandardEntry{.first = 0x1F82, .last = 0x1F83, .code = Array, .first_sub = 1, .last_sub = 128, .type = kU8, .framework = true},
    StandardEntry{.first = 0x1F84, .last = 0x1F88, .code = Array, .framework = true},
    StandardEntry{.first = 0x1F84, .last = 0x1F88, .code = Array, .first_sub = 1, .last_sub = 127, .type = kU32, .framework = true},
    StandardEntry{.first = 0x1F89, .last = 0x1F89, .type = kU32, .framework = true},
    StandardEntry{.first = 0x1F90, .last = 0x1F90, .code = Array, .framework = true},
    StandardEntry{.first = 0x1F90, .last = 0x1F90, .code = Array, .first_sub = 1, .last_sub = 6, .type = kU16, .framework = true},

    // Multiplexed PDOs: scanner and dispatching lists.
    StandardEntry{.first = 0x1FA0, .last = 0x1FCF, .code = Array},
    StandardEntry{.first = 0x1FA0, .last = 0x1FCF, .code = Array, .first_sub = 1, .last_sub = 254, .type = kU32, .access = kSetting},
    StandardEntry{.first = 0x1FD0, .last = 0x1FFF, .code = Array},
    StandardEntry{.first = 0x1FD0, .last = 0x1FFF, .code = Array, .first_sub = 1, .last_sub = 254, .type = kU64, .access = kSetting},
};
// clang-format on

static_assert(std::ranges::is_sorted(kEntries, {}, [](const StandardEntry& row) {
  return static_cast<unsigned>(row.first) << 8U | row.first_sub;
}));

}  // namespace

bool ValueRule::allows(std::uint64_t value) const noexcept {
  return words.empty() || std::ranges::any_of(ranges, [value](const Range& range) {
           return value >= range.first && value <= range.last;
         });
}

std::span<const StandardEntry> standard_entries() noexcept {
  return kEntries;
}

std::span<const StandardEntry> standard_entries(std::uint16_t index) noexcept {
  const auto first = std::ranges::lower_bound(kEntries, index, {}, &StandardEntry::last);
  auto end = first;
  while (end != kEntries.end() && end->has_object(index)) ++end;
  return {first, end};
}

const StandardEntry* find_standard_entry(std::uint16_t index, std::uint8_t sub_index) noexcept {
  for (const StandardEntry& row : standard_entries(index))
    if (row.contains(index, sub_index)) return &row;
  return nullptr;
}

}  // namespace eds
