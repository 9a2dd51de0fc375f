#include "tools/canopen-check/core/sdo_client.hpp"

#include <gtest/gtest.h>

#include "tests/tools/canopen-check/slave.hpp"

namespace conformance_test {
namespace {

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

}  // namespace
}  // namespace conformance_test
