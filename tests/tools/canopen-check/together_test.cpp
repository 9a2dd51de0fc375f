#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "tests/tools/canopen-check/slave/conformance_run.hpp"
#include "tools/canopen-check/core/run/snapshot.hpp"
#include "tools/canopen-zoo/slave/defects.hpp"

/// Uploads that are asked for several at a time.
namespace conformance_test {
namespace {

using canopen::Frame;
using conformance::Multiplexor;
using std::chrono::milliseconds;

const std::vector<Multiplexor> kEntries{{0x1000, 0}, {0x1001, 0}, {0x1018, 1}, {0x1018, 2}, {0x1018, 9},
                                        {0x1004, 0}, {0x1017, 0}, {0x1005, 0}, {0x6000, 0}, {0x1014, 0}};

/// A client of a slave that takes @p slowness.
struct Client {
  explicit Client(const Slowness& slowness = {}, const Defect& defect = {})
      : slave{defect}, slow{slave, slowness} {
    wire.add(slow);
  }

  /// The answers, and how long they took.
  std::vector<std::optional<Frame>> ask() {
    const canopen::TimePoint begin = wire.now();
    auto answers = sdo.ask_together(kEntries);
    time = wire.now() - begin;
    return answers;
  }

  Slave slave;
  SlowStation slow;
  SimulatedWire wire;
  conformance::Session session{wire, 5};
  conformance::SdoClient sdo{session, 0x605, 0x585, std::chrono::seconds{1}};
  canopen::Duration time{};
};

std::size_t count(const std::vector<std::optional<Frame>>& answers) {
  return static_cast<std::size_t>(
      std::ranges::count_if(answers, [](const auto& each) { return each.has_value(); }));
}

TEST(AskTogether, GivesTheAnswersOfSingleRequests) {
  Client client;
  const auto answers = client.ask();
  ASSERT_EQ(answers.size(), kEntries.size());
  for (std::size_t i = 0; i < kEntries.size(); ++i) {
    const auto whole = answers[i] ? conformance::whole_answer(*answers[i]) : std::nullopt;
    const conformance::SdoAnswer alone = client.sdo.upload(kEntries[i].index, kEntries[i].sub_index);
    ASSERT_TRUE(whole) << i;
    EXPECT_EQ(to_text(*whole), to_text(alone)) << i;
  }
}

TEST(AskTogether, TakesTheTimeOfOneAnswer) {
  Client client{{.sdo = milliseconds{20}}};
  (void)client.ask();  // it has learned that the server answers all of them
  EXPECT_EQ(count(client.ask()), kEntries.size());
  EXPECT_LT(client.time, milliseconds{25});
}

TEST(AskTogether, LeavesAServerAloneThatTakesOneRequestAtATime) {
  Client client{{.sdo = milliseconds{2}, .one_upload = true}};
  EXPECT_EQ(count(client.ask()), 0U);
  EXPECT_LT(client.time, milliseconds{100});
  const std::size_t sent = client.wire.sent();
  EXPECT_EQ(count(client.ask()), 0U);
  EXPECT_EQ(client.wire.sent(), sent);
}

TEST(AskTogether, OfNoEntryAsksNothing) {
  Client client;
  EXPECT_TRUE(client.sdo.ask_together({}).empty());
  EXPECT_EQ(client.wire.sent(), 0U);
}

TEST(AskTogether, GivesNothingBesideAFrameThatAnswersNoRequest) {
  bool disturbs = false;
  Client client{{}, {.outgoing = [&](Slave& slave, Frame& frame) {
                  if (disturbs && frame.id == kResponseOf5 && frame.data[1] == 0x18 && frame.data[3] == 1)
                    slave.say({.id = kResponseOf5, .length = 8, .data = {0x80, 0, 0, 0, 0, 0, 0, 8}});
                  return true;
                }}};
  ASSERT_EQ(count(client.ask()), kEntries.size());
  disturbs = true;
  EXPECT_EQ(count(client.ask()), 0U);
  EXPECT_TRUE(client.sdo.upload(0x1018, 1).done());
}

TEST(AskTogether, AsksASilentServerNoFurther) {
  Client client{{}, {.outgoing = [](Slave&, Frame&) { return false; }}};
  EXPECT_EQ(count(client.ask()), 0U);
  EXPECT_EQ(count(client.ask()), 0U);
  EXPECT_LT(client.wire.sent(), 3U);
}

TEST(Snapshot, IsReadWithoutOverlappingRequests) {
  Client client{{.sdo = milliseconds{2}, .one_upload = true}};
  const eds::Description right = right_description();
  conformance::Snapshot snapshot{client.sdo, right, full_settings()};
  EXPECT_GT(snapshot.size(), 50U);
  EXPECT_EQ(client.slow.overlapping(), 0U);
  EXPECT_TRUE(snapshot.restore().empty());
}

TEST(UndoLog, PutsBackWhatTheWayBackChanges) {
  // It forgets the objects of a mapping when their count is written to 0.
  Client client{{}, {.incoming = [](Slave& slave, Frame& frame) {
                  if (!writes(slave, frame, 0x1A00, 0) || value_of(frame) != 0) return true;
                  pretend(slave, frame);
                  slave.dictionary().set(*slave.dictionary().lookup(0x1A00, 1), 0);
                  return false;
                }}};
  const auto write = [&](std::uint16_t index, std::uint8_t sub_index, std::uint64_t value, std::size_t size) {
    ASSERT_TRUE(client.sdo.download(index, sub_index, eds::little_endian(value, size)).done());
  };
  const std::uint64_t object = client.sdo.upload(0x1A00, 1).number();
  write(0x1800, 1, client.sdo.upload(0x1800, 1).number() | conformance::kInvalid, 4);
  write(0x1A00, 0, 0, 1);
  write(0x1A00, 1, object, 4);
  conformance::UndoLog undo{client.sdo};
  EXPECT_TRUE(undo.write(0x1A00, 1, eds::little_endian(object, 4)).done());
  EXPECT_TRUE(undo.write(0x1A00, 0, std::array<std::uint8_t, 1>{1}).done());
  EXPECT_EQ(undo.restore(), std::vector<std::string>{});
  EXPECT_EQ(client.sdo.upload(0x1A00, 1).number(), object);
  EXPECT_EQ(client.sdo.upload(0x1A00, 0).number(), 0U);
}

TEST(WholeAnswer, IsAnAbortOrDataInOneFrame) {
  const auto data = conformance::whole_answer({.id = 0x585, .length = 8, .data = {0x4B, 0, 0x10, 0, 1, 2, 3, 4}});
  ASSERT_TRUE(data);
  EXPECT_EQ(data->data, (std::vector<std::uint8_t>{1, 2}));
  const auto abort = conformance::whole_answer({.id = 0x585, .length = 8, .data = {0x80, 0, 0x10, 0, 0, 0, 2, 6}});
  ASSERT_TRUE(abort);
  EXPECT_EQ(abort->abort_code, 0x06020000U);
  EXPECT_FALSE(conformance::whole_answer({.id = 0x585, .length = 8, .data = {0x41, 0, 0x10, 0, 9}}));
  EXPECT_FALSE(conformance::whole_answer({.id = 0x585, .length = 4, .data = {0x43, 0, 0x10, 0}}));
}

}  // namespace
}  // namespace conformance_test
