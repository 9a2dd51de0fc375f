#include "audit/network/pdo_record.hpp"

#include <fmt/format.h>

namespace audit {

namespace {

namespace object = canopen::object;

constexpr std::uint16_t kRecords = 0x200;  // of each of the four kinds
constexpr std::uint64_t kMostMapped = 64;

}  // namespace

std::optional<PdoRecord> pdo_at(std::uint16_t index) noexcept {
  if (index < object::kRpdoParameter || index >= object::kPdosEnd) return std::nullopt;
  const bool is_receive = index < object::kTpdoParameter;
  return PdoRecord{.is_receive = is_receive, .number = static_cast<std::uint16_t>(index % kRecords + 1)};
}

std::string name_of(const PdoRecord& record) {
  return fmt::format("{} {}", record.is_receive ? "RPDO" : "TPDO", record.number);
}

std::optional<bool> is_valid(const Node& node, const PdoRecord& record) {
  const auto cob_id = node.value(record.communication(), kCobIdSub);
  if (!cob_id) return std::nullopt;
  return (*cob_id & canopen::cob_id::kInvalid) == 0;
}

unsigned bytes_of(const std::vector<MappedObject>& objects) noexcept {
  return objects.empty() ? 0 : (objects.back().first_bit + objects.back().bits + 7) / 8;
}

std::optional<std::vector<MappedObject>> mapping_of(const Node& node, const PdoRecord& record) {
  const auto count = node.value(record.mapping(), 0);
  if (!count || *count > kMostMapped) return std::nullopt;
  std::vector<MappedObject> objects;
  unsigned bit = 0;
  for (std::uint64_t i = 1; i <= *count; ++i) {
    const auto entry = node.value(record.mapping(), static_cast<std::uint8_t>(i));
    if (!entry) return std::nullopt;
    const auto bits = static_cast<unsigned>(*entry & 0xFF);
    objects.push_back({.at = {.index = static_cast<std::uint16_t>(*entry >> 16),
                              .sub_index = static_cast<std::uint8_t>(*entry >> 8)},
                       .first_bit = bit,
                       .bits = bits});
    bit += bits;
  }
  return objects;
}

}  // namespace audit
