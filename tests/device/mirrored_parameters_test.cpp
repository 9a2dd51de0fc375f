#include <array>

#include "drive/images/storage_image.hpp"
#include "tests/device/test_unit.hpp"

namespace device {
namespace {

constexpr std::uint8_t kControlUnit = 1, kAxis1 = 2, kAxis8 = 9;

/// A parameter and the entry that shows it, on a unit of eight axes.
struct Pair {
  std::uint8_t object;
  std::uint16_t number;
  std::size_t index;
  std::uint16_t entry;
  std::uint8_t sub_index;
};

/// Every mirrored parameter with every index: @p visit gets a Pair.
template <class Visit>
void for_each_pair(const Visit& visit) {
  constexpr std::array kUnit{
      // with the count of indices in place of an index
      Pair{1, 8600, 1, 0x1000, 0},  Pair{1, 8601, 1, 0x1001, 0}, Pair{1, 8602, 1, 0x1005, 0},
      Pair{1, 8603, 1, 0x1014, 0},  Pair{1, 8606, 1, 0x1017, 0}, Pair{1, 8607, 4, 0x1018, 1},
      Pair{1, 8609, 2, 0x1029, 1},  Pair{1, 8610, 2, 0x1200, 1}, Pair{1, 8612, 2, 0x1201, 1},
      Pair{1, 8611, 83, 0x1003, 0},
  };
  for (Pair pair : kUnit) {
    const std::size_t count = pair.index;
    for (pair.index = 0; pair.index < count; ++pair.index, ++pair.sub_index) visit(pair);
  }
  visit(Pair{1, 8604, 0, 0x100C, 0});
  visit(Pair{1, 8604, 1, 0x100D, 0});
  struct Group {
    std::uint16_t number, entry, stride;
    std::uint8_t pdos, count;
  };
  constexpr std::array kAxes{Group{8612, 0x1202, 1, 1, 2},    Group{8700, 0x1400, 0x40, 8, 2},
                             Group{8710, 0x1600, 0x40, 8, 4}, Group{8720, 0x1800, 0x40, 8, 5},
                             Group{8730, 0x1A00, 0x40, 8, 4}, Group{8798, 0x6094, 0x800, 1, 2}};
  for (const Group& group : kAxes)
    for (unsigned axis = 0; axis < 8; ++axis)
      for (unsigned i = 0; i < unsigned{group.pdos} * group.count; ++i)
        visit(Pair{static_cast<std::uint8_t>(kAxis1 + axis),
                   static_cast<std::uint16_t>(group.number + i / group.count), i % group.count,
                   static_cast<std::uint16_t>(group.entry + axis * group.stride + i / group.count),
                   static_cast<std::uint8_t>(1 + i % group.count)});
}

std::string text_of(const Pair& pair) {
  return "drive object " + std::to_string(pair.object) + ", parameter " + std::to_string(pair.number) + "[" +
         std::to_string(pair.index) + "]";
}

Configuration eight_axes() {
  return {.node_id = 5, .axes = std::vector<AxisSetup>(8)};
}

/// A unit with eight axes and its parameters, by drive object.
struct MirroredUnit : TestUnit {
  MirroredUnit() : TestUnit{eight_axes()} { start(); }

