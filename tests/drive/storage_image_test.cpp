#include "drive/images/storage_image.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "tests/drive/image_fixture.hpp"

namespace drive {
namespace {

using storage_image::Error;

std::vector<std::byte> saved(const DriveUnit& unit, std::uint8_t object = storage_image::kAllObjects) {
  std::vector<std::byte> buffer(storage_image::size(unit, object));
  const auto written = storage_image::save(unit, buffer, object);
  EXPECT_TRUE(written);
  EXPECT_EQ(written->size(), buffer.size());
  return buffer;
}

TEST(StorageImage, BringsEveryWrittenValueBack) {
  DriveUnit unit{two_axes()};
  ASSERT_TRUE(unit.object(kX)->write(1120, 0.3F));
  ASSERT_TRUE(unit.object(kX)->write(8791, 2));
  ASSERT_TRUE(unit.object(kX)->write(2617, 63, -2147482648.0));
  ASSERT_TRUE(unit.object(kY)->write(2100, 19, 7900));
  ASSERT_TRUE(unit.object(1)->write(8622, 3));
  const std::vector<std::byte> image = saved(unit);

  DriveUnit fresh{two_axes()};
  ASSERT_TRUE(storage_image::load(fresh, image));

  EXPECT_FLOAT_EQ(static_cast<float>(value(fresh, kX, 1120)), 0.3F);
  EXPECT_EQ(value(fresh, kX, 8791), 2.0);
  EXPECT_EQ(value(fresh, kX, 2617, 63), -2147482648.0);
  EXPECT_EQ(value(fresh, kY, 2100, 19), 7900.0);
  EXPECT_EQ(value(fresh, 1, 8622), 3.0);
  EXPECT_EQ(saved(fresh), image);
}

TEST(StorageImage, PassesOverWhatIsNoLongerSaved) {
  DriveUnit unit{two_axes()};
  std::vector<std::byte> image = saved(unit);
  // In the place of p1300: p1910, which is a command.
  const std::array before{std::byte{0x14}, std::byte{0x05}, std::byte{0}, static_cast<std::byte>(DataType::I16)};
  const auto place = std::search(image.begin(), image.end(), before.begin(), before.end());
  ASSERT_NE(place, image.end());
  place[0] = std::byte{0x76}, place[1] = std::byte{0x07};
  seal(image);

  DriveUnit fresh{two_axes()};
  EXPECT_TRUE(storage_image::load(fresh, image));

  EXPECT_EQ(value(fresh, kX, 1910), 0.0);
  EXPECT_EQ(value(fresh, kX, 1300), 21.0);
}

TEST(StorageImage, TakesOneDriveObjectOnly) {
  DriveUnit unit{two_axes()};
  ASSERT_TRUE(unit.object(kX)->write(1120, 1.0));
  ASSERT_TRUE(unit.object(kY)->write(1120, 2.0));
  const std::vector<std::byte> all = saved(unit);
  const std::vector<std::byte> only_x = saved(unit, kX);

  DriveUnit fresh{two_axes()};
  ASSERT_TRUE(storage_image::load(fresh, all, {kY}));
  EXPECT_EQ(value(fresh, kX, 1120), 10.0);
  EXPECT_EQ(value(fresh, kY, 1120), 2.0);
  ASSERT_TRUE(storage_image::load(fresh, only_x));
  EXPECT_EQ(value(fresh, kX, 1120), 1.0);
  EXPECT_EQ(storage_image::load(fresh, only_x, {kY}).error(), Error::NoSuchObject);
  std::vector<std::byte> buffer(all.size());
  EXPECT_EQ(storage_image::save(unit, buffer, 9).error(), Error::NoSuchObject);
  EXPECT_EQ(storage_image::save(unit, std::span{buffer}.first(100)).error(), Error::NoRoom);
}

/// @p image with the present values of @p selection.
std::vector<std::byte> updated(const DriveUnit& unit, std::span<const std::byte> image,
                               const storage_image::Selection& selection) {
  std::vector<std::byte> buffer(storage_image::size(unit));
  const auto written = storage_image::update(unit, image, buffer, selection);
  EXPECT_TRUE(written);
  buffer.resize(written->size());
  return buffer;
}

bool is_a_ramp(const ParameterRow& row) noexcept {
  return row.number == 1120 || row.number == 1121;
}

TEST(StorageImage, TakesOverTheChosenParametersOnly) {
  DriveUnit unit{two_axes()};
  const std::vector<std::byte> image = saved(unit);
  for (const std::uint8_t axis : {kX, kY}) {
    ASSERT_TRUE(unit.object(axis)->write(1120, 1.0));
    ASSERT_TRUE(unit.object(axis)->write(1121, 2.0));
    ASSERT_TRUE(unit.object(axis)->write(1135, 3.0));
  }

  DriveUnit ramps{two_axes()};
  ASSERT_TRUE(storage_image::load(ramps, updated(unit, image, {.rows = is_a_ramp})));
  DriveUnit ramps_of_y{two_axes()};
  ASSERT_TRUE(storage_image::load(ramps_of_y, updated(unit, image, {kY, is_a_ramp})));
  DriveUnit only_y{two_axes()};
  ASSERT_TRUE(storage_image::load(only_y, updated(unit, image, {kY})));
  DriveUnit loaded{two_axes()};
  ASSERT_TRUE(storage_image::load(loaded, saved(unit), {kX, is_a_ramp}));

  EXPECT_EQ(value(ramps, kX, 1120), 1.0);
  EXPECT_EQ(value(ramps, kY, 1121), 2.0);
  EXPECT_EQ(value(ramps, kY, 1135), 0.0);
  EXPECT_EQ(value(ramps_of_y, kX, 1120), 10.0);
  EXPECT_EQ(value(ramps_of_y, kY, 1120), 1.0);
  EXPECT_EQ(value(only_y, kX, 1135), 0.0);
  EXPECT_EQ(value(only_y, kY, 1135), 3.0);
  EXPECT_EQ(value(loaded, kX, 1121), 2.0);
  EXPECT_EQ(value(loaded, kX, 1135), 0.0);
  EXPECT_EQ(value(loaded, kY, 1121), 10.0);
}

TEST(StorageImage, GrowsByWholeDriveObjects) {
  DriveUnit unit{two_axes()};
  EXPECT_FALSE(storage_image::is_complete(unit, {}));
  std::vector<std::byte> image = updated(unit, {}, {kY});
  EXPECT_EQ(image, saved(unit, kY));
  EXPECT_FALSE(storage_image::is_complete(unit, image));
  EXPECT_EQ(updated(unit, image, {kX, is_a_ramp}), image);

  image = updated(unit, updated(unit, image, {1}), {kX});

  EXPECT_TRUE(storage_image::is_complete(unit, image));
  EXPECT_EQ(image, saved(unit));
}

TEST(StorageImage, LeavesOutCommandsCountersAndFilters) {
  DriveUnit unit{two_axes()};
  ASSERT_TRUE(unit.object(kX)->write(10, 1));
  const std::vector<std::byte> image = saved(unit);

  DriveUnit fresh{two_axes()};
  ASSERT_TRUE(storage_image::load(fresh, image));

  EXPECT_EQ(value(fresh, kX, 10), 0.0);
}

TEST(StorageImage, IsRefusedForAnotherUnit) {
  const std::vector<std::byte> image = saved(DriveUnit{two_axes()});
  UnitConfiguration vector = two_axes();
  vector.axes[1].kind = ObjectKind::Vector;
  UnitConfiguration stronger = two_axes();
  stronger.axes[0].machine.rated_torque *= 2.0;

  for (const UnitConfiguration& other : {UnitConfiguration{}, vector, stronger}) {
    DriveUnit unit{other};
    EXPECT_EQ(storage_image::load(unit, image).error(), Error::OtherUnit);
  }
}

TEST(StorageImage, IsRefusedWithTheReasonAndWithoutAnEffect) {
  DriveUnit unit{two_axes()};
  ASSERT_TRUE(unit.object(1)->write(8699, 77.0));
  const std::vector<std::byte> image = saved(unit);
  DriveUnit fresh{two_axes()};
  const auto error_of = [&](std::vector<std::byte> bytes) { return storage_image::load(fresh, bytes).error(); };
  const auto changed = [&](std::size_t at, std::byte value, bool sealed) {
    std::vector<std::byte> bytes = image;
    bytes[at] = value;
    if (sealed) seal(bytes);
    return bytes;
  };
  std::vector<std::byte> longer = image;
  longer.push_back(std::byte{0});
  seal(longer);

  EXPECT_EQ(error_of({}), Error::NotAnImage);
  EXPECT_EQ(error_of(changed(0, std::byte{'x'}, false)), Error::NotAnImage);
  EXPECT_EQ(error_of(changed(8, std::byte{2}, false)), Error::OtherVersion);
  EXPECT_EQ(error_of(changed(image.size() / 2, ~image[image.size() / 2], false)), Error::WrongChecksum);
  EXPECT_EQ(error_of({image.begin(), image.begin() + 12}), Error::Truncated);
  EXPECT_EQ(error_of(longer), Error::Truncated);
  EXPECT_EQ(error_of(changed(10, std::byte{9}, true)), Error::OtherUnit);
  EXPECT_EQ(error_of(changed(18, std::byte{9}, true)), Error::NoSuchObject);
  EXPECT_EQ(error_of(changed(22, std::byte{0xFF}, true)), Error::NoSuchParameter);
  EXPECT_EQ(value(fresh, 1, 8699), 0.0);
  EXPECT_EQ(image_format::text_of(Error::OtherUnit), "of a unit with other axes or motors");
}

TEST(StorageImage, NeitherCrashesNorLoadsWhatWasDamagedAnywhere) {
  DriveUnit unit{two_axes()};
  const std::vector<std::byte> image = saved(unit);
  expect_damage_to_be_refused(image, [](DriveUnit& unit_, std::span<const std::byte> damaged) {
    return storage_image::load(unit_, damaged).has_value();
  });
}

}  // namespace
}  // namespace drive
