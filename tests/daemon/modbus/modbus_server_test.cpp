#include "daemon/modbus/modbus_server.hpp"

#include <random>

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/resource.h>

#include "daemon/base/instance_error.hpp"
#include "tests/daemon/modbus/tcp_client.hpp"
#include "tests/modbus/fake_bank.hpp"
#include "tests/modbus/hexadecimal.hpp"

namespace axisd {
namespace {

constexpr ModbusSettings free_port() {
  return {.address = "127.0.0.1", .port = 0};
}

struct Served : testing::Test {
  TcpClient client() {
    return TcpClient{server.place(), [this] { work(); }};
  }
  /// The server does what there is to do.
  void work() {
    for (pollfd ready{server.descriptor(), POLLIN, 0}; ::poll(&ready, 1, 0) == 1;) server.handle();
  }

  modbus::FakeBank bank;
  ModbusServer server{free_port(), bank};
};

const std::string kRead = "0001 0000 0006 11 03 0000 0001";
const std::string kReadAnswer = "0001000000051103020041";
constexpr std::size_t kReadBytes = 11;
const std::string kWrite = "0001 0000 0006 11 06 0063 0001";
constexpr std::size_t kWriteBytes = 12;

TEST_F(Served, AnswersClients) {
  TcpClient one = client(), other = client();
  EXPECT_EQ(one.ask(kRead, kReadBytes), kReadAnswer);
  EXPECT_EQ(other.ask(kRead, kReadBytes), kReadAnswer);
  EXPECT_EQ(server.clients(), 2U);
  EXPECT_EQ(server.counters().requests, 2U);
}

TEST_F(Served, AnswersSeveralRequestsOfASegmentInTheirOrder) {
  TcpClient one = client();
  std::string requests, answers;
  for (unsigned i = 0; i < 100; ++i) {
    requests += fmt::format("{:04X} 0000 0006 11 03 0000 0001", i);
    answers += fmt::format("{:04X}", i) + kReadAnswer.substr(4);
  }
  EXPECT_EQ(one.ask(requests, 100 * kReadBytes), answers);
}

TEST_F(Served, AnswersARequestThatComesByteByByte) {
  TcpClient one = client(), other = client();
  const std::vector<std::uint8_t> request = modbus::bytes_of(kRead);
  for (const std::uint8_t byte : request) {
    one.send(modbus::hexadecimal({&byte, 1}));
    EXPECT_EQ(other.ask(kRead, kReadBytes), kReadAnswer);
  }
  EXPECT_EQ(one.receive(kReadBytes), kReadAnswer);
}

TEST_F(Served, EndsTheConnectionOfOneWhoSendsGarbage) {
  TcpClient one = client(), other = client();
  EXPECT_EQ(one.ask(kRead, kReadBytes), kReadAnswer);
  one.send("474554202F20485454502F312E310D0A0D0A");
  EXPECT_TRUE(one.is_closed());
  EXPECT_EQ(other.ask(kRead, kReadBytes), kReadAnswer);
}

TEST_F(Served, ClosesTheNinthConnectionAtOnce) {
  std::vector<TcpClient> eight;
  for (int i = 0; i < 8; ++i) {
    eight.push_back(client());
    EXPECT_EQ(eight.back().ask(kRead, kReadBytes), kReadAnswer);
  }
  TcpClient ninth = client();
  EXPECT_TRUE(ninth.is_closed());
  EXPECT_EQ(server.turned_away(), 1U);
  EXPECT_EQ(eight.front().ask(kRead, kReadBytes), kReadAnswer);

  eight.pop_back();
  while (server.clients() == 8) work();
  EXPECT_EQ(client().ask(kRead, kReadBytes), kReadAnswer);
}

TEST_F(Served, AnswersOneWhoSendsNoMore) {
  TcpClient one = client();
  one.send(kRead + kRead.substr(0, 8));
  one.end();
  EXPECT_EQ(one.receive(kReadBytes), kReadAnswer);
  EXPECT_TRUE(one.is_closed());
  EXPECT_EQ(server.clients(), 0U);
}

TEST_F(Served, KeepsAnswersForOneWhoReadsSlowly) {
  TcpClient slow{server.place(), [this] { work(); }, 4096}, other = client();
  const std::vector<std::uint8_t> request = modbus::bytes_of("0001 0000 0006 11 03 0000 007D");
  std::vector<std::uint8_t> requests;
  for (int i = 0; i < 100; ++i) requests.insert(requests.end(), request.begin(), request.end());
  std::size_t sent = 0, skipped = 0;
  for (int idle = 0; idle < 100;) {  // until the server takes no more
    skipped = sent % requests.size();
    const std::size_t part =
        slow.send_some({requests.begin() + static_cast<std::ptrdiff_t>(skipped), requests.end()});
    sent += part;
    idle = part == 0 ? idle + 1 : 0;
    EXPECT_EQ(other.ask(kRead, kReadBytes), kReadAnswer);
  }
  const std::uint64_t answered = server.counters().requests;
  EXPECT_EQ(other.ask(kRead, kReadBytes), kReadAnswer);
  EXPECT_EQ(server.counters().requests, answered + 1) << "what is not read is not answered";

  constexpr std::size_t kAnswerBytes = 259;
  const std::size_t whole = sent / request.size();
  std::string answers;
  while (answers.size() < 2 * kAnswerBytes * whole) {
    work();
    answers += slow.receive_some();
  }
  const std::string answer = answers.substr(0, 2 * kAnswerBytes);
  for (std::size_t i = 0; i < whole; ++i)
    ASSERT_EQ(answers.substr(i * 2 * kAnswerBytes, 2 * kAnswerBytes), answer);
}

TEST_F(Served, DoesNothingForOneWhoIsSilent) {
  TcpClient silent = client(), half = client();
  half.send(kRead.substr(0, 10));
  work();
  for (int i = 0; i < 3; ++i) {
    pollfd ready{server.descriptor(), POLLIN, 0};
    EXPECT_EQ(::poll(&ready, 1, 0), 0);
  }
  EXPECT_EQ(server.clients(), 2U);
}

TEST_F(Served, NoticesWhenOneWhoWroteProcessDataIsGone) {
  for (const bool reset : {false, true}) {
    bank.lost = 0;
    TcpClient reader = client(), writer = client();
    reader.ask(kRead, kReadBytes);
    writer.ask(kWrite, kWriteBytes);
    reader.reset();
    while (server.clients() == 2) work();
    EXPECT_EQ(bank.lost, 0);

    reset ? writer.reset() : writer.end();
    while (server.clients() == 1) work();
    EXPECT_EQ(bank.lost, 1);
  }
}

TEST_F(Served, ServesNobodyWhereThereIsNothingBehindTheRegisters) {
  TcpClient one = client();
  EXPECT_EQ(one.ask(kRead, kReadBytes), kReadAnswer);
  bank.available = false;
  one.send(kRead);
  EXPECT_TRUE(one.is_closed());
  EXPECT_TRUE(client().is_closed());

  bank.available = true;
  EXPECT_EQ(client().ask(kRead, kReadBytes), kReadAnswer);
}

TEST_F(Served, TurnsAwayWhomThereIsNoDescriptorFor) {
  TcpClient known = client();
  EXPECT_EQ(known.ask(kRead, kReadBytes), kReadAnswer);
  {
    TcpClient late = client();  // accepted by the kernel alone
    std::vector<os::Descriptor> all;
    rlimit before{}, narrow{};
    ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
    narrow = {.rlim_cur = 64, .rlim_max = before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &narrow), 0);
    while (all.empty() || all.back()) all.emplace_back(::open("/dev/null", O_RDONLY | O_CLOEXEC));
    EXPECT_TRUE(late.is_closed());
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
  }
  pollfd ready{server.descriptor(), POLLIN, 0};
  EXPECT_EQ(::poll(&ready, 1, 0), 0) << "nothing wakes the loop over and over";
  EXPECT_EQ(known.ask(kRead, kReadBytes), kReadAnswer);
  EXPECT_EQ(client().ask(kRead, kReadBytes), kReadAnswer);
}

TEST_F(Served, SurvivesAnyBytes) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random{seed};
  std::vector<TcpClient> clients;
  for (int round = 0; round < 2000; ++round) {
    if (clients.size() < 8) clients.push_back(client());
    TcpClient& one = clients[random() % clients.size()];
    std::vector<std::uint8_t> bytes = modbus::bytes_of(kRead);
    bytes.resize(random() % 40);
    for (std::uint8_t& byte : bytes)
      if (random() % 16 == 0) byte = static_cast<std::uint8_t>(random());
    one.send_some(bytes);
    work();
    one.receive_some();
    if (random() % 8 == 0) clients.erase(clients.begin() + static_cast<std::ptrdiff_t>(random() % clients.size()));
  }
  clients.clear();
  while (server.clients() != 0) work();
  // Random bytes may be a request that writes a register.
  constexpr std::size_t kDigitsOfTheValue = 4;
  std::string answer = client().ask(kRead, kReadBytes), expected{kReadAnswer};
  answer.resize(answer.size() - kDigitsOfTheValue);
  expected.resize(expected.size() - kDigitsOfTheValue);
  EXPECT_EQ(answer, expected);
}

