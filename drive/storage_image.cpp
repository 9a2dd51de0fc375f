#include "drive/storage_image.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>

#include "drive/crc32.hpp"

namespace drive::storage_image {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie");

constexpr std::array<char, 8> kSignature{'a', 'x', 'i', 's', 'd', 'p', 'a', 'r'};
constexpr std::size_t kHeadSize = kSignature.size() + 2 + 2 + 4 + 2;
constexpr std::size_t kObjectHeadSize = 1 + 1 + 2;
constexpr std::size_t kValueSize = 2 + 1 + 1 + 4;
constexpr std::size_t kChecksumSize = 4;

constexpr std::array<std::string_view, 8> kTexts{
    "the buffer is too short for the parameters", "not an image of saved parameters",
    "saved parameters of another format version", "saved parameters that end too early or too late",
    "saved parameters with a wrong checksum",     "saved parameters of a unit with other axes or motors",
    "saved parameters of other drive objects",    "saved parameters with a value that the unit cannot take",
};

/// Puts numbers one after the other into a buffer that is long enough.
class Writer {
 public:
  explicit Writer(std::span<std::byte> buffer) noexcept : buffer_{buffer} {}
  template <class Number>
  void put(Number number) noexcept {
    std::memcpy(&buffer_[at_], &number, sizeof number);
    at_ += sizeof number;
  }
  std::span<std::byte> written() const noexcept { return buffer_.first(at_); }

 private:
  std::span<std::byte> buffer_;
  std::size_t at_ = 0;
};

/// Takes numbers one after the other; behind the end they are 0 and it says so.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) noexcept : left_{bytes} {}
  template <class Number>
  Number take() noexcept {
    Number number{};
    if (left_.size() < sizeof number) {
      complete_ = false;
      left_ = {};
      return number;
    }
    std::memcpy(&number, left_.data(), sizeof number);
    left_ = left_.subspan(sizeof number);
    return number;
  }
  bool is_complete() const noexcept { return complete_; }
  bool is_at_end() const noexcept { return complete_ && left_.empty(); }

 private:
  std::span<const std::byte> left_;
  bool complete_ = true;
};

bool is_saved(const ParameterRow& row) noexcept {
  return row.is_writable() && row.keep != Keep::No;
}

std::size_t value_count(ObjectKind kind) noexcept {
  std::size_t count = 0;
  for (const PlacedRow& placed : parameters_of(kind)) count += is_saved(*placed.row) ? placed.row->count : 0U;
  return count;
}

std::uint16_t object_count(const DriveUnit& unit) noexcept {
  return static_cast<std::uint16_t>(unit.axes().size() + 1);
}

/// Calls @p visit for the drive objects that @p object stands for.
template <class Visit>
void for_each_object(const DriveUnit& unit, std::uint8_t object, Visit visit) {
  const auto last = static_cast<std::uint8_t>(object_count(unit));
  for (std::uint8_t number = kControlUnitNumber; number <= last; ++number)
    if (object == kAllObjects || object == number) visit(*unit.object(number));
}

/// What the parameters were computed for.
std::uint32_t identity(const DriveUnit& unit) noexcept {
  std::uint32_t all = 0;
  for (const Axis& axis : unit.axes()) {
    const motor::MachineData& machine = axis.context().axis.machine;
    const std::array numbers{static_cast<double>(all),
                             static_cast<double>(axis.kind()),
                             machine.rated_speed,
                             machine.maximum_speed,
                             machine.rated_torque,
                             machine.maximum_torque,
                             machine.inertia,
                             static_cast<double>(machine.encoder_pulses),
                             static_cast<double>(machine.encoder_fine_bits)};
    all = crc32(std::as_bytes(std::span{numbers}));
  }
  return all;
}

void put_object(Writer& writer, const DriveObject& object) noexcept {
  writer.put(object.number());
  writer.put(object.kind());
  writer.put(static_cast<std::uint16_t>(value_count(object.kind())));
  for (const PlacedRow& placed : parameters_of(object.kind())) {
    const ParameterRow& row = *placed.row;
    if (!is_saved(row)) continue;
    for (std::size_t i = 0; i < row.count; ++i) {
      const ParameterValue value = encode(row.type, object.read(row.number, i).value_or(0.0));
      writer.put(row.number);
      writer.put(static_cast<std::uint8_t>(i));
      writer.put(value.type);
      writer.put(value.bits);
    }
  }
}

std::optional<Error> check_head(Reader& reader, const DriveUnit& unit) noexcept {
  if (reader.take<std::array<char, kSignature.size()>>() != kSignature) return Error::NotAnImage;
  if (reader.take<std::uint16_t>() != kFormatVersion) return Error::OtherVersion;
  const auto objects = reader.take<std::uint16_t>();
  const auto unit_identity = reader.take<std::uint32_t>();
  if (!reader.is_complete()) return Error::Truncated;
  return objects != object_count(unit) || unit_identity != identity(unit) ? std::optional{Error::OtherUnit}
                                                                          : std::nullopt;
}

