#include "can/hub/trunk/message.hpp"

#include <random>

#include <gtest/gtest.h>

#include "tests/can/hub/told.hpp"

namespace {

using hub::trunk::Header;
using hub::trunk::Kind;
using hub::trunk::Reader;
using hub::trunk::Writer;

std::vector<std::byte> copy(std::span<const std::byte> bytes) {
  return {bytes.begin(), bytes.end()};
}

TEST(TrunkMessage, ComesOutAsItWentIn) {
  Writer writer;
  writer.begin({.hub = 0x01020304, .epoch = 5, .origin = 6, .counter = 0x0102030405060708, .seen = -9});
  writer.add({told::wire("123#0102030405060708"), 0xFFFFF});
  writer.add({told::wire("1ABCDEF0#R"), 1});
  const auto bytes = copy(writer.finish());
  std::string_view problem;

  const auto reader = Reader::read(bytes, problem);

  ASSERT_TRUE(reader) << problem;
  EXPECT_EQ(bytes.size(), hub::trunk::kHeaderSize + 2 * hub::trunk::kFrameSize);
  EXPECT_EQ(reader->header().hub, 0x01020304U);
  EXPECT_EQ(reader->header().epoch, 5U);
  EXPECT_EQ(reader->header().origin, 6U);
  EXPECT_EQ(reader->header().counter, 0x0102030405060708U);
  EXPECT_EQ(reader->header().seen, -9);
  ASSERT_EQ(reader->frames(), 2U);
  EXPECT_EQ(told::text_of(reader->frame(0).frame), "123#0102030405060708");
  EXPECT_EQ(reader->frame(0).number, 0xFFFFFU);
  EXPECT_EQ(told::text_of(reader->frame(1).frame), "1ABCDEF0#R");
}

TEST(TrunkMessage, HasTheNameOfABeat) {
  Writer writer;
  writer.begin({.kind = Kind::Beat, .hub = 1});
  writer.add_name(std::string(100, 'x'));
  const auto bytes = copy(writer.finish());
  std::string_view problem;

  const auto reader = Reader::read(bytes, problem);

  ASSERT_TRUE(reader) << problem;
  EXPECT_EQ(reader->name(), std::string(hub::trunk::kLongestName, 'x'));
  EXPECT_EQ(reader->frames(), 0U);
}

TEST(TrunkMessage, HasTheFrameThatIsGrantedAndItsTime) {
  Writer writer;
  writer.begin({.kind = Kind::Granted, .hub = 1, .counter = 7, .term = 0x01020304, .detail = 0x05060708});
  writer.add_granted({told::wire("123#01"), 2}, -5);
  const auto bytes = copy(writer.finish());
  std::string_view problem;

  const auto reader = Reader::read(bytes, problem);

  ASSERT_TRUE(reader) << problem;
  EXPECT_EQ(bytes.size(), hub::trunk::kHeaderSize + hub::trunk::kTimeSize + hub::trunk::kFrameSize);
  EXPECT_EQ(reader->header().term, 0x01020304U);
  EXPECT_EQ(reader->header().station(), 0x05060708U);
  ASSERT_EQ(reader->frames(), 1U);
  EXPECT_EQ(told::text_of(reader->frame(0).frame), "123#01");
  EXPECT_EQ(reader->frame(0).number, 2U);
  EXPECT_EQ(reader->time(9), -5);
}

TEST(TrunkMessage, OfAnArbiterHasATerm) {
  for (const Kind kind : {Kind::ArbiterBeat, Kind::Lost}) {
    Writer writer;
    std::string_view problem;
    writer.begin({.kind = kind, .hub = 1, .term = 1});
    EXPECT_TRUE(Reader::read(copy(writer.finish()), problem)) << problem;
    writer.begin({.kind = kind, .hub = 1});
    EXPECT_FALSE(Reader::read(copy(writer.finish()), problem));
    EXPECT_EQ(problem, "comes from no arbiter");
  }
}

/// A message of each form that has frames.
class TrunkMessageOfAnyBytes : public testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, TrunkMessageOfAnyBytes, testing::Values(Kind::Frames, Kind::Granted));

TEST_P(TrunkMessageOfAnyBytes, IsReadOrRefused) {
  const unsigned seed = told::seed();
  SCOPED_TRACE(seed);
  std::mt19937 random{seed};
  Writer writer;
  writer.begin({.kind = GetParam(), .hub = 1, .term = 1});
  if (GetParam() == Kind::Granted) writer.add_granted({told::wire("123#01"), 1}, 1);
  for (int i = 0; GetParam() == Kind::Frames && i < 3; ++i) writer.add({told::wire("123#01"), 1});
  const auto good = copy(writer.finish());
  unsigned refused = 0;

  for (int i = 0; i < 20000; ++i) {
    auto bytes = good;
    bytes[random() % bytes.size()] = static_cast<std::byte>(random());
    bytes.resize(random() % 4 == 0 ? random() % bytes.size() : bytes.size());
    std::string_view problem;
    const auto reader = Reader::read(bytes, problem);
    if (!reader) ++refused;
    EXPECT_EQ(problem.empty(), reader.has_value());
    for (std::size_t frame = 0; reader && frame < reader->frames(); ++frame)
      EXPECT_LE(reader->frame(frame).frame.can_dlc, 8);
  }

  EXPECT_GT(refused, 4000U);
}

}  // namespace
