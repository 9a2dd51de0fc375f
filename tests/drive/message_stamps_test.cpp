/// When messages came and went, by the clock of the unit.
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "drive/images/retained_image.hpp"
#include "tests/drive/clocked_unit.hpp"

namespace drive {
namespace {

/// What r0948 with r2130, or r2109 with r2136, shows at @p index.
std::pair<double, double> time_of(const DriveUnit& unit, std::uint16_t milliseconds, std::uint16_t days,
                                  std::size_t index) {
  return {value(unit, kX, milliseconds, index), value(unit, kX, days, index)};
}
using Time = std::pair<double, double>;

TEST(MessageStamps, AreInUtcFromThenOn) {
  ClockedUnit unit;
  unit.put(3100, 0.0);
  unit.unit.set_time(2 * kMillisecondsOfADay + 500);
  ASSERT_TRUE(unit.unit.raise(kX, 7860));
  ASSERT_TRUE(unit.unit.raise(kX, 7850));
  unit.put(3100, 1.0);
  unit.tell(kNoon);
  unit.passes(20);
  unit.unit.acknowledge();
  unit.unit.withdraw(kX, 7850);
  ASSERT_TRUE(unit.unit.raise(kX, 7861));
  ASSERT_TRUE(unit.unit.raise(kX, 7850));

  EXPECT_EQ(time_of(unit.unit, 948, 2130, 8), (Time{500.0, 2.0})) << "that was before";
  EXPECT_EQ(time_of(unit.unit, 2109, 2136, 8), (Time{kNoon + 20.0, kDays}));
  EXPECT_EQ(time_of(unit.unit, 948, 2130, 0), (Time{kNoon + 20.0, kDays}));
  EXPECT_EQ(time_of(unit.unit, 2109, 2136, 0), (Time{0.0, 0.0}));
  EXPECT_EQ(time_of(unit.unit, 2123, 2145, 0), (Time{500.0, 2.0}));
  EXPECT_EQ(time_of(unit.unit, 2125, 2146, 0), (Time{kNoon + 20.0, kDays}));
  EXPECT_EQ(time_of(unit.unit, 2123, 2145, 1), (Time{kNoon + 20.0, kDays}));

  unit.put(3100, 0.0);
  ASSERT_TRUE(unit.unit.raise(kX, 7862));
  EXPECT_EQ(time_of(unit.unit, 948, 2130, 0), (Time{kNoon + 20.0, kDays})) << "what has a time keeps it";
  EXPECT_EQ(time_of(unit.unit, 948, 2130, 1), (Time{520.0, 2.0}));
}

std::vector<std::byte> kept_by(const DriveUnit& unit) {
  std::vector<std::byte> buffer(retained_image::size(unit));
  EXPECT_TRUE(retained_image::save(unit, buffer));
  return buffer;
}

TEST(MessageStamps, StayThroughAPowerCut) {
  ClockedUnit unit;
  ASSERT_TRUE(unit.unit.raise(kX, 7860));
  unit.tell(kNoon);
  unit.unit.acknowledge();
  ASSERT_TRUE(unit.unit.raise(kX, 7861));
  unit.passes(1000);

  DriveUnit next{two_axes()};
  ASSERT_TRUE(next.object(kUnit)->load(3100, 0, 1.0));
  ASSERT_TRUE(retained_image::load(next, kept_by(unit.unit)));

  EXPECT_EQ(time_of(next, 948, 2130, 8), (Time{kNoon, kDays}));
  EXPECT_EQ(time_of(next, 2109, 2136, 8), (Time{kNoon + 1000.0, kDays})) << "the power went";
  EXPECT_EQ(time_of(next, 948, 2130, 16), (Time{0.0, 0.0})) << "UTC had just begun";
  EXPECT_EQ(time_of(next, 2109, 2136, 16), (Time{kNoon, kDays}));
  EXPECT_EQ(value(next, kUnit, 3102, 0), 0.0) << "the clock itself begins anew";
  EXPECT_EQ(value(next, kUnit, 2114, 0), 1010.0);
}

/// An image as earlier releases wrote it: without times in UTC.
std::vector<std::byte> without_utc(std::vector<std::byte> image, std::size_t objects) {
  constexpr std::size_t kContent = 16 + 8 + 2, kHead = 4, kSectionHead = 4, kUtc = 8 + 64 * 16;
  constexpr std::size_t kFaults = 2 + 2 + 64 * 22, kEnergy = 16;
  std::size_t at = kContent;
  for (std::size_t i = 0; i < objects; ++i) {
    image[at + 2] = static_cast<std::byte>(std::to_integer<int>(image[at + 2]) - 1);
    const auto section = image.begin() + static_cast<std::ptrdiff_t>(at + kHead);
    image.erase(section, section + kSectionHead + kUtc);
    at += kHead + kSectionHead + kFaults + (i > 0 ? kSectionHead + kEnergy : 0);
  }
  EXPECT_EQ(at + 4, image.size());
  seal(image);
  return image;
}

TEST(MessageStamps, AreWithoutUtcInAnOlderImage) {
  TestUnit unit;
  unit.unit.set_time(700);
  ASSERT_TRUE(unit.unit.raise(kX, 7860));
  unit.unit.set_time(800);

  DriveUnit next{two_axes()};
  ASSERT_TRUE(retained_image::load(next, without_utc(kept_by(unit.unit), 3)));

  EXPECT_EQ(value(next, kX, 945, 8), 7860.0);
  EXPECT_EQ(time_of(next, 948, 2130, 8), (Time{700.0, 0.0}));
  EXPECT_EQ(time_of(next, 2109, 2136, 8), (Time{800.0, 0.0}));
}

}  // namespace
}  // namespace drive
