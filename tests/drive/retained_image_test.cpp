#include "drive/retained_image.hpp"

#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "drive/crc32.hpp"

namespace drive {
namespace {

using retained_image::Error;

constexpr std::uint8_t kX = 2;
constexpr std::uint8_t kY = 3;

UnitConfiguration two_axes() {
  return {.axes = {{}, {}}, .node_id = 5};
}

std::vector<std::byte> kept_by(const DriveUnit& unit) {
  std::vector<std::byte> buffer(retained_image::size(unit));
  const auto written = retained_image::save(unit, buffer);
  EXPECT_TRUE(written);
  EXPECT_EQ(written->size(), buffer.size());
  return buffer;
}

/// Makes the checksum of a changed image right again.
void seal(std::vector<std::byte>& image) {
  const std::uint32_t crc = crc32(std::span{image}.first(image.size() - 4));
  for (std::size_t i = 0; i < 4; ++i) image[image.size() - 4 + i] = static_cast<std::byte>(crc >> (8 * i));
}

double value(const DriveUnit& unit, std::uint8_t object, std::uint16_t number, std::size_t index = 0) {
  return unit.object(object)->read(number, index).value();
}

TEST(RetainedImage, BringsTheFaultBufferOfEveryDriveObjectBack) {
  DriveUnit unit{two_axes()};
  unit.set_time(1000);
  ASSERT_TRUE(unit.raise(kX, 7901, 11));
  ASSERT_TRUE(unit.raise(kY, 7900, 22));
  unit.set_time(2000);
  ASSERT_TRUE(unit.acknowledge());
  ASSERT_TRUE(unit.raise(kX, 7860, 33));
  ASSERT_TRUE(unit.acknowledge());
  const std::vector<std::byte> image = kept_by(unit);

  DriveUnit fresh{two_axes()};
  ASSERT_TRUE(retained_image::load(fresh, image));

  EXPECT_EQ(value(fresh, kX, 945, 0), 0.0);
  EXPECT_EQ(value(fresh, kX, 945, 8), 7860.0);
  EXPECT_EQ(value(fresh, kX, 949, 8), 33.0);
  EXPECT_EQ(value(fresh, kX, 947, 16), 7901.0);
  EXPECT_EQ(value(fresh, kX, 948, 16), 1000.0);
  EXPECT_EQ(value(fresh, kX, 2109, 16), 2000.0);
  EXPECT_EQ(value(fresh, kY, 945, 8), 7900.0);
  EXPECT_EQ(value(fresh, kX, 952), 2.0);
  EXPECT_EQ(value(fresh, kX, 944), value(unit, kX, 944));
  EXPECT_TRUE(fresh.object(kX)->messages().faults().empty());
  EXPECT_EQ(kept_by(fresh), image);
}

TEST(RetainedImage, EndsACaseThatWasActiveWithThePower) {
  DriveUnit unit{two_axes()};
  unit.set_time(500);
  ASSERT_TRUE(unit.raise(kX, 7860, 1));
  ASSERT_TRUE(unit.raise(kX, 7901, 2));
  unit.set_time(900);

  DriveUnit fresh{two_axes()};
  ASSERT_TRUE(retained_image::load(fresh, kept_by(unit)));

  EXPECT_TRUE(fresh.object(kX)->messages().faults().empty());
  EXPECT_EQ(value(fresh, kX, 945, 0), 0.0);
  EXPECT_EQ(value(fresh, kX, 945, 8), 7860.0);
  EXPECT_EQ(value(fresh, kX, 945, 9), 7901.0);
  EXPECT_EQ(value(fresh, kX, 948, 9), 500.0);
  EXPECT_EQ(value(fresh, kX, 2109, 9), 900.0);
  EXPECT_EQ(value(fresh, kX, 2109, 10), 0.0);
}

TEST(RetainedImage, LetsTheTimesOfFaultsGoOn) {
  constexpr Uptime kDay = 24ULL * 60 * 60 * 1000;
  DriveUnit unit{two_axes()};
  unit.set_time(2 * kDay + 5);

  DriveUnit second{two_axes()};
  ASSERT_TRUE(retained_image::load(second, kept_by(unit)));
  second.set_time(10);
  ASSERT_TRUE(second.raise(1, 1000));

  EXPECT_EQ(second.runtime(), 2 * kDay + 15);
  EXPECT_EQ(value(second, 1, 948), 15.0);
  EXPECT_EQ(value(second, 1, 2130), 2.0);
}

TEST(RetainedImage, CountsTheEnergiesOn) {
  DriveUnit unit{two_axes()};
  unit.axes()[1].continue_energy(7.2e6, 3.6e6);

  DriveUnit fresh{two_axes()};
  ASSERT_TRUE(retained_image::load(fresh, kept_by(unit)));

  EXPECT_EQ(value(fresh, kY, 39, 0), 1.0);
  EXPECT_EQ(value(fresh, kY, 39, 1), 2.0);
  EXPECT_EQ(value(fresh, kY, 39, 2), 1.0);
  EXPECT_EQ(value(fresh, kX, 39, 1), 0.0);
}

TEST(RetainedImage, PassesOverASectionThatItDoesNotKnow) {
  DriveUnit unit{two_axes()};
  ASSERT_TRUE(unit.raise(1, 1000, 77));
  std::vector<std::byte> image = kept_by(unit);
  constexpr std::size_t kFirstObject = 16 + 8 + 2;
  const std::vector<std::byte> section{std::byte{99}, std::byte{0}, std::byte{1}, std::byte{0}, std::byte{42}};
  image[kFirstObject + 2] = std::byte{2};
  image.insert(image.begin() + kFirstObject + 4, section.begin(), section.end());
  seal(image);

  DriveUnit fresh{two_axes()};
  ASSERT_TRUE(retained_image::load(fresh, image));

  EXPECT_EQ(value(fresh, 1, 949, 8), 77.0);
}

TEST(RetainedImage, IsRefusedWithTheReasonAndWithoutAnEffect) {
  DriveUnit unit{two_axes()};
  ASSERT_TRUE(unit.raise(1, 1000, 77));
  unit.axes()[1].continue_energy(7.2e6, 3.6e6);
  const std::vector<std::byte> image = kept_by(unit);
  DriveUnit fresh{two_axes()};
  const auto error_of = [&](std::vector<std::byte> bytes) { return retained_image::load(fresh, bytes).error(); };
  const auto changed = [&](std::size_t at, std::byte byte) {
    std::vector<std::byte> bytes = image;
    bytes[at] = byte;
    seal(bytes);
    return bytes;
  };
  std::vector<std::byte> damaged = image;
  damaged[100] = ~damaged[100];

  EXPECT_EQ(error_of({}), Error::NotAnImage);
  EXPECT_EQ(error_of(changed(0, std::byte{'x'})), Error::NotAnImage);
  EXPECT_EQ(error_of(changed(8, std::byte{9})), Error::OtherVersion);
  EXPECT_EQ(error_of(damaged), Error::WrongChecksum);
  EXPECT_EQ(error_of({image.begin(), image.begin() + 12}), Error::Truncated);
  EXPECT_EQ(error_of(changed(10, std::byte{2})), Error::OtherUnit);
  EXPECT_EQ(error_of(changed(26, std::byte{9})), Error::NoSuchObject);
  EXPECT_EQ(error_of(changed(32, std::byte{0})), Error::Truncated);
  EXPECT_EQ(error_of(changed(image.size() - 5, std::byte{0xFF})), Error::NoSuchParameter);  // less than nothing
  EXPECT_EQ(value(fresh, 1, 945, 8), 0.0);
  EXPECT_EQ(retained_image::save(unit, std::span{damaged}.first(100)).error(), Error::NoRoom);
}

TEST(RetainedImage, NeitherCrashesNorLoadsWhatWasDamagedAnywhere) {
  DriveUnit unit{two_axes()};
  const std::vector<std::byte> image = kept_by(unit);
  const auto seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random{seed};
  std::uniform_int_distribution<std::size_t> place{0, image.size() - 1};
  std::uniform_int_distribution<int> bit{0, 7};
  DriveUnit fresh{two_axes()};

  for (int round = 0; round < 500; ++round) {
    std::vector<std::byte> damaged = image;
    damaged[place(random)] ^= static_cast<std::byte>(1 << bit(random));
    EXPECT_FALSE(retained_image::load(fresh, damaged));
    damaged.resize(place(random));
    EXPECT_FALSE(retained_image::load(fresh, damaged));
    if (damaged.size() < 8) continue;
    seal(damaged);
    static_cast<void>(retained_image::load(fresh, damaged));
  }
}

}  // namespace
}  // namespace drive
