#include "eds/description/description.hpp"

#include <algorithm>
#include <bit>
#include <tuple>

#include "eds/document/document.hpp"

namespace eds {
namespace {

auto key_of(const EntryFacts& entry) {
  return std::tuple{entry.index, entry.sub_index};
}

template <class T>
std::optional<T> optional_of(const Stated<T>& stated) {
  return stated.value;
}

EntryFacts facts_of(std::uint16_t index, const SheetEntry& entry) {
  constexpr std::uint64_t kNoWrite = 1, kNoRead = 2;
  return {.index = index,
          .sub_index = entry.sub_index,
          .name = entry.name,
          .type = entry.type,
          .access = entry.access_or_default(),
          .mappable = entry.mappable.value_or(false),
          .no_write = (entry.flags.value_or(0) & kNoWrite) != 0,
          .no_read = (entry.flags.value_or(0) & kNoRead) != 0,
          .low = optional_of(entry.low),
          .high = optional_of(entry.high),
          .initial = optional_of(entry.effective())};
}

std::uint64_t bits_of(const Integer& integer) noexcept {
  return integer.negative ? std::uint64_t{0} - integer.magnitude : integer.magnitude;
}

std::uint64_t number_of(std::span<const std::uint8_t> bytes) noexcept {
  std::uint64_t number = 0;
  for (std::size_t i = std::min<std::size_t>(bytes.size(), 8); i-- > 0;) number = number << 8U | bytes[i];
  return number;
}

constexpr std::uint8_t kSingle = 32;

}  // namespace

void Description::add(const DataSheet& sheet, std::uint8_t node_id) {
  node_id_ = node_id;
  if (entries_.empty()) {
    const DeviceInfo& info = sheet.device_info;
    device_ = {.vendor = optional_of(info.vendor_number),
               .product = optional_of(info.product_number),
               .revision = optional_of(info.revision_number),
               .name = std::string{info.product_name.value_or({})},
               .granularity = info.granularity.value_or(0),
               .lss = info.lss_supported.value_or(false)};
    for (const auto& [type, allowed] : sheet.dummies)
      if (type < 8 && allowed.value_or(false)) device_.dummy_types |= static_cast<std::uint8_t>(1U << type);
  }
  for (const auto& [index, object] : sheet.objects) {
    objects_.try_emplace(index, object.code());
    for (const SheetEntry& entry : object.entries) add(facts_of(index, entry));
  }
}

void Description::add(EntryFacts entry) {
  if (find(entry.index, entry.sub_index) != nullptr) return;
  objects_.try_emplace(entry.index, ObjectCode::Null);
  entries_.insert(std::ranges::upper_bound(entries_, key_of(entry), {}, key_of), std::move(entry));
}

const EntryFacts* Description::find(std::uint16_t index, std::uint8_t sub_index) const noexcept {
  const auto at = std::ranges::lower_bound(entries_, std::tuple{index, sub_index}, {}, key_of);
  return at != entries_.end() && key_of(*at) == std::tuple{index, sub_index} ? &*at : nullptr;
}

std::span<const EntryFacts> Description::entries_of(std::uint16_t index) const noexcept {
  const auto first = std::ranges::lower_bound(entries_, index, {}, &EntryFacts::index);
  const auto last = std::ranges::upper_bound(entries_, index, {}, &EntryFacts::index);
  return {first, last};
}

ObjectCode Description::code_of(std::uint16_t index) const noexcept {
  const auto at = objects_.find(index);
  return at == objects_.end() ? ObjectCode::Null : at->second;
}

std::vector<std::uint16_t> Description::objects_within(std::uint16_t first, std::uint16_t last) const {
  std::vector<std::uint16_t> found;
  for (auto at = objects_.lower_bound(first); at != objects_.end() && at->first <= last; ++at)
    found.push_back(at->first);
  return found;
}

std::vector<std::uint8_t> little_endian(std::uint64_t number, std::size_t size) {
  std::vector<std::uint8_t> bytes(size);
  for (std::size_t i = 0; i < size && i < 8; ++i) bytes[i] = static_cast<std::uint8_t>(number >> 8U * i);
  return bytes;
}

std::optional<std::vector<std::uint8_t>> encode(const Value& value, const DataTypeRow& type,
                                                std::uint8_t node_id) {
  const std::size_t size = (static_cast<std::size_t>(type.bits) + 7) / 8;
  switch (type.kind) {
    case ValueKind::Signed:
    case ValueKind::Unsigned:
      if (const std::optional<Integer> integer = value.at(node_id)) return little_endian(bits_of(*integer), size);
      return std::nullopt;
    case ValueKind::Real:
      return little_endian(type.bits == kSingle ? std::bit_cast<std::uint32_t>(static_cast<float>(value.real))
                                                : std::bit_cast<std::uint64_t>(value.real),
                           size);
    case ValueKind::Text:
      return std::vector<std::uint8_t>{value.text.begin(), value.text.end()};
    case ValueKind::Bytes:
      break;
  }
  return std::nullopt;
}

Value decode(std::span<const std::uint8_t> bytes, const DataTypeRow& type) {
  Value value{.kind = type.kind};
  const std::uint64_t number = number_of(bytes);
  if (type.kind == ValueKind::Real) {
    value.real = type.bits == kSingle ? double{std::bit_cast<float>(static_cast<std::uint32_t>(number))}
                                      : std::bit_cast<double>(number);
  } else if (type.kind == ValueKind::Text || type.kind == ValueKind::Bytes) {
    value.text = {bytes.begin(), bytes.end()};
  } else {
    const bool negative =
        type.kind == ValueKind::Signed && !bytes.empty() && bytes.size() <= 8 && (bytes.back() & 0x80U) != 0;
    std::uint64_t magnitude = number;
    if (negative) {
      magnitude = std::uint64_t{0} - number;
      if (bytes.size() < 8) magnitude &= (std::uint64_t{1} << 8U * bytes.size()) - 1;
    }
    value.integer = {.magnitude = magnitude, .negative = negative};
  }
  return value;
}

Description read_description(const std::string& text, const std::string& name, std::uint8_t node_id) {
  Findings findings{name};
  const Document document = read_document(text, findings);
  Description description;
  description.add(read_data_sheet(document, findings), node_id);
  return description;
}

}  // namespace eds
