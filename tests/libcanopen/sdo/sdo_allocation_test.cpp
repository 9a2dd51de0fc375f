#include <gtest/gtest.h>

#include "libcanopen/node/node.hpp"
#include "libcanopen/sdo/sdo_view.hpp"
#include "tests/fakes/allocation_counter.hpp"
#include "tests/fakes/candump.hpp"
#include "tests/libcanopen/fixture/sdo_table.hpp"

namespace {

using namespace std::chrono_literals;
using canopen::Entry;
using canopen::Frame;

/// A bus that counts frames and aborts.
class CountingBus final : public canopen::FrameSink {
 public:
  void send(const Frame& frame, canopen::Delivery) override {
    ++sent;
    if (frame.data[0] == 0x80) ++aborts;
  }
  std::uint64_t sent = 0, aborts = 0;
};

/// 100 000 zeros that may be read and written at any time.
class Zeros final : public canopen::DomainOwner {
 public:
  static constexpr std::uint64_t kSize = 100'000;
  canopen::Result<std::optional<std::uint32_t>> begin_read(const Entry&) noexcept override { return std::nullopt; }
  canopen::Result<std::size_t> read(const Entry&, std::uint64_t offset,
                                    std::span<std::uint8_t> into) noexcept override {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(into.size(), kSize - offset));
    std::fill_n(into.begin(), count, std::uint8_t{0});
    return count;
  }
  canopen::Result<void> begin_write(const Entry&, std::optional<std::uint32_t>) noexcept override { return {}; }
  canopen::Result<void> write(const Entry&, std::uint64_t, std::span<const std::uint8_t>) noexcept override {
    return {};
  }
  canopen::Result<void> end_write(const Entry&, std::uint64_t size) noexcept override {
    written += size;
    return {};
  }
  std::uint64_t written = 0;
};

/// Eight zeros behind every index from 3000h on.
class ZeroView final : public canopen::SdoView {
 public:
  canopen::ObjectPlace place_of(std::uint8_t, std::uint16_t index) const noexcept override {
    return index < 0x3000 ? canopen::ObjectPlace::Dictionary : canopen::ObjectPlace::Application;
  }
  canopen::Result<std::size_t> read(std::uint8_t, std::uint16_t, std::uint8_t,
                                    std::span<std::uint8_t, 8> value) noexcept override {
    std::fill(value.begin(), value.end(), std::uint8_t{0});
    return value.size();
  }
  canopen::Result<void> write(std::uint8_t, std::uint16_t, std::uint8_t, std::span<const std::uint8_t> value,
                              bool) noexcept override {
    written += value.size();
    return {};
  }
  std::uint64_t written = 0;
};

class SdoAllocation : public testing::Test {
 protected:
  void says(std::uint64_t word) {
    Frame frame{.id = 0x605, .length = 8};
    canopen::store(frame.data.data(), word);
    node.on_frame(frame, now);
    node.on_time(now);
  }
  void download_in_blocks() {
    says(0x00000000002100C4);
    for (std::uint64_t segment = 0; segment < kSegments - 1; ++segment) says(segment % 127 + 1);
    says(0x80U | ((kSegments - 1) % 127 + 1));
    says(0xC1U | (kSegments * 7 - Zeros::kSize) << 2);
  }
  void upload_in_blocks() {
    says(0x0000007F002100A4);
    says(0xA3);
    for (std::uint64_t block = 0; block < kSegments / 127; ++block) says(0x7F7FA2);
    says(0x7F00A2U | kSegments % 127 << 8);
    says(0xA1);
  }
  void transfer_in_segments() {
    says(0x0000000000210040);
    for (int segment = 0; segment < 1000; ++segment) says(segment % 2 == 0 ? 0x60 : 0x70);
    says(0x0000000000210020);
    for (int segment = 0; segment < 1000; ++segment) says(segment % 2 == 0 ? 0x00 : 0x10);
    says(0x80);
  }
  void switch_a_server() {
    says(0x0000069001120123);  // 1201h:01
    says(0x0000069102120123);  // 1201h:02
    says(0x8000069001120123);
    says(0x8000069102120123);
  }
  void let_transfers_time_out() {
    says(0x00000000002100C4);
    for (int second = 0; second < 11; ++second) {
      now += 1s;
      node.on_time(now);
    }
  }

  static constexpr std::uint64_t kSegments = (Zeros::kSize + 6) / 7;
  CountingBus bus;
  canopen::Application application;
  canopen::Dictionary dictionary{sdo_table(), 5};
  canopen::Node node{dictionary, {}, bus, application};
  Zeros zeros;
  canopen::TimePoint now{1h};
};

TEST_F(SdoAllocation, DoesNotHappenInTransfersOfAnyKind) {
  dictionary.own_domain(0x2100, 0, zeros);

  const std::uint64_t before = fakes::allocations();
  node.start(now);
  for (int round = 0; round < 3; ++round) {
    download_in_blocks();
    upload_in_blocks();
    transfer_in_segments();
    switch_a_server();
    let_transfers_time_out();
  }
  const std::uint64_t during = fakes::allocations() - before;

  EXPECT_EQ(during, 0U);
  EXPECT_EQ(zeros.written, 3 * Zeros::kSize);
  EXPECT_GT(bus.sent, 3 * (kSegments + 2000));
  EXPECT_EQ(bus.aborts, 3U) << "besides the three that time out";
}

TEST_F(SdoAllocation, DoesNotHappenWithAViewOrWhenTheNodeTakesOverItsValues) {
  ZeroView view;
  node.show(view);

  const std::uint64_t before = fakes::allocations();
  node.start(now);
  constexpr std::array<std::uint64_t, 6> kRequests{0x00300040, 0x60, 0x70, 0x0000000800300021, 0x00, 0x1D};
  for (const std::uint64_t word : kRequests) says(word);
  says(0x0403020100300023);
  switch_a_server();
  node.reload(now);
  const std::uint64_t during = fakes::allocations() - before;

  EXPECT_EQ(during, 0U);
  EXPECT_EQ(view.written, 12U);
  EXPECT_EQ(bus.aborts, 0U);
}

}  // namespace
