#include "tools/canopen-check/core/sdo_client.hpp"

#include <gtest/gtest.h>

#include "tests/tools/canopen-check/slave/conformance_run.hpp"

namespace conformance_test {
namespace {

using canopen::Frame;
using conformance::SdoAnswer;
using Bytes = std::vector<std::uint8_t>;

/// A client of a slave.
struct Client {
  explicit Client(const Defect& defect = {}) : slave{defect} { wire.add(slave); }

  Slave slave;
  SimulatedWire wire;
  conformance::Session session{wire, 5};
  conformance::SdoClient sdo{session, 0x605, 0x585, std::chrono::seconds{1}};
};

TEST(SdoClient, ReadsAndWritesDataOfEveryLength) {
  for (std::size_t length = 1; length <= 40; ++length) {
    Client client;
    Bytes bytes(length);
    for (std::size_t i = 0; i < length; ++i) bytes[i] = static_cast<std::uint8_t>('a' + i % 26);
    ASSERT_TRUE(client.sdo.download(kDocument, 0, bytes).done()) << length;
    const SdoAnswer answer = client.sdo.upload(kDocument, 0);
    ASSERT_TRUE(answer.done()) << length;
    EXPECT_EQ(answer.data, bytes) << length;
  }
}

TEST(SdoClient, TellsTheAbortOfTheServer) {
  Client client;
  const SdoAnswer answer = client.sdo.upload(0x1000, 1);
  EXPECT_TRUE(answer.aborted());
  EXPECT_EQ(to_text(answer), "abort 06090011h (no such sub-index)");
}

TEST(SdoClient, TellsThatNobodyAnswers) {
  Client client{{.outgoing = [](auto&&...) { return false; }}};
  EXPECT_EQ(to_text(client.sdo.upload(0x1000, 0)), "no answer");
}

/// A slave whose answers have their first byte or their multiplexer changed.
Defect changed(std::size_t byte, std::uint8_t value) {
  return {.outgoing = [=](Slave&, canopen::Frame& frame) {
    if (frame.id == 0x585) frame.data[byte] = value;
    return true;
  }};
}

TEST(SdoClient, TakesNoAnswerThatIsNoneOfTheProtocol) {
  EXPECT_EQ(to_text(Client{changed(0, 0x60)}.sdo.upload(0x1000, 0)),
            "the answer to an upload is 585#6000100000000000");
  EXPECT_EQ(Client{changed(3, 7)}.sdo.upload(0x1000, 0).kind, SdoAnswer::Kind::Malformed);
  EXPECT_EQ(Client{changed(0, 0x43)}.sdo.download(kLimited, 0, Bytes{1, 0}).kind, SdoAnswer::Kind::Malformed);
  EXPECT_EQ(Client{changed(1, 0)}.sdo.download(kLimited, 0, Bytes{1, 0}).kind, SdoAnswer::Kind::Malformed);
}

TEST(SdoClient, EndsAnUploadThatNeverEnds) {
  // Every segment says that more follow.
  Client client{{.outgoing = [](Slave& slave, canopen::Frame& frame) {
    if (frame.id == 0x585 && (frame.data[0] & 0xE0U) == 0) frame.data[0] &= 0xFEU;
    (void)slave;
    return true;
  }}};
  EXPECT_FALSE(client.sdo.upload(kText, 0).done());
}

/// Answers every request for a segment by @p answer.
Defect with_segments(std::function<void(Frame&)> answer) {
  return {.incoming = [answer](Slave& slave, Frame& frame) {
    if (frame.id != 0x605 || (frame.data[0] & 0xE0U) != 0x60) return true;
    Frame segment{.id = 0x585, .length = 8, .data = {static_cast<std::uint8_t>(frame.data[0] & 0x10U)}};
    answer(segment);
    slave.say(segment);
    return false;
  }};
}

TEST(SdoClient, EndsAnUploadOfEmptySegments) {
  Client client{with_segments([](Frame& segment) { segment.data[0] |= 7U << 1U; })};
  const SdoAnswer answer = client.sdo.upload(kText, 0);
  EXPECT_EQ(to_text(answer), "an upload does not end: 8 segments without data");
  EXPECT_LT(client.wire.sent(), 20U);
}

TEST(SdoClient, EndsAnUploadThatGoesBeyondTheAnnouncedSize) {
  Client client{with_segments([](Frame&) {})};
  const SdoAnswer answer = client.sdo.upload(0x1008, 0);
  EXPECT_EQ(to_text(answer), "an upload does not end after the 11 bytes that are announced");
  EXPECT_LT(client.wire.sent(), 20U);
}

TEST(SdoClient, ReadsNoMoreThanItTakes) {
  Client client{{.outgoing = [](Slave&, Frame& frame) {
    if (frame.id == 0x585 && frame.data[0] == 0x41) frame.data[6] = 0x11;  // 1 MiB and more
    return true;
  }}};
  EXPECT_EQ(client.sdo.upload(0x1008, 0).kind, SdoAnswer::Kind::Cut);
  EXPECT_EQ(client.wire.sent(), 2U);  // the request, and the abort
}

TEST(SdoClient, EndsAnUploadOfTimeWithoutEnd) {
  Defect endless = with_segments([](Frame&) {});
  endless.outgoing = [](Slave&, Frame& frame) {
    if (frame.id == 0x585 && frame.data[0] == 0x41) frame.data = {0x40, 0x08, 0x10};  // no size
    return true;
  };
  Client client{endless};
  const canopen::TimePoint begin = client.wire.now();
  EXPECT_EQ(client.sdo.upload(0x1008, 0).kind, SdoAnswer::Kind::Cut);
  EXPECT_LT(client.wire.now() - begin, conformance::kLongestTransferTime + std::chrono::seconds{2});
}

TEST(SdoClient, TakesTheAnswerThatFitsAndNoOther) {
  // A late answer to another request, one of another entry, and an abort of none.
  Client client{{.incoming = [](Slave& slave, Frame& frame) {
    if (frame.id != 0x605 || frame.data[0] != 0x40) return true;
    slave.say({.id = 0x585, .length = 8, .data = {0x60, 0x17, 0x10}});
    slave.say({.id = 0x585, .length = 8, .data = {0x43, 0x01, 0x10, 0x00, 0xAA}});
    slave.say({.id = 0x585, .length = 8, .data = {0x80, 0, 0, 0, 0, 0, 0, 8}});
    return true;
  }}};
  const SdoAnswer answer = client.sdo.upload(0x1018, 1);
  ASSERT_TRUE(answer.done()) << to_text(answer);
  EXPECT_EQ(answer.number(), 0x2AU);
  EXPECT_EQ(client.sdo.strays(), 1U);
}

TEST(SdoClient, TakesNoAbortOfAnotherEntryForAnAnswer) {
  Client client{{.outgoing = [](Slave&, Frame& frame) {
    if (frame.id == 0x585) frame.data = {0x80, 0, 0, 0, 0, 0, 0, 8};
    return true;
  }}};
  EXPECT_EQ(to_text(client.sdo.upload(0x1018, 1)),
            "no answer to it, only 585#8000000000000008, which names 0000h:00");
}

TEST(SdoClient, TakesEveryAbortOfAServerThatNeverNamesTheEntry) {
  Client client{{.outgoing = [](Slave&, Frame& frame) {
    if (frame.id == 0x585 && frame.data[0] == 0x80) frame.data[1] = frame.data[2] = frame.data[3] = 0;
    return true;
  }}};
  client.sdo.learn_aborts();
  EXPECT_EQ(to_text(client.sdo.upload(0x1000, 1)), "abort 06090011h (no such sub-index)");
}

/// A bus on which there is always a frame of somebody else to take.
class FloodedWire final : public conformance::Wire {
 public:
  bool send(const Frame&) override { return true; }
  std::optional<conformance::TimedFrame> receive(canopen::TimePoint) override {
    now_ += std::chrono::microseconds{50};
    return conformance::TimedFrame{.time = now_, .frame = {.id = 0x1A0, .length = 8}};
  }
  canopen::TimePoint now() override { return now_; }
  bool up() const override { return true; }

 private:
  canopen::TimePoint now_{std::chrono::hours{1}};
};

TEST(SdoClient, GivesUpOnABusThatNeverFallsSilent) {
  FloodedWire wire;
  conformance::Session session{wire, 5};
  conformance::SdoClient sdo{session, 0x605, 0x585, std::chrono::seconds{1}};
  const canopen::TimePoint begin = wire.now();
  EXPECT_EQ(to_text(sdo.upload(0x1000, 0)), "no answer");
  EXPECT_LT(wire.now() - begin, std::chrono::seconds{5});
}

TEST(Hexadecimal, OfMuchDataIsShort) {
  EXPECT_EQ(conformance::hexadecimal(Bytes(3, 0xAB)), "ABABAB");
  EXPECT_TRUE(conformance::hexadecimal(Bytes(1000, 0xAB)).ends_with("AB... (1000 bytes)"));
  EXPECT_LT(conformance::hexadecimal(Bytes(1000, 0xAB)).size(), 100U);
}

}  // namespace
}  // namespace conformance_test
