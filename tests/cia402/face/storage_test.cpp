// 1010h, 1011h, 1020h, and what comes back with a reset and a power-on.
#include "checksum/crc32.hpp"
#include "drive/images/image_format.hpp"
#include "tests/cia402/face/test_device.hpp"

namespace cia402 {
namespace {

constexpr std::int64_t kSave = 0x65766173, kLoad = 0x64616F6C;

TEST(Storage, BringsSavedObjectsBackWithAResetOfTheNode) {
  TestDevice device;
  device.start();
  device.write(0x6081, 111);
  device.write(0x1017, 500);
  ASSERT_EQ(device.write(0x1010, 1, kSave), 0U);
  device.write(0x6081, 222);
  device.says("000#8105");
  EXPECT_EQ(device.read(0x6081), 111);
  EXPECT_EQ(device.read(0x1017), 500);
}

TEST(Storage, OfAGroupLeavesTheOther) {
  TestDevice device;
  device.start();
  device.write(0x6081, 111);
  device.write(0x1017, 500);
  ASSERT_EQ(device.write(0x1010, 3, kSave), 0U);
  device.says("000#8105");
  EXPECT_EQ(device.read(0x6081), 111);
  EXPECT_EQ(device.read(0x1017), 0);
}

TEST(Storage, IsThereAfterThePowerOnOfAnotherDevice) {
  TestDevice device;
  device.start();
  device.write(0x6098, 37);
  ASSERT_EQ(device.write(0x1010, 1, kSave), 0U);
  TestDevice other;
  ASSERT_TRUE(other.device.load_parameters(device.listener.image));
  other.start();
  EXPECT_EQ(other.read(0x6098), 37);
}

/// @p image with other bytes from @p offset on, and the checksum that they have.
std::vector<std::byte> changed(std::span<const std::byte> image, std::size_t offset,
                               std::initializer_list<unsigned> bytes) {
  std::vector<std::byte> copy{image.begin(), image.end()};
  for (const unsigned byte : bytes) copy[offset++] = static_cast<std::byte>(byte);
  const std::size_t sealed = copy.size() - drive::image_format::kChecksumSize;
  const std::uint32_t checksum = checksum::crc32(std::span{copy}.first(sealed));
  for (std::size_t i = 0; i < 4; ++i) copy[sealed + i] = static_cast<std::byte>(checksum >> 8U * i);
  return copy;
}

TEST(Storage, RefusesWhatNoObjectCanHave) {
  TestDevice device;
  device.start();
  ASSERT_EQ(device.write(0x1010, 1, kSave), 0U);
  const auto& image = device.listener.image;
  constexpr std::size_t kNodeId = drive::image_format::kHeadSize, kFirstValue = kNodeId + 2 + 4 + 2 + 1;
  TestDevice other;
  EXPECT_TRUE(other.device.load_parameters(changed(image, kNodeId, {7, 1})));
  EXPECT_FALSE(other.device.load_parameters(changed(image, kNodeId, {0x80, 1}))) << "node-ID 128";
  EXPECT_FALSE(other.device.load_parameters(changed(image, kNodeId, {0, 1}))) << "node-ID 0";
  EXPECT_FALSE(other.device.load_parameters(changed(image, kNodeId, {7, 2}))) << "another bit";
  EXPECT_FALSE(other.device.load_parameters(changed(image, kFirstValue, {0, 0, 0, 0, 0, 1}))) << "40 bits in 32";
}

TEST(Storage, IsGoneAfterLoadAndAReset) {
  TestDevice device;
  device.start();
  device.write(0x6081, 111);
  ASSERT_EQ(device.write(0x1010, 1, kSave), 0U);
  ASSERT_EQ(device.write(0x1011, 1, kLoad), 0U);
  EXPECT_EQ(device.read(0x6081), 111) << "not before the reset";
  device.says("000#8105");
  EXPECT_EQ(device.read(0x6081), 655360);
}

TEST(Storage, NeedsItsSignature) {
  TestDevice device;
  device.start();
  EXPECT_EQ(device.write(0x1010, 1, 1), 0x08000020U);
  EXPECT_EQ(device.write(0x1011, 1, 1), 0x08000020U);
  device.listener.is_full = true;
  EXPECT_EQ(device.write(0x1010, 1, kSave), 0x06060000U);
}

TEST(Storage, DoesNotKeepSetPoints) {
  TestDevice device;
  device.start();
  device.write(0x607A, 5000);
  device.write(0x6060, 8);
  ASSERT_EQ(device.write(0x1010, 1, kSave), 0U);
  device.says("000#8105");
  EXPECT_EQ(device.read(0x607A), 0);
  EXPECT_EQ(device.read(0x6060), 0);
  EXPECT_EQ(device.read(0x6061), 0);
}

TEST(VerifyConfiguration, IsClearedByAnyWriteOfWhatIsSaved) {
  TestDevice device;
  device.start();
  device.write(0x1020, 1, 12345);
  device.write(0x1020, 2, 678);
  device.write(0x607A, 5);
  EXPECT_EQ(device.read(0x1020, 1), 12345);
  device.write(0x6083, 5000);
  EXPECT_EQ(device.read(0x1020, 1), 0);
  EXPECT_EQ(device.read(0x1020, 2), 0);
}

}  // namespace
}  // namespace cia402
