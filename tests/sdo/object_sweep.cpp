#include "tests/sdo/object_sweep.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "tests/eds/rules/eds_reader.hpp"
#include "tests/eds/rules/objects_csv.hpp"

namespace sdo_test {
namespace {

using eds_test::Fact;

constexpr std::uint32_t kNoObject = 0x06020000, kNoSubIndex = 0x06090011, kReadOnly = 0x06010002,
                        kWriteOnly = 0x06010001, kNoData = 0x08000024;
constexpr std::uint32_t kInvalidValue = 0x06090030, kTooHigh = 0x06090031, kTooLow = 0x06090032;
constexpr std::int64_t kNodeId = 5;
constexpr std::uint16_t kModuleList = 0x1027;
constexpr std::uint16_t kDeviceType = 0x1000;
constexpr std::int64_t kSeveralDevices = 0xFFFF0192;  // 1000h, each in its 67FFh
constexpr unsigned kWindowObject = 0x41B6;            // p8630, always shown

/// Size in bytes and sign of the integers.
struct Type {
  unsigned size;
  bool is_signed;
};
const std::map<std::string, Type> kTypes{{"INTEGER8", {1, true}},    {"INTEGER16", {2, true}},
                                         {"INTEGER32", {4, true}},   {"UNSIGNED8", {1, false}},
                                         {"UNSIGNED16", {2, false}}, {"UNSIGNED32", {4, false}}};

/// How far apart neighbouring axes have the objects from `first` on.
struct Stride {
  unsigned first, stride;
};
constexpr std::array kStrides{Stride{0x1000, 1}, Stride{0x1400, 0x40}, Stride{0x5800, 0x80},
                              Stride{0x6000, 0x800}};

/// Where what is known of a device stands, how many entries that are, and what is not the same on axes 2 to 8.
struct DeviceRow {
  const char* facts;
  unsigned of_the_device, of_an_axis;
  std::uint32_t other_cob_id;  ///< of their PDOs, beside bit 31 and bit 30
};
constexpr std::array kDevices{DeviceRow{"objects.csv", 115, 237, 0x6DF},
                              DeviceRow{"cia402-objects.csv", 50, 401, 0}};
const DeviceRow& row_of(SweptDevice device) {
  return kDevices.at(static_cast<std::size_t>(device));
}

unsigned on_axis(unsigned index, unsigned axis) {
  unsigned stride = 0;
  for (const Stride& row : kStrides)
    if (index >= row.first) stride = row.stride;
  return index + stride * (axis - 1);
}

/// One entry that the unit must have.
struct Expected {
  std::uint16_t index;  ///< on its axis
  std::uint8_t sub_index;
  unsigned axis;
  Fact fact;
};

bool is_in(unsigned index, unsigned first, unsigned last) {
  return index >= first && index <= last;
}
bool is_cob_id_of_pdo(const Expected& e) {
  return (is_in(e.index, 0x1400, 0x15FF) || is_in(e.index, 0x1800, 0x19FF)) && e.sub_index == 1;
}
bool is_cob_id_of_server(const Expected& e) {
  return is_in(e.index, 0x1201, 0x1209) && e.sub_index != 0;
}
bool is_mapping(const Expected& e) {
  return (is_in(e.index, 0x1600, 0x17FF) || is_in(e.index, 0x1A00, 0x1BFF)) && e.sub_index != 0;
}

std::vector<Expected> entries_of(unsigned axes, SweptDevice device) {
  std::vector<Expected> entries;
  for (const Fact& fact : eds_test::read_facts(row_of(device).facts)) {
    if (eds_test::is_head(fact) || (fact.at("scope") != "unit" && fact.at("scope") != "axis")) continue;
    const unsigned index = eds_test::index_of(fact);
    const unsigned copies = fact.at("scope") == "axis" ? axes : 1;
    for (unsigned axis = 1; axis <= copies; ++axis)
      entries.push_back({.index = static_cast<std::uint16_t>(on_axis(index, axis)),
                         .sub_index = eds_test::sub_index_of(fact),
                         .axis = axis,
                         .fact = fact});
  }
  return entries;
}

/// The default as the EDS states it for axis 1, on the axis of @p e; nothing for strings.
std::optional<std::int64_t> default_of(const Expected& e, unsigned axes, SweptDevice device) {
  if (e.axis > 1 && is_cob_id_of_pdo(e))
    return (e.index < 0x1800 ? 0x80000000 : 0xC0000000) | row_of(device).other_cob_id;
  if (device == SweptDevice::Cia402 && axes > 1 && e.index == kDeviceType) return kSeveralDevices;
  const auto value = eds_test::number(e.fact.at("default"), kNodeId);
  if (!value || *value == 0 || !is_mapping(e)) return value;
  const auto mapped = static_cast<unsigned>(*value >> 16);
  return (std::int64_t{on_axis(mapped, e.axis)} << 16) + (*value & 0xFFFF);
}

std::uint32_t masked(std::int64_t value, unsigned size) {
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>(value) & (~std::uint64_t{0} >> (64 - 8 * size)));
}

/// What answers a value beyond a limit: COB-IDs are judged as such, and 1003h takes nothing but 0.
std::optional<std::uint32_t> refusal_of(const Expected& e, std::int64_t beyond, std::uint32_t otherwise) {
  const bool is_cob_id = is_cob_id_of_pdo(e) || is_cob_id_of_server(e) || e.index == 0x1005 || e.index == 0x1014;
  if (is_cob_id && (beyond & 0x80000000) != 0) return std::nullopt;
  return is_cob_id || e.index == 0x1003 ? kInvalidValue : otherwise;
}

/// Counts of what was compared.
struct Counts {
  unsigned entries = 0, sizes = 0, defaults = 0, accesses = 0, limits = 0;
};

/// The checks of one entry.
struct Checks {
  /// The error field of the unit has another layout, in which an empty entry reads 0.
  bool is_empty_error(const Expected& e) const {
    return device == SweptDevice::Cia402 && e.index == 0x1003 && e.sub_index != 0;
  }
  void check_value(const Expected& e) {
    const Upload upload = client.upload(e.index, e.sub_index);
    if (e.fact.at("access") == "wo") {
      EXPECT_EQ(upload.abort_code, kWriteOnly);
      ++counts.entries;
      return;
    }
    if (is_empty_error(e)) {
      EXPECT_EQ(upload.abort_code, kNoData);
      ++counts.entries;
      return;
    }
    ASSERT_EQ(upload.abort_code, 0U);
    ++counts.entries;
    const auto type = kTypes.find(e.fact.at("type"));
    const bool is_text = type == kTypes.end();
    ++counts.sizes;
    if (!is_text) {
      EXPECT_EQ(upload.bytes.size(), type->second.size);
    }
    const bool shows_state = eds_test::index_of(e.fact) == 0x6041;  // of an axis that is switched on
    if (e.fact.at("default").empty() || shows_state) return;
    ++counts.defaults;
    if (is_text) {
      EXPECT_EQ(upload.text(), e.fact.at("default"));
    } else {
      EXPECT_EQ(upload.number(), masked(*default_of(e, axes, device), type->second.size));
    }
  }

