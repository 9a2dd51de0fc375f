#include <gtest/gtest.h>

#include "tests/libcanopen/fixture/node_fixture.hpp"

namespace {

using canopen::Access;
using canopen::EntryDescription;
using canopen::Frame;
using enum canopen::DataType;

constexpr std::uint16_t kPdos = 512;
constexpr std::uint32_t kFirstRpdo = 0x181;  // as many identifiers as the 11 bits have, the rest with 29
constexpr std::uint32_t kLong = 1U << 29;

/// RPDO n carries 3000h + n, TPDO n carries 4000h + n, both UNSIGNED32.
void append_pdo(std::vector<EntryDescription>& table, std::uint16_t communication, std::uint32_t cob_id,
                std::uint16_t object) {
  const auto mapping = static_cast<std::uint16_t>(communication + 0x200);
  table.push_back({.index = communication, .access = Access::Constant, .initial = 2});
  table.push_back({.index = communication,
                   .sub_index = 1,
                   .type = Unsigned32,
                   .access = Access::ReadWrite,
                   .initial = cob_id});
  table.push_back({.index = communication, .sub_index = 2, .access = Access::ReadWrite, .initial = 1});
  table.push_back({.index = mapping, .access = Access::ReadWrite, .initial = 1});
  table.push_back({.index = mapping,
                   .sub_index = 1,
                   .type = Unsigned32,
                   .access = Access::ReadWrite,
                   .initial = std::int64_t{object} << 16 | 32});
  table.push_back({.index = object, .type = Unsigned32, .access = Access::ReadWrite, .pdo_mappable = true});
}

/// RPDOs take the identifiers of 29 bits, TPDOs 181h.. and from number 256 on 29 bits as well.
std::uint32_t rpdo_identifier(std::uint16_t number) {
  return kLong | 0x10000U | number;
}
std::uint32_t tpdo_identifier(std::uint16_t number) {
  return number < 256 ? kFirstRpdo + number : kLong | 0x20000U | number;
}

std::vector<EntryDescription> build() {
  std::vector<EntryDescription> table;
  table.push_back({.index = 0x1005, .type = Unsigned32, .access = Access::ReadWrite, .initial = 0x80});
  for (std::uint16_t n = 0; n < kPdos; ++n) {
    append_pdo(table, static_cast<std::uint16_t>(0x1400 + n), rpdo_identifier(n),
               static_cast<std::uint16_t>(0x3000 + n));
    append_pdo(table, static_cast<std::uint16_t>(0x1800 + n), 1U << 30 | tpdo_identifier(n),
               static_cast<std::uint16_t>(0x4000 + n));
  }
  std::ranges::sort(table, {}, [](const EntryDescription& row) { return row.index << 8 | row.sub_index; });
  return table;
}

class ManyPdos : public testing::Test {
 protected:
  void SetUp() override {
    node.start(now);
    says(fakes::frame_of("000#0105"));
    bus.take();
  }
  void says(const Frame& frame) { node.on_frame(frame, now); }
  std::int64_t value_of(std::uint16_t index) const {
    return dictionary.stored(*dictionary.find(index, 0).value());
  }
  void set(std::uint16_t index, std::int64_t value) { dictionary.set(*dictionary.find(index, 0).value(), value); }

  canopen::TimePoint now{1h};
  std::vector<EntryDescription> table = build();
  fakes::VectorBus bus;
  RecordingApplication application;
  canopen::Dictionary dictionary{table, 5};
  canopen::Node node{dictionary, {}, bus, application};
};

TEST_F(ManyPdos, AllGoWithOneSyncInTheOrderOfTheirNumbers) {
  for (std::uint16_t n = 0; n < kPdos; ++n) set(static_cast<std::uint16_t>(0x4000 + n), 1000 + n);

  says(fakes::frame_of("080#"));

  ASSERT_EQ(bus.sent.size(), kPdos);
  for (std::uint16_t n = 0; n < kPdos; ++n) {
    Frame expected = canopen::frame_under(tpdo_identifier(n), 4);
    canopen::store(expected.data.data(), std::uint32_t{1000U + n});
    EXPECT_EQ(bus.sent[n], expected) << n;
  }
}

TEST_F(ManyPdos, AllTakeTheirValuesWithOneSync) {
  for (std::uint16_t n = 0; n < kPdos; ++n) {
    Frame frame = canopen::frame_under(rpdo_identifier(n), 4);
    canopen::store(frame.data.data(), std::uint32_t{5000U + n});
    says(frame);
  }
  EXPECT_EQ(value_of(0x3000), 0);

  says(fakes::frame_of("080#"));

  for (std::uint16_t n = 0; n < kPdos; ++n) EXPECT_EQ(value_of(static_cast<std::uint16_t>(0x3000 + n)), 5000 + n);
  EXPECT_EQ(application.told.size(), kPdos + 2U) << "two changes of state, and every RPDO once";
}

TEST_F(ManyPdos, AreAllSubscribedTo) {
  const auto wanted = node.subscriptions();
  for (std::uint16_t n = 0; n < kPdos; ++n)
    EXPECT_EQ(std::ranges::count(wanted, rpdo_identifier(n), &canopen::Subscription::identifier), 1) << n;
}

}  // namespace
