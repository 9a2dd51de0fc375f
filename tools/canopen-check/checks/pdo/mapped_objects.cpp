#include <algorithm>

#include <fmt/format.h>

#include "tools/canopen-check/checks/pdo/pdo_tools.hpp"
#include "tools/canopen-check/core/run/protected_entries.hpp"
#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

constexpr std::uint16_t kManufacturer = 0x2000, kEndOfManufacturer = 0x6000;

bool mappable_size(const eds::EntryFacts& entry) noexcept {
  return entry.mappable && entry.numeric() &&
         (entry.type->bits == 8 || entry.type->bits == 16 || entry.type->bits == 32);
}

MappedObject object_of(const eds::EntryFacts& entry) {
  return {entry.index, entry.sub_index, static_cast<std::uint8_t>(entry.type->bits)};
}

/// Objects of the manufacturer first: those of a profile tell what moves.
std::vector<MappedObject> mapped(std::vector<const eds::EntryFacts*> entries) {
  std::stable_partition(entries.begin(), entries.end(), [](const eds::EntryFacts* entry) {
    return entry->index >= kManufacturer && entry->index < kEndOfManufacturer;
  });
  std::vector<MappedObject> objects;
  objects.reserve(entries.size());
  for (const eds::EntryFacts* const entry : entries) objects.push_back(object_of(*entry));
  return objects;
}

std::int64_t signed_of(const eds::Value& value, std::int64_t otherwise, std::uint8_t node_id) {
  const auto integer = value.at(node_id);
  if (!integer || integer->magnitude > 0x7FFF'FFFF'FFFF'FFFF) return otherwise;
  const auto magnitude = static_cast<std::int64_t>(integer->magnitude);
  return integer->negative ? -magnitude : magnitude;
}

}  // namespace

MappedObject MappedObject::of(std::uint32_t entry) noexcept {
  return {static_cast<std::uint16_t>(entry >> 16U), static_cast<std::uint8_t>(entry >> 8U),
          static_cast<std::uint8_t>(entry)};
}

std::uint32_t MappedObject::entry() const noexcept {
  return std::uint32_t{index} << 16U | std::uint32_t{sub_index} << 8U | bits;
}

std::vector<MappedObject> transmittable(Context& context) {
  std::vector<const eds::EntryFacts*> entries;
  for (const eds::EntryFacts& entry : context.eds().entries())
    if (mappable_size(entry) && entry.readable() && entry.access != canopen::Access::ReadWriteWrite)
      entries.push_back(&entry);
  return mapped(std::move(entries));
}

std::vector<MappedObject> receivable(Context& context) {
  std::vector<const eds::EntryFacts*> entries;
  for (const eds::EntryFacts& entry : context.eds().entries()) {
    const bool takes = mappable_size(entry) && entry.writable() && entry.readable() &&
                       entry.access != canopen::Access::ReadWriteRead;
    // ObjFlags is about downloads of a configuration; an RPDO is none.
    eds::EntryFacts by_rpdo = entry;
    by_rpdo.no_write = false;
    if (takes && write_refusal(by_rpdo, context.settings()) == nullptr) entries.push_back(&entry);
  }
  std::vector<MappedObject> objects = mapped(std::move(entries));
  // Even with leave to move a drive, what its profile defines is no place for test values.
  std::erase_if(objects, [](const MappedObject& object) { return object.index >= kEndOfManufacturer; });
  return objects;
}

std::vector<MappedObject> calm_mapping(Context& context, const Pdo& pdo) {
  const eds::EntryFacts* const count = context.eds().find(pdo.mapping(), 0);
  const std::vector<MappedObject> objects = transmittable(context);
  if (count == nullptr || !count->writable() || objects.empty()) return {};
  return {objects.front()};
}

std::optional<MappedObject> changeable(Context& context) {
  for (const MappedObject& object : transmittable(context)) {
    const eds::EntryFacts* const entry = context.eds().find(object.index, object.sub_index);
    if (entry->writable() && write_refusal(*entry, context.settings()) == nullptr) return object;
  }
  context.skip(context.eds().empty() ? "without an EDS no object is known that makes an event"
                                     : "the EDS has no object that an SDO can write and a TPDO can carry");
  return std::nullopt;
}

std::uint64_t other_value(Context& context, const MappedObject& object) {
  const std::uint64_t mask = (std::uint64_t{1} << object.bits) - 1;
  const std::uint64_t now = context.read(object.index, object.sub_index).number();
  const eds::EntryFacts* const facts = context.eds().find(object.index, object.sub_index);
  const std::uint64_t next = (now + 1) & mask;
  if (facts == nullptr || !facts->high) return next;
  const std::uint8_t node_id = context.session().node_id();
  const auto high = signed_of(*facts->high, 0, node_id);
  const auto present = signed_of(decode(eds::little_endian(now, object.bytes()), *facts->type), 0, node_id);
  return present < high ? next : (now - 1) & mask;
}

std::uint64_t change(Context& context, const MappedObject& object) {
  const std::uint64_t value = other_value(context, object);
  (void)context.write(object.index, object.sub_index, eds::little_endian(value, object.bytes()));
  return value;
}

std::uint64_t number_in(const canopen::Frame& frame) noexcept {
  std::uint64_t number = 0;
  for (std::size_t i = std::min<std::size_t>(frame.length, 8); i-- > 0;) number = number << 8U | frame.data[i];
  return number;
}

std::vector<TimedFrame> frames_since(Context& context, std::size_t mark, std::uint32_t identifier) {
  std::vector<TimedFrame> frames;
  for (const TimedFrame& each : context.session().since(mark))
    if (!each.sent && under(identifier)(each.frame)) frames.push_back(each);
  return frames;
}

SyncSource::SyncSource(Context& context) : session_{&context.session()} {
  const auto has = [&](std::uint16_t index) { return context.eds().empty() || context.eds().has(index); };
  if (has(object::kCobIdSync))
    if (const SdoAnswer cob_id = context.read(object::kCobIdSync); cob_id.done())
      identifier_ = static_cast<std::uint32_t>(cob_id.number()) & 0x7FFU;
  if (has(object::kSyncOverflow))
    if (const SdoAnswer overflow = context.read(object::kSyncOverflow); overflow.done())
      overflow_ = static_cast<std::uint8_t>(overflow.number());
}

void SyncSource::send() {
  canopen::Frame frame{.id = identifier_};
  if (overflow_ != 0) {
    counter_ = static_cast<std::uint8_t>(counter_ % overflow_ + 1);
    frame.length = 1;
    frame.data[0] = counter_;
  }
  session_->send(frame);
}

std::optional<TimedFrame> SyncSource::next(std::uint32_t identifier, canopen::Duration patience) {
  session_->drain();
  send();
  return session_->wait_for(under(identifier), patience);
}

std::vector<TimedFrame> SyncSource::run(int count, canopen::Duration period, std::uint32_t identifier) {
  std::vector<TimedFrame> frames;
  for (int i = 0; i < count; ++i) {
    send();
    for (const TimedFrame& frame : session_->collect(under(identifier), period)) frames.push_back(frame);
  }
  return frames;
}

std::vector<std::size_t> SyncSource::count_each(int count, canopen::Duration period, std::uint32_t identifier,
                                                canopen::Duration patience) {
  std::vector<std::size_t> counts;
  for (int i = 0; i < count; ++i) {
    send();
    const std::size_t first = session_->wait_for(under(identifier), patience) ? 1 : 0;
    counts.push_back(first + session_->collect(under(identifier), period).size());
  }
  return counts;
}

}  // namespace conformance
