#include "drive/images/image_format.hpp"

#include <optional>

#include "checksum/crc32.hpp"

namespace drive::image_format {
namespace {

constexpr std::array<std::string_view, 8> kTexts{
    "the buffer is too short", "not a file of this kind",
    "another format version",  "ends too early or too late",
    "wrong checksum",          "of a unit with other axes or motors",
    "of other drive objects",  "with a value that the unit cannot take",
};

/// What the values were computed for.
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
                             static_cast<double>(machine.encoder.pulses),
                             static_cast<double>(machine.encoder.fine_bits)};
    all = checksum::crc32(std::as_bytes(std::span{numbers}));
  }
  return all;
}

std::optional<Error> check_beginning(Reader& reader, const Kind& kind) noexcept {
  const auto signature = reader.take<std::array<char, 8>>();
  if (signature != kind.signature) return Error::NotAnImage;
  const auto version = reader.take<std::uint16_t>();
  if (!reader.is_complete()) return Error::Truncated;
  return version != kind.version ? std::optional{Error::OtherVersion} : std::nullopt;
}

}  // namespace

std::string_view text_of(Error error) noexcept {
  return kTexts[static_cast<std::size_t>(error)];
}

std::uint16_t object_count(const DriveUnit& unit) noexcept {
  return static_cast<std::uint16_t>(unit.axes().size() + unit.first_axis() - kControlUnitNumber);
}

void begin(Writer& writer, const Kind& kind, const DriveUnit& unit) noexcept {
  writer.put(kind.signature);
  writer.put(kind.version);
  writer.put(object_count(unit));
  writer.put(identity(unit));
}

void put_object_head(Writer& writer, const DriveObject& object, std::uint16_t count) noexcept {
  writer.put(object.number());
  writer.put(object.kind());
  writer.put(count);
}

std::span<const std::byte> seal(Writer& writer) noexcept {
  writer.put(checksum::crc32(writer.written()));
  return writer.written();
}

tl::expected<Reader, Error> open(std::span<const std::byte> image, const Kind& kind,
                                 const DriveUnit& unit) noexcept {
  Reader beginning{image};
  if (const auto error = check_beginning(beginning, kind)) return tl::unexpected{*error};
  if (image.size() < kHeadSize + kChecksumSize) return tl::unexpected{Error::Truncated};
  const std::span<const std::byte> content = image.first(image.size() - kChecksumSize);
  if (Reader{image.last(kChecksumSize)}.take<std::uint32_t>() != checksum::crc32(content))
    return tl::unexpected{Error::WrongChecksum};
  Reader reader{content};
  static_cast<void>(check_beginning(reader, kind));
  const auto objects = reader.take<std::uint16_t>();
  const auto unit_identity = reader.take<std::uint32_t>();
  if (objects != object_count(unit) || unit_identity != identity(unit)) return tl::unexpected{Error::OtherUnit};
  return reader;
}

}  // namespace drive::image_format