  /// Writes back what is there: only the access attribute may refuse it as read only.
  void check_access(const Expected& e) {
    const bool is_fixed = e.fact.at("access") == "ro" || e.fact.at("access") == "const";
    const Upload upload = client.upload(e.index, e.sub_index);
    const bool is_text = !kTypes.contains(e.fact.at("type"));
    const unsigned size = is_text ? 4 : kTypes.at(e.fact.at("type")).size;
    const auto value = is_text ? 0 : static_cast<std::uint32_t>(upload.number());
    EXPECT_EQ(client.download(e.index, e.sub_index, value, size) == kReadOnly, is_fixed);
    ++counts.accesses;
  }

  void check_beyond(const Expected& e, std::int64_t beyond, std::uint32_t otherwise) {
    const Type& type = kTypes.at(e.fact.at("type"));
    const std::int64_t values = std::int64_t{1} << (8 * type.size);
    const std::int64_t lowest = type.is_signed ? -values / 2 : 0;
    if (beyond < lowest || beyond >= lowest + values) return;
    const std::uint32_t answer = client.download(e.index, e.sub_index, masked(beyond, type.size), type.size);
    EXPECT_EQ(answer, refusal_of(e, beyond, otherwise).value_or(0)) << beyond;
    ++counts.limits;
  }