/// A value of the image and where it belongs.
struct SavedValue {
  std::uint16_t number = 0;
  std::uint8_t index = 0;
  ParameterValue value{};
};

SavedValue take_value(Reader& reader) noexcept {
  const auto number = reader.take<std::uint16_t>();
  const auto index = reader.take<std::uint8_t>();
  const auto type = reader.take<DataType>();
  const auto bits = reader.take<std::uint32_t>();
  return {number, index, {type, bits}};
}

bool fits(const DriveObject& object, const SavedValue& saved) noexcept {
  const PlacedRow* const placed = find_parameter(object.kind(), saved.number);
  if (placed == nullptr || placed->row->type != saved.value.type) return false;
  return !object.load_error(saved.number, saved.index, decode(saved.value));
}

/// Calls @p take for every value of the drive objects that @p wanted stands for; it is an error if one does not
/// fit, if there is none, or if the image does not end where it should.
template <class Take>
std::optional<Error> for_each_value(Reader reader, DriveUnit& unit, std::uint8_t wanted, Take take) {
  bool found = false;
  for (auto objects = reader.take<std::uint16_t>(); objects > 0; --objects) {
    const auto number = reader.take<std::uint8_t>();
    const auto kind = reader.take<ObjectKind>();
    auto values = reader.take<std::uint16_t>();
    DriveObject* const object = unit.object(number);
    if (!reader.is_complete()) return Error::Truncated;
    if (object == nullptr || object->kind() != kind) return Error::NoSuchObject;
    const bool concerned = wanted == kAllObjects || wanted == number;
    for (; values > 0; --values) {
      const SavedValue saved = take_value(reader);
      if (!reader.is_complete()) return Error::Truncated;
      if (!fits(*object, saved)) return Error::NoSuchParameter;
      if (concerned) take(*object, saved);
    }
    found = found || concerned;
  }
  if (!reader.is_at_end()) return Error::Truncated;
  return found ? std::nullopt : std::optional{Error::NoSuchObject};
}

}  // namespace

std::string_view text_of(Error error) noexcept {
  return kTexts[static_cast<std::size_t>(error)];
}

std::size_t size(const DriveUnit& unit, std::uint8_t object) noexcept {
  std::size_t bytes = kHeadSize + kChecksumSize;
  for_each_object(unit, object,
                  [&](const DriveObject& o) { bytes += kObjectHeadSize + kValueSize * value_count(o.kind()); });
  return bytes;
}

tl::expected<std::span<const std::byte>, Error> save(const DriveUnit& unit, std::span<std::byte> buffer,
                                                     std::uint8_t object) noexcept {
  if (object != kAllObjects && unit.object(object) == nullptr) return tl::unexpected{Error::NoSuchObject};
  if (buffer.size() < size(unit, object)) return tl::unexpected{Error::NoRoom};
  Writer writer{buffer};
  writer.put(kSignature);
  writer.put(kFormatVersion);
  writer.put(object_count(unit));
  writer.put(identity(unit));
  writer.put(object == kAllObjects ? object_count(unit) : std::uint16_t{1});
  for_each_object(unit, object, [&](const DriveObject& o) { put_object(writer, o); });
  writer.put(crc32(writer.written()));
  return writer.written();
}

tl::expected<void, Error> load(DriveUnit& unit, std::span<const std::byte> image, std::uint8_t object) noexcept {
  if (image.size() < kHeadSize + kChecksumSize) {
    const bool begins =
        image.size() >= kSignature.size() && std::memcmp(image.data(), kSignature.data(), kSignature.size()) == 0;
    return tl::unexpected{begins ? Error::Truncated : Error::NotAnImage};
  }
  const std::span<const std::byte> content = image.first(image.size() - kChecksumSize);
  Reader reader{content};
  const std::optional<Error> head = check_head(reader, unit);
  const bool known = head != Error::NotAnImage && head != Error::OtherVersion;
  if (known && Reader{image.last(kChecksumSize)}.take<std::uint32_t>() != crc32(content))
    return tl::unexpected{Error::WrongChecksum};
  if (head) return tl::unexpected{*head};
  if (const auto error = for_each_value(reader, unit, object, [](DriveObject&, const SavedValue&) {}))
    return tl::unexpected{*error};
  for_each_value(reader, unit, object, [](DriveObject& owner, const SavedValue& saved) {
    static_cast<void>(owner.load(saved.number, saved.index, decode(saved.value)));
  });
  return {};
}

}  // namespace drive::storage_image
