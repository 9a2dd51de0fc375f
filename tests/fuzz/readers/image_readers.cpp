// Images that a unit has left behind: what does not fit changes nothing, and what fits is kept as it is.
#include <cstring>
#include <vector>

#include <fmt/format.h>

#include "checksum/crc32.hpp"
#include "cia402/face.hpp"
#include "device/device.hpp"
#include "drive/images/retained_image.hpp"
#include "drive/images/storage_image.hpp"
#include "tests/cia402/face/test_device.hpp"
#include "tests/device/test_unit.hpp"
#include "tests/fuzz/readers/readers.hpp"

namespace fuzz {
namespace {

using drive::image_format::Error;
using Bytes = std::vector<std::byte>;

/// @p input as an image whose last four bytes are its checksum, unless its last bit says that they are to stay: a
/// fuzzer would not find it.
Bytes sealed(Input input) {
  constexpr std::size_t kSeal = drive::image_format::kChecksumSize;
  Bytes image{input.begin(), input.end()};
  if (image.size() <= kSeal || (image.back() & std::byte{1}) != std::byte{0}) return image;
  const std::uint32_t checksum = checksum::crc32(std::span{image}.first(image.size() - kSeal));
  std::memcpy(&image[image.size() - kSeal], &checksum, kSeal);
  return image;
}

std::string as_string(std::span<const std::byte> bytes) {
  return std::string{text_of(bytes)};
}

struct Images {
  std::size_t (*size)(const drive::DriveUnit&);
  tl::expected<std::span<const std::byte>, Error> (*save)(const drive::DriveUnit&, std::span<std::byte>);
  tl::expected<void, Error> (*load)(drive::DriveUnit&, std::span<const std::byte>);
};

constexpr Images kParameters{[](const drive::DriveUnit& unit) { return drive::storage_image::size(unit); },
                             [](const drive::DriveUnit& unit, std::span<std::byte> buffer) {
                               return drive::storage_image::save(unit, buffer);
                             },
                             [](drive::DriveUnit& unit, std::span<const std::byte> image) {
                               return drive::storage_image::load(unit, image);
                             }};
constexpr Images kRetained{[](const drive::DriveUnit& unit) { return drive::retained_image::size(unit); },
                           [](const drive::DriveUnit& unit, std::span<std::byte> buffer) {
                             return drive::retained_image::save(unit, buffer);
                           },
                           [](drive::DriveUnit& unit, std::span<const std::byte> image) {
                             return drive::retained_image::load(unit, image);
                           }};

Bytes saved(const Images& images, const drive::DriveUnit& unit) {
  Bytes buffer(images.size(unit));
  const auto image = images.save(unit, buffer);
  return image ? Bytes{image->begin(), image->end()} : Bytes{};
}

std::string image_rule(const Images& images, drive::DriveUnit& unit, Input input) {
  const Bytes before = saved(images, unit);
  const auto loaded = images.load(unit, sealed(input));
  const Bytes after = saved(images, unit);
  if (!loaded) return after == before ? "" : fmt::format("{}, and something has changed", text_of(loaded.error()));
  if (!images.load(unit, after)) return "what was loaded and saved is not loaded";
  return saved(images, unit) == after ? "" : "what was loaded and saved is another one";
}

}  // namespace

std::string read_parameters(Input input) {
  static device::TestUnit unit;
  return image_rule(kParameters, unit.device.runner().unit(), input);
}

std::string read_retained(Input input) {
  device::TestUnit unit;
  const auto loaded = kRetained.load(unit.device.runner().unit(), sealed(input));
  return loaded || !text_of(loaded.error()).empty() ? "" : "a refusal without a word why";
}

std::string read_objects(Input input) {
  static cia402::TestDevice device;
  const auto loaded = device.device.load_parameters(sealed(input));
  return loaded || !text_of(loaded.error()).empty() ? "" : "a refusal without a word why";
}

std::vector<std::string> made_parameters() {
  const device::TestUnit unit;
  return {as_string(saved(kParameters, unit.device.unit()))};
}

std::vector<std::string> made_retained() {
  device::TestUnit unit;
  std::vector<std::string> images{as_string(saved(kRetained, unit.device.unit()))};
  unit.start();
  unit.device.raise(1, 7900, 0, unit.now);
  images.push_back(as_string(saved(kRetained, unit.device.unit())));
  return images;
}

std::vector<std::string> made_objects() {
  cia402::TestDevice device;
  device.start();
  EXPECT_EQ(device.write(0x1010, 1, 0x65766173), 0U);
  return {as_string(device.listener.image)};
}

}  // namespace fuzz
