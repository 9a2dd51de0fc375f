#include "drive/images/storage_image.hpp"

#include <optional>

#include "drive/images/storage_blocks.hpp"

namespace drive::storage_image {
namespace {

using image_format::Reader;
using image_format::Writer;

constexpr image_format::Kind kKind{{'a', 'x', 'i', 's', 'd', 'p', 'a', 'r'}, kFormatVersion};
constexpr std::size_t kFixedSize = image_format::kHeadSize + 2 + image_format::kChecksumSize;

std::uint16_t value_count(ObjectKind kind) noexcept {
  std::size_t count = 0;
  for (const PlacedRow& placed : parameters_of(kind)) count += is_saved(*placed.row) ? placed.row->count : 0U;
  return static_cast<std::uint16_t>(count);
}

bool concerns(std::uint8_t selected, std::uint8_t number) noexcept {
  return selected == kAllObjects || selected == number;
}

void put_value(Writer& writer, const SavedValue& saved) noexcept {
  writer.put(saved.number);
  writer.put(saved.index);
  writer.put(saved.value.type);
  writer.put(saved.value.bits);
}

/// What a function module has that is not in force is saved as it is kept, and all where @p kept.
SavedValue present_value(const DriveObject& object, const ParameterRow& row, std::size_t index,
                         bool kept) noexcept {
  const auto shown = object.read(row.number, index);
  const double value = shown && !kept ? *shown : object.kept_value(row.number, index).value_or(0.0);
  return {row.number, static_cast<std::uint8_t>(index), encode(row.type, value)};
}

void put_present(Writer& writer, const DriveObject& object, bool kept) noexcept {
  image_format::put_object_head(writer, object, value_count(object.kind()));
  for (const PlacedRow& placed : parameters_of(object.kind())) {
    if (!is_saved(*placed.row)) continue;
    for (std::size_t i = 0; i < placed.row->count; ++i)
      put_value(writer, present_value(object, *placed.row, i, kept));
  }
}

/// The values of @p block, those that the rows of @p selection choose as they are at present.
void put_updated(Writer& writer, const DriveObject& object, const Block& block,
                 const Selection& selection) noexcept {
  image_format::put_object_head(writer, object, block.count);
  Reader reader = block.reader();
  for (std::uint16_t i = 0; i < block.count; ++i) {
    const SavedValue saved = take_value(reader);
    const PlacedRow* const placed = find_parameter(object.kind(), saved.number);
    const bool chosen = placed != nullptr && selection.rows(*placed->row);
    put_value(writer, chosen ? present_value(object, *placed->row, saved.index, selection.kept) : saved);
  }
}

bool fits(const DriveObject& object, const SavedValue& saved) noexcept {
  const PlacedRow* const placed = find_parameter(object.kind(), saved.number);
  if (placed == nullptr || placed->row->type != saved.value.type) return false;
  const bool was_saved = placed->row->is_writable() && !is_saved(*placed->row);
  if (was_saved) return true;  // by an earlier version; load() passes over it
  return !object.load_error(saved.number, saved.index, decode(saved.value));
}

std::optional<Error> block_error(const DriveUnit& unit, const Block& block) noexcept {
  const DriveObject* const object = unit.object(block.number);
  if (object == nullptr || object->kind() != block.kind) return Error::NoSuchObject;
  Reader reader = block.reader();
  for (std::uint16_t i = 0; i < block.count; ++i)
    if (!fits(*object, take_value(reader))) return Error::NoSuchParameter;
  return std::nullopt;
}

/// Why the content that @p reader gives cannot be taken for @p wanted, if it cannot.
std::optional<Error> content_error(Reader reader, const DriveUnit& unit, std::uint8_t wanted) noexcept {
  bool found = false;
  for (auto objects = reader.take<std::uint16_t>(); objects > 0; --objects) {
    const Block block = take_block(reader);
    if (!reader.is_complete()) return Error::Truncated;
    if (const auto error = block_error(unit, block)) return error;
    found = found || concerns(wanted, block.number);
  }
  if (!reader.is_at_end()) return Error::Truncated;
  return found ? std::nullopt : std::optional{Error::NoSuchObject};
}

void load_block(DriveObject& object, const Block& block, RowFilter rows) noexcept {
  Reader reader = block.reader();
  for (std::uint16_t i = 0; i < block.count; ++i) {
    const SavedValue saved = take_value(reader);
    if (rows(*find_parameter(object.kind(), saved.number)->row))
      static_cast<void>(object.load(saved.number, saved.index, decode(saved.value)));
  }
}

/// Whether every parameter is meant that can be saved.
bool is_whole(RowFilter rows) noexcept {
  return rows == RowFilter{is_saved};
}

}  // namespace

std::size_t size(const DriveUnit& unit, std::uint8_t object) noexcept {
  std::size_t bytes = kFixedSize;
  unit.for_each_object([&](const DriveObject& o) {
    if (concerns(object, o.number())) bytes += image_format::kObjectHeadSize + kValueSize * value_count(o.kind());
  });
  return bytes;
}

tl::expected<std::span<const std::byte>, Error> save(const DriveUnit& unit, std::span<std::byte> buffer,
                                                     std::uint8_t object) noexcept {
  return update(unit, {}, buffer, {.object = object});
}

tl::expected<std::span<const std::byte>, Error> update(const DriveUnit& unit, std::span<const std::byte> image,
                                                       std::span<std::byte> buffer,
                                                       const Selection& selection) noexcept {
  if (selection.object != kAllObjects && unit.object(selection.object) == nullptr)
    return tl::unexpected{Error::NoSuchObject};
  const auto content = image_format::open(image, kKind, unit);
  if (!image.empty() && !content) return tl::unexpected{content.error()};
  const Blocks former = content ? Blocks{*content} : Blocks{};
  const auto is_chosen = [&](const DriveObject& o) { return concerns(selection.object, o.number()); };
  const auto is_added = [&](const DriveObject& o) {
    return is_chosen(o) && is_whole(selection.rows) && !former.has(o.number());
  };
  std::size_t bytes = kFixedSize;
  std::uint16_t objects = 0;
  unit.for_each_object([&](const DriveObject& o) {
    if (!former.has(o.number()) && !is_added(o)) return;
    bytes += image_format::kObjectHeadSize +
             kValueSize * (is_added(o) ? value_count(o.kind()) : former.of(o.number()).count);
    ++objects;
  });
  if (buffer.size() < bytes) return tl::unexpected{Error::NoRoom};

  Writer writer{buffer};
  image_format::begin(writer, kKind, unit);
  writer.put(objects);
  unit.for_each_object([&](const DriveObject& o) {
    if (is_added(o)) return put_present(writer, o, selection.kept);
    constexpr RowFilter kNone = [](const ParameterRow&) noexcept { return false; };
    if (former.has(o.number()))
      put_updated(writer, o, former.of(o.number()), is_chosen(o) ? selection : Selection{.rows = kNone});
  });
  return image_format::seal(writer);
}

bool has(const DriveUnit& unit, std::span<const std::byte> image, std::uint8_t object) noexcept {
  const auto content = image_format::open(image, kKind, unit);
  return content && unit.object(object) != nullptr && Blocks{*content}.has(object);
}

bool is_complete(const DriveUnit& unit, std::span<const std::byte> image) noexcept {
  auto content = image_format::open(image, kKind, unit);
  return content && content->take<std::uint16_t>() == image_format::object_count(unit);
}

tl::expected<void, Error> load(DriveUnit& unit, std::span<const std::byte> image,
                               const Selection& selection) noexcept {
  auto content = image_format::open(image, kKind, unit);
  if (!content) return tl::unexpected{content.error()};
  if (const auto error = content_error(*content, unit, selection.object)) return tl::unexpected{*error};
  for (auto objects = content->take<std::uint16_t>(); objects > 0; --objects) {
    const Block block = take_block(*content);
    if (concerns(selection.object, block.number)) load_block(*unit.object(block.number), block, selection.rows);
  }
  return {};
}

}  // namespace drive::storage_image