  double read(std::uint8_t object, std::uint16_t number, std::size_t index = 0) const {
    return device.unit().object(object)->read(number, index).value();
  }
};

TEST(MirroredParameters, HaveTheFactoryValuesThatTheirObjectsHave) {
  MirroredUnit unit;
  drive::UnitConfiguration configuration{.axes = std::vector<drive::AxisConfiguration>(8), .node_id = 5};
  const drive::DriveUnit factory{configuration};
  std::size_t count = 0;

  for_each_pair([&](const Pair& pair) {
    const auto value = factory.object(pair.object)->read(pair.number, pair.index);
    const Upload upload = unit.upload(pair.entry, pair.sub_index);
    ASSERT_TRUE(value) << text_of(pair);
    ASSERT_EQ(upload.abort_code, 0U) << text_of(pair);
    EXPECT_EQ(*value, static_cast<double>(upload.number())) << text_of(pair);
    ++count;
  });

  EXPECT_EQ(count, 100U + 8 * 124U);
}

TEST(MirroredParameters, ShowWhatWasWrittenToTheObject) {
  MirroredUnit unit;

  ASSERT_EQ(unit.download(0x1017, 0, 500, 2), 0U);
  ASSERT_EQ(unit.download(0x1440, 1, 0x80000000, 4), 0U);
  ASSERT_EQ(unit.download(0x1640, 1, 0x68600008, 4), 0U);
  ASSERT_EQ(unit.download(0x9894, 2, 7, 4), 0U);

  EXPECT_EQ(unit.read(kControlUnit, 8606), 500.0);
  EXPECT_EQ(unit.read(3, 8700), static_cast<double>(0x80000000));
  EXPECT_EQ(unit.read(3, 8710), static_cast<double>(0x68600008));
  EXPECT_EQ(unit.read(kAxis8, 8798, 1), 7.0);
}

TEST(MirroredParameters, OfTheConfigurationAreInForceFromTheStartAndAfterAReset) {
  const std::vector<ParameterPreset> presets{
      {8700, 0x80000205, 0}, {8720, 0x40000195, 0}, {8711, 0x60710010, 1}, {8711, 0, 2}, {8798, 3, 1}};
  TestUnit unit{unit_with(presets)};
  unit.start();
  const auto expect_presets = [&] {
    EXPECT_EQ(unit.upload(0x1400, 1).number(), 0x80000205U);
    EXPECT_EQ(unit.upload(0x1800, 1).number(), 0x40000195U);
    EXPECT_EQ(unit.upload(0x1601, 0).number(), 2U);
    EXPECT_EQ(unit.upload(0x1601, 2).number(), 0x60710010U);
    EXPECT_EQ(unit.upload(0x6094, 2).number(), 3U);
  };

  expect_presets();
  for (const char* const reset : {"000#8205", "000#8105"}) {
    ASSERT_EQ(unit.download(0x1800, 1, 0xC0000195, 4), 0U);
    ASSERT_EQ(unit.download(0x1017, 0, 1000, 2), 0U);
    EXPECT_EQ(unit.says(reset), Lines{"705#00"});
    expect_presets();
    EXPECT_EQ(unit.upload(0x1017).number(), 0U);
  }
  EXPECT_EQ(from("195#", unit.says("000#0105")).size(), 1U);
}

TEST(MirroredParameters, ReturnToTheirFactoryValuesWithTheirDriveObject) {
  MirroredUnit unit;
  ASSERT_EQ(unit.download(0x1400, 1, 0x80000215, 4), 0U);
  ASSERT_EQ(unit.download(0x1600, 1, 0x60600008, 4), 0U);
  ASSERT_EQ(unit.download(0x1400, 1, 0x00000215, 4), 0U);
  ASSERT_EQ(unit.download(0x1440, 1, 0x00000216, 4), 0U);
  ASSERT_EQ(unit.download(0x41B6, 0, kAxis1, 2), 0U);
  ASSERT_EQ(unit.download(0x2000 + 10, 0, 30, 2), 0U);

  ASSERT_EQ(unit.download(0x2000 + 970, 0, 1, 2), 0U);

  EXPECT_EQ(unit.upload(0x1400, 1).number(), 0x205U);
  EXPECT_EQ(unit.upload(0x1600, 1).number(), 0x60400010U);
  EXPECT_EQ(unit.upload(0x1440, 1).number(), 0x216U);
  unit.says("000#0105");
  EXPECT_NE(from("185#", unit.cycles_with("205#0600")), Lines{}) << "RPDO 1 is the one of a new unit";
}

TEST(MirroredParameters, ShowTheActiveMessages) {
  MirroredUnit unit;
  ASSERT_TRUE(unit.device.raise(2, 7900, 0, unit.now));

  EXPECT_EQ(unit.read(kControlUnit, 8601), static_cast<double>(0x81));
  EXPECT_EQ(unit.read(kControlUnit, 8611, 0), 1.0);
  EXPECT_EQ(unit.read(kControlUnit, 8611, 1), static_cast<double>(0x00031000));
  EXPECT_EQ(unit.read(kControlUnit, 8611, 0x0C), static_cast<double>(7900U << 16 | 0x1000));
}

TEST(MirroredParameters, AreSavedAsTheObjectsStand) {
  MirroredUnit unit;
  ASSERT_EQ(unit.download(0x1017, 0, 500, 2), 0U);
  ASSERT_EQ(unit.download(0x1440, 1, 0x80000000, 4), 0U);
  std::vector<std::byte> buffer(drive::storage_image::size(unit.device.unit()));

  const auto image = drive::storage_image::save(unit.device.unit(), buffer);

  ASSERT_TRUE(image);
  drive::DriveUnit other{{.axes = std::vector<drive::AxisConfiguration>(8), .node_id = 5}};
  ASSERT_TRUE(drive::storage_image::load(other, *image));
  EXPECT_EQ(other.object(kControlUnit)->read(8606).value(), 500.0);
  EXPECT_EQ(other.object(3)->read(8700).value(), static_cast<double>(0x80000000));
}

}  // namespace
}  // namespace device
