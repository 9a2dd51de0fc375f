#include "audit/drive/drive_values.hpp"

#include <algorithm>

#include "audit/base/transfer.hpp"
#include "audit/drive/drive_objects.hpp"
#include "libcanopen/base/little_endian.hpp"

namespace audit {

namespace {

constexpr std::uint16_t kFirst = 0x6000, kLast = 0x9FFF, kOfAnAxis = 0x800;
constexpr unsigned kFrameBits = 64;
constexpr unsigned kMostBits = 32;  // of an object that is judged

bool is_of_axis(std::uint16_t index) noexcept {
  return index >= kFirst && index <= kLast;
}

std::uint8_t axis_of(std::uint16_t index) noexcept {
  return static_cast<std::uint8_t>((index - kFirst) / kOfAnAxis);
}

std::uint16_t object_of(std::uint16_t index) noexcept {
  return static_cast<std::uint16_t>(kFirst + (index - kFirst) % kOfAnAxis);
}

/// The lowest @p bits of @p word as @p object means them.
std::int64_t value_of(std::uint64_t word, unsigned bits, std::uint16_t object) noexcept {
  if (bits == 0 || bits >= kFrameBits) return static_cast<std::int64_t>(word);
  const std::uint64_t low = word & ((std::uint64_t{1} << bits) - 1);
  const bool is_negative = drive_object::is_signed(object) && (low >> (bits - 1) & 1) != 0;
  return static_cast<std::int64_t>(is_negative ? low | ~((std::uint64_t{1} << bits) - 1) : low);
}

}  // namespace

std::span<const DriveValue> DriveValues::in_pdo(const Passage& passage, const Network& network) {
  found_.clear();
  const bool is_receive = passage.meaning.role == meaning::Role::Rpdo;
  const Node& node = network.node(passage.meaning.node);
  const Known& pdo = known(node, {.is_receive = is_receive, .number = passage.meaning.number});
  if (pdo.objects.empty()) return found_;
  const auto word = canopen::load<std::uint64_t>(passage.frame().data.data());
  for (const MappedObject& mapped : pdo.objects) {
    if (mapped.first_bit + mapped.bits > 8U * passage.frame().length) break;
    const std::uint16_t object = object_of(mapped.at.index);
    found_.push_back({.node = node.id,
                      .axis = axis_of(mapped.at.index),
                      .object = object,
                      .sub_index = mapped.at.sub_index,
                      .value = value_of(word >> mapped.first_bit, mapped.bits, object),
                      .way = is_receive ? DriveValue::Way::Rpdo : DriveValue::Way::Tpdo,
                      .heard = passage.heard});
  }
  return found_;
}

std::span<const DriveValue> DriveValues::in_transfer(const Transfer& transfer) {
  found_.clear();
  if (!is_of_axis(transfer.at.index) || transfer.bytes == 0 || 8 * transfer.bytes > kMostBits) return found_;
  const std::uint16_t object = object_of(transfer.at.index);
  if (!drive_object::is_judged(object)) return found_;
  found_.push_back({.node = transfer.channel.node,
                    .axis = axis_of(transfer.at.index),
                    .object = object,
                    .sub_index = transfer.at.sub_index,
                    .value = value_of(transfer.value, static_cast<unsigned>(8 * transfer.bytes), object),
                    .way = transfer.is_write ? DriveValue::Way::SdoWrite : DriveValue::Way::SdoRead,
                    .heard = transfer.is_write ? transfer.request : transfer.last});
  return found_;
}

const DriveValues::Known& DriveValues::known(const Node& node, const PdoRecord& record) {
  Known& pdo = pdos_[{node.id, record}];
  if (pdo.changes == node.changes + 1) return pdo;
  pdo.changes = node.changes + 1;
  pdo.objects.clear();
  const auto objects = mapping_of(node, record);
  if (!objects) return pdo;
  for (const MappedObject& mapped : *objects)
    if (is_of_axis(mapped.at.index) && drive_object::is_judged(object_of(mapped.at.index)) && mapped.bits != 0 &&
        mapped.bits <= kMostBits && mapped.first_bit + mapped.bits <= kFrameBits)
      pdo.objects.push_back(mapped);
  // The set-points of a frame are there when its command is carried out.
  std::stable_partition(pdo.objects.begin(), pdo.objects.end(), [](const MappedObject& mapped) {
    return object_of(mapped.at.index) != drive_object::kControlword;
  });
  return pdo;
}

}  // namespace audit
