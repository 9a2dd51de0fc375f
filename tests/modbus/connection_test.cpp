#include "modbus/connection.hpp"

#include <random>

#include <gtest/gtest.h>

#include "tests/modbus/fake_bank.hpp"
#include "tests/modbus/hexadecimal.hpp"

namespace modbus {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Client {
  /// What the connection takes of @p bytes in pieces of @p piece at most, and all that it answers.
  Bytes exchange(std::span<const std::uint8_t> bytes, std::size_t piece) {
    Bytes answers;
    while (!bytes.empty()) {
      const std::span<std::uint8_t> room = connection.room();
      if (room.empty() && !connection.has_request() && connection.to_send().empty()) break;
      const std::size_t taken = std::min({bytes.size(), room.size(), piece});
      std::ranges::copy(bytes.first(taken), room.begin());
      connection.on_received(taken);
      bytes = bytes.subspan(taken);
      collect(answers);
    }
    collect(answers);
    return answers;
  }
  void collect(Bytes& answers) {
    do {
      connection.answer(1);
      const auto part = connection.to_send();
      answers.insert(answers.end(), part.begin(), part.end());
      connection.on_sent(part.size());
    } while (connection.has_request());
  }
  std::string ask(std::string_view text, std::size_t piece = 4096) {
    return hexadecimal(exchange(bytes_of(text), piece));
  }

  FakeBank bank;
  Counters counters;
  Connection connection{bank, counters};
};

constexpr std::string_view kRead = "0001 0000 0006 11 03 0000 0001 ";
constexpr std::string_view kReadAnswer =
    "000100000005110302"
    "0041";
constexpr std::string_view kWrite = "0203 0000 0006 FF 06 0063 5566 ";
constexpr std::string_view kWriteAnswer = "020300000006FF0600635566";

TEST(Connection, RepeatsTransactionAndUnit) {
  Client client;
  EXPECT_EQ(client.ask(kRead), kReadAnswer);
  EXPECT_EQ(client.ask(kWrite), kWriteAnswer);
}

TEST(Connection, AnswersRequestsOfOneSegmentInTheirOrder) {
  const std::string requests = std::string{kRead} + std::string{kWrite} + std::string{kRead};
  const std::string answers = std::string{kReadAnswer} + std::string{kWriteAnswer} + std::string{kReadAnswer};
  EXPECT_EQ(Client{}.ask(requests), answers);
  EXPECT_EQ(Client{}.ask(requests, 1), answers);
  EXPECT_EQ(Client{}.ask(requests, 13), answers);
}

TEST(Connection, WaitsForTheRestOfARequest) {
  Client client;
  EXPECT_EQ(client.ask(kRead.substr(0, 20)), "");
  EXPECT_FALSE(client.connection.is_over());
  EXPECT_EQ(client.ask(kRead.substr(20)), kReadAnswer);
}

TEST(Connection, EndsWithWhatIsNoFrame) {
  for (const std::string_view broken : {"0001 0001 0006 11 03 0000 0001", "0001 0000 0001 11", "0001 0000 0000",
                                        "0001 0000 00FF 11 03", "FFFF FFFF", "4745 5420 2F20 4854 5450"}) {
    Client client;
    EXPECT_EQ(client.ask(std::string{kRead} + std::string{broken}), kReadAnswer) << broken;
    EXPECT_TRUE(client.connection.is_over()) << broken;
  }
}

TEST(Connection, TakesFramesOfAllLengths) {
  Client client;
  EXPECT_EQ(client.ask("0001 0000 0002 11 07"),
            "0001000000031187"
            "01");
  EXPECT_EQ(client.ask("0001 0000 00FE 11 07" + std::string(2 * 252, '0')),
            "0001000000031187"
            "01");
  EXPECT_FALSE(client.connection.is_over());
}

TEST(Connection, AnswersWhatIsWholeWhenTheClientSendsNoMore) {
  Client client;
  const Bytes request = bytes_of(std::string{kRead} + "0002 0000 0006 11 03");
  std::ranges::copy(request, client.connection.room().begin());
  client.connection.on_received(request.size());
  client.connection.on_end();

  EXPECT_FALSE(client.connection.is_over());
  client.connection.answer(9);

  EXPECT_EQ(hexadecimal(client.connection.to_send()), kReadAnswer);
  EXPECT_FALSE(client.connection.is_over());
  client.connection.on_sent(kReadAnswer.size() / 2);
  EXPECT_TRUE(client.connection.is_over());
}

TEST(Connection, TakesNoMoreWhileAnswersAreLeftUnread) {
  Client client;
  std::size_t taken = 0;
  for (std::size_t i = 0; i < 1000 && !client.connection.room().empty(); ++i) {
    const Bytes request = bytes_of("0001 0000 0006 11 03 0000 007D");
    std::ranges::copy(request, client.connection.room().begin());
    client.connection.on_received(request.size());
    client.connection.answer(1);
    ++taken;
  }
  EXPECT_LT(taken, 10U);
  EXPECT_TRUE(client.connection.room().empty());

  client.connection.on_sent(client.connection.to_send().size());

  EXPECT_FALSE(client.connection.room().empty());
  EXPECT_EQ(client.counters.requests, taken);
}

TEST(Connection, CountsRequestsAndExceptions) {
  Client client;
  client.ask(kRead);
  client.ask("0001 0000 0002 11 07");
  EXPECT_EQ(client.counters.requests, 2U);
  EXPECT_EQ(client.counters.exceptions, 1U);
}

/// A stream that begins as requests do and goes wrong somewhere.
Bytes random_stream(std::mt19937& random) {
  const auto below = [&](unsigned end) { return std::uniform_int_distribution<unsigned>{0, end - 1}(random); };
  Bytes stream;
  for (unsigned frame = 0; frame < 20; ++frame) {
    const unsigned length = below(20) == 0 ? below(300) : 2 + below(253);
    for (const unsigned byte :
         {below(256), below(256), below(100) == 0 ? 1U : 0U, 0U, length >> 8U, length & 0xFFU})
      stream.push_back(static_cast<std::uint8_t>(byte));
    constexpr std::array<std::uint8_t, 4> kCodes{3, 6, 16, 43};
    for (unsigned i = 0; i < length; ++i)
      stream.push_back(i == 1 ? kCodes[below(4)]
                              : static_cast<std::uint8_t>(below(8) < 6 ? below(4) : below(256)));
  }
  return stream;
}

TEST(Connection, AnswersAnyBytesAlikeHoweverTheyAreCut) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random{seed};
  for (int round = 0; round < 300; ++round) {
    const Bytes stream = random_stream(random);
    Client whole, bytewise, cut;
    const Bytes answers = whole.exchange(stream, stream.size());
    ASSERT_EQ(bytewise.exchange(stream, 1), answers);
    ASSERT_EQ(cut.exchange(stream, 1 + random() % 300), answers);
    ASSERT_EQ(bytewise.bank.written, whole.bank.written);

    std::uint64_t frames = 0;
    for (std::span<const std::uint8_t> rest = answers; !rest.empty(); ++frames) {
      const auto frame = first_frame(rest);
      ASSERT_TRUE(frame && *frame);
      rest = rest.subspan((*frame)->bytes);
    }
    EXPECT_EQ(frames, whole.counters.requests);
  }
}

}  // namespace
}  // namespace modbus
