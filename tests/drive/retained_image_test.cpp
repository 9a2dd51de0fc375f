#include "drive/images/retained_image.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "tests/drive/image_fixture.hpp"

namespace drive {
namespace {

using retained_image::Error;

std::vector<std::byte> kept_by(const DriveUnit& unit) {
  std::vector<std::byte> buffer(retained_image::size(unit));
  const auto written = retained_image::save(unit, buffer);
  EXPECT_TRUE(written);
  EXPECT_EQ(written->size(), buffer.size());
  return buffer;
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
  image[kFirstObject + 2] = std::byte{3};
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
  expect_damage_to_be_refused(image, [](DriveUnit& unit_, std::span<const std::byte> damaged) {
    return retained_image::load(unit_, damaged).has_value();
  });
}

}  // namespace
}  // namespace drive
