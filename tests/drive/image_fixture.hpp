#pragma once

#include <random>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "checksum/crc32.hpp"
#include "tests/drive/test_drive_unit.hpp"

namespace drive {

/// Makes the checksum of a changed image right again.
inline void seal(std::vector<std::byte>& image) {
  const std::uint32_t crc = checksum::crc32(std::span{image}.first(image.size() - 4));
  for (std::size_t i = 0; i < 4; ++i) image[image.size() - 4 + i] = static_cast<std::byte>(crc >> (8 * i));
}

/// The value of a parameter of drive object @p object.
inline double value(const DriveUnit& unit, std::uint8_t object, std::uint16_t number, std::size_t index = 0) {
  return unit.object(object)->read(number, index).value();
}

/// Damages @p image at places found by a seed that a failure shows, in a bit, at its end, and with a checksum that
/// is right again: @p load, which takes a unit and an image, crashes with none and loads none with a wrong
/// checksum.
template <class Load>
void expect_damage_to_be_refused(const std::vector<std::byte>& image, const Load& load) {
  const auto seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random{seed};
  std::uniform_int_distribution<std::size_t> place{0, image.size() - 1};
  std::uniform_int_distribution<int> bit{0, 7};
  DriveUnit fresh{two_axes()};

  for (int round = 0; round < 500; ++round) {
    std::vector<std::byte> damaged = image;
    damaged[place(random)] ^= static_cast<std::byte>(1 << bit(random));
    EXPECT_FALSE(load(fresh, damaged));
    damaged.resize(place(random));
    EXPECT_FALSE(load(fresh, damaged));
    if (damaged.size() < 8) continue;
    seal(damaged);
    static_cast<void>(load(fresh, damaged));
  }
}

}  // namespace drive