std::string error_of(const ModbusSettings& settings) {
  modbus::FakeBank bank;
  try {
    const ModbusServer server{settings, bank};
  } catch (const InstanceError& error) {
    return error.what();
  }
  return "";
}

TEST_F(Served, SaysThatAPortIsTaken) {
  const auto port = static_cast<std::uint16_t>(std::stoi(server.place().substr(server.place().rfind(':') + 1)));
  EXPECT_EQ(error_of({.address = "127.0.0.1", .port = port}),
            fmt::format("modbus 127.0.0.1:{}: Address already in use: expected a port that nobody serves", port));
}

TEST(ModbusServer, SaysThatAnAddressIsNotOfTheMachine) {
  EXPECT_EQ(error_of({.address = "192.0.2.1", .port = 1502}),
            "modbus 192.0.2.1:1502: Cannot assign requested address: expected an address of this machine");
}

TEST(ModbusServer, ListensAtAddressesOfBothKinds) {
  modbus::FakeBank bank;
  ModbusServer server{{.address = "::1", .port = 0}, bank};
  EXPECT_TRUE(server.place().starts_with("[::1]:"));
  TcpClient client{server.place(), [&] { server.handle(); }};
  EXPECT_EQ(client.ask(kRead, kReadBytes), kReadAnswer);
}

TEST(ModbusServer, CanBeStartedAgainAtOnce) {
  modbus::FakeBank bank;
  ModbusSettings settings = free_port();
  {
    ModbusServer server{settings, bank};
    settings.port = static_cast<std::uint16_t>(std::stoi(server.place().substr(server.place().rfind(':') + 1)));
    TcpClient client{server.place(), [&] { server.handle(); }};
    EXPECT_EQ(client.ask(kRead, kReadBytes), kReadAnswer);
  }
  EXPECT_EQ(error_of(settings), "");
}

}  // namespace
}  // namespace axisd