  void check_limits(const Expected& e) {
    if (e.fact.at("access") == "ro" || e.fact.at("access") == "const") return;
    const auto low = eds_test::number(e.fact.at("low"), kNodeId),
               high = eds_test::number(e.fact.at("high"), kNodeId);
    if (low) check_beyond(e, *low - 1, kTooLow);
    if (high) check_beyond(e, *high + 1, kTooHigh);
  }

  SdoClient& client;
  unsigned axes;
  SweptDevice device;
  Counts counts{};
};

/// The objects of a unit with @p axes axes and the last sub-index of each.
std::map<unsigned, unsigned> last_sub_indices(unsigned axes, SweptDevice device) {
  std::map<unsigned, unsigned> last_sub;
  if (device == SweptDevice::Unit) last_sub.emplace(kModuleList, axes);
  for (const Expected& e : entries_of(axes, device))
    last_sub[e.index] = std::max<unsigned>(last_sub[e.index], e.sub_index);
  return last_sub;
}

}  // namespace

void ObjectSweep::find_every_entry() {
  const std::vector<Expected> entries = entries_of(axes_, device_);
  const DeviceRow& known = row_of(device_);
  ASSERT_EQ(entries.size(), known.of_the_device + known.of_an_axis * axes_);
  Checks checks{client_, axes_, device_};

  for (const auto check : {&Checks::check_value, &Checks::check_access, &Checks::check_limits})
    for (const Expected& e : entries) {
      SCOPED_TRACE(testing::Message() << std::hex << e.index << ":" << int{e.sub_index});
      (checks.*check)(e);
    }

  const Counts& counts = checks.counts;
  std::cout << axes_ << " axes: " << counts.entries << " entries, " << counts.sizes << " sizes, "
            << counts.defaults << " defaults, " << counts.accesses << " accesses, " << counts.limits
            << " values beyond limits\n";
}

void ObjectSweep::find_nothing_else(bool parameters) {
  const std::map<unsigned, unsigned> last_sub = last_sub_indices(axes_, device_);
  unsigned objects = 0, subs = 0;
  for (unsigned index = 0x1000; index <= 0x9FFF; ++index) {
    const auto known = last_sub.find(index);
    if (known != last_sub.end()) {
      const auto beyond = static_cast<std::uint8_t>(known->second + 1);
      EXPECT_EQ(client_.upload(static_cast<std::uint16_t>(index), beyond).abort_code, kNoSubIndex)
          << std::hex << index;
      ++subs;
    } else if (!(is_in(index, 0x2000, 0x470F) && (parameters || index == kWindowObject))) {
      ASSERT_EQ(client_.upload(static_cast<std::uint16_t>(index)).abort_code, kNoObject) << std::hex << index;
      ++objects;
    }
  }
  std::cout << axes_ << " axes: " << objects << " absent objects, " << subs << " absent sub-indices\n";
}

void ObjectSweep::find_the_modules() {
  EXPECT_EQ(client_.upload(kModuleList, 0).number(), axes_);
  for (unsigned n = 1; n <= axes_; ++n) {
    const auto sub_index = static_cast<std::uint8_t>(n);
    EXPECT_EQ(client_.upload(kModuleList, sub_index).number(), (n - 1) << 8 | 0x0B);
    EXPECT_EQ(client_.upload(kModuleList, sub_index).bytes.size(), 2U);
    EXPECT_EQ(client_.download(kModuleList, sub_index, 0, 2), kReadOnly);
  }
}

}  // namespace sdo_test
