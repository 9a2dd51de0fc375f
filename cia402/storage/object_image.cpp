#include "cia402/storage/object_image.hpp"

#include <algorithm>
#include <array>

#include "cia402/objects/object_index.hpp"
#include "libcanopen/base/little_endian.hpp"
#include "libcanopen/base/node_id.hpp"
#include "libcanopen/base/object_index.hpp"

namespace cia402 {
namespace {

using drive::image_format::Error;

constexpr drive::image_format::Kind kKind{{'a', 'x', 'i', 's', 'd', '4', '0', '2'}, 1};
constexpr unsigned kNodeIdSet = 0x100;
constexpr std::size_t kValueSize = 2 + 1 + 8;
constexpr std::uint16_t kFirstProfileObject = 0x6000;

/// Objects of the first axis that are set-points and commands of the moment.
constexpr std::array<std::uint16_t, 13> kMomentary{object::kControlword,
                                                   object::kVlTargetVelocity,
                                                   object::kModesOfOperation,
                                                   object::kTargetTorque,
                                                   object::kTargetPosition,
                                                   object::kPositionOffset,
                                                   object::kVelocityOffset,
                                                   object::kTorqueOffset,
                                                   object::kTouchProbeFunction,
                                                   object::kInterpolationData,
                                                   object::kInterpolationDataConfiguration,
                                                   object::kDigitalOutputs,
                                                   object::kTargetVelocity};
constexpr std::array<std::uint16_t, 3> kCommands{canopen::object::kErrorField, canopen::object::kStoreParameters,
                                                 canopen::object::kRestoreParameters};

/// The node-ID that @p number stands for, which is that of an image; std::nullopt if none was set.
tl::expected<std::optional<std::uint8_t>, Error> node_id_in(std::uint16_t number) noexcept {
  if (number == 0) return std::nullopt;
  const auto node_id = static_cast<std::uint8_t>(number);
  const bool is_one = canopen::is_node_id(node_id) || node_id == canopen::kNoNodeId;
  if (number != (kNodeIdSet | node_id) || !is_one) return tl::unexpected{Error::NoSuchParameter};
  return node_id;
}

bool is_of(const canopen::Entry& entry, ObjectGroup group) noexcept {
  if (group == ObjectGroup::All) return true;
  return (entry.index >= kFirstProfileObject) == (group == ObjectGroup::Application);
}

}  // namespace

bool ObjectImage::is_kept(const canopen::Entry& entry) noexcept {
  if (!entry.writable || !entry.readable || entry.size == 0 || entry.is_command) return false;
  if (entry.index < kFirstProfileObject) return std::ranges::find(kCommands, entry.index) == kCommands.end();
  return std::ranges::find(kMomentary, object::index_on_first_axis(entry.index)) == kMomentary.end();
}

ObjectImage::ObjectImage(canopen::Dictionary& dictionary, const drive::DriveUnit& unit)
    : dictionary_{dictionary}, unit_{unit} {
  for (const canopen::Entry& entry : dictionary.entries())
    if (is_kept(entry)) values_.push_back({&entry, dictionary.initial(entry), 0});
  image_.resize(drive::image_format::kHeadSize + sizeof(std::uint16_t) + sizeof(std::uint32_t) +
                values_.size() * kValueSize + drive::image_format::kChecksumSize);
}

std::span<const std::byte> ObjectImage::make(ObjectGroup group) noexcept {
  for (Value& value : values_)
    value.next = is_of(*value.entry, group) ? dictionary_.stored(*value.entry) : value.saved;
  return write();
}

std::span<const std::byte> ObjectImage::make_saved() noexcept {
  for (Value& value : values_) value.next = value.saved;
  return write();
}

std::span<const std::byte> ObjectImage::write() noexcept {
  drive::image_format::Writer writer{image_};
  drive::image_format::begin(writer, kKind, unit_);
  writer.put(static_cast<std::uint16_t>(node_id_ ? kNodeIdSet | *node_id_ : 0U));
  writer.put(static_cast<std::uint32_t>(values_.size()));
  for (const Value& value : values_) {
    writer.put(value.entry->index);
    writer.put(value.entry->sub_index);
    writer.put(value.next);
  }
  return drive::image_format::seal(writer);
}

void ObjectImage::keep() noexcept {
  for (Value& value : values_) value.saved = value.next;
  saved_ = true;
}

tl::expected<void, Error> ObjectImage::adopt(std::span<const std::byte> image) noexcept {
  auto reader = drive::image_format::open(image, kKind, unit_);
  if (!reader) return tl::unexpected{reader.error()};
  if (auto read_values = read(*reader); !read_values) return read_values;
  keep();
  return {};
}

bool ObjectImage::can_have(const canopen::Entry& entry, std::int64_t value) const noexcept {
  if (value == dictionary_.initial(entry)) return true;
  const std::uint64_t bits = static_cast<std::uint64_t>(value) & canopen::byte_mask(entry.size);
  const std::int64_t kept =
      entry.is_signed ? canopen::sign_extend(bits, entry.size) : static_cast<std::int64_t>(bits);
  return kept == value && canopen::Dictionary::check(entry, value).has_value();
}

/// Into `next` of the values.
tl::expected<void, Error> ObjectImage::read(drive::image_format::Reader& reader) noexcept {
  const auto node_id = node_id_in(reader.take<std::uint16_t>());
  if (!node_id) return tl::unexpected{node_id.error()};
  if (reader.take<std::uint32_t>() != values_.size()) return tl::unexpected{Error::NoSuchParameter};
  for (Value& value : values_) {
    const auto index = reader.take<std::uint16_t>();
    const auto sub_index = reader.take<std::uint8_t>();
    value.next = reader.take<std::int64_t>();
    if (index != value.entry->index || sub_index != value.entry->sub_index || !can_have(*value.entry, value.next))
      return tl::unexpected{Error::NoSuchParameter};
  }
  if (!reader.is_at_end()) return tl::unexpected{Error::Truncated};
  node_id_ = *node_id;
  return {};
}

void ObjectImage::forget(ObjectGroup group) noexcept {
  for (Value& value : values_)
    if (is_of(*value.entry, group)) value.saved = dictionary_.initial(*value.entry);
}

void ObjectImage::restore(ObjectGroup group) noexcept {
  for (const Value& value : values_)
    if (is_of(*value.entry, group)) dictionary_.set(*value.entry, value.saved);
}

}  // namespace cia402
