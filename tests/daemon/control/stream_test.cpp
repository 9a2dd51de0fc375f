// Frames and samples of a unit that go to another thread.
#include "daemon/server/stream_lines.hpp"
#include "tests/daemon/control/controlled_unit.hpp"
#include "tests/fakes/candump.hpp"

namespace axisd {
namespace {

using namespace std::chrono_literals;

class StreamedUnit : public ControlledUnit {
 protected:
  static std::shared_ptr<SampleBuffer> buffer_for(std::vector<std::string> signals, canopen::Duration period,
                                                  std::size_t room = 1000) {
    return std::make_shared<SampleBuffer>(SampleBuffer::Plan{std::move(signals), period}, room);
  }
  /// Its times, from the first one.
  static std::vector<canopen::Duration> times(const SampleBuffer& buffer) {
    std::vector<canopen::Duration> all;
    for (std::size_t at = 0; at < buffer.waiting(); ++at) all.push_back(buffer.time(at) - buffer.time(0));
    return all;
  }

  std::shared_ptr<FrameBuffer> frames = std::make_shared<FrameBuffer>();
};

TEST_F(StreamedUnit, TellsItsFramesBothWays) {
  answer("000#0105");
  ASSERT_TRUE(unit().frame_stream().begin(frames));
  answer("605#4018100400000000");
  ASSERT_EQ(frames->waiting(), 2U);
  EXPECT_EQ((*frames)[0].direction, Direction::Received);
  EXPECT_EQ(fakes::candump((*frames)[0].frame), "605#4018100400000000");
  EXPECT_EQ((*frames)[1].direction, Direction::Sent);
  EXPECT_EQ((*frames)[0].time, now() - unit().started());
  unit().frame_stream().end();
  answer("605#4018100400000000");
  EXPECT_EQ(frames->waiting(), 2U);
}

TEST_F(StreamedUnit, CountsFramesThatThereIsNoRoomFor) {
  ASSERT_TRUE(unit().frame_stream().begin(frames));
  for (std::size_t n = 0; n < FrameBuffer::kRoom / 2 + 10; ++n) answer("605#4018100400000000");
  EXPECT_EQ(frames->waiting(), FrameBuffer::kRoom);
  EXPECT_EQ(frames->take_lost(), 20U);
  EXPECT_EQ(frames->take_lost(), 0U);
  frames->release(1);
  answer("605#4018100400000000");
  EXPECT_EQ(frames->waiting(), FrameBuffer::kRoom);
  EXPECT_EQ((*frames)[FrameBuffer::kRoom - 1].direction, Direction::Received);
}

TEST_F(StreamedUnit, IsSampledAtExactTimesThoughItWasAtRest) {
  const auto buffer = buffer_for({"1/speed", "dc_voltage"}, 1ms);
  ASSERT_TRUE(unit().sample_stream().begin(buffer));
  run(104ms);
  EXPECT_GE(buffer->waiting(), 97U);
  const auto all = times(*buffer);
  for (std::size_t at = 0; at < all.size(); ++at) EXPECT_EQ(all[at], 1ms * at);
  EXPECT_EQ(buffer->value(0, 0), 0.0);
  EXPECT_NEAR(buffer->value(90, 1), 540.0, 10.0);
  EXPECT_EQ(buffer->take_lost(), 0U);
  const canopen::TimePoint cycle = device::node_time(unit().device().runner().clock().last());
  EXPECT_EQ((cycle - unit().started() - buffer->time(0)) % unit().device().cycle(), 0ns);
}

TEST_F(StreamedUnit, HasSeveralSamplesAtATime) {
  const auto fast = buffer_for({"1/speed"}, 1ms);
  const auto slow = buffer_for({"1/r0063", "1/torque"}, 10ms);
  ASSERT_TRUE(unit().sample_stream().begin(fast));
  ASSERT_TRUE(unit().sample_stream().begin(slow));
  run(204ms);
  EXPECT_GE(fast->waiting(), 197U);
  EXPECT_GE(slow->waiting(), 20U);
  EXPECT_EQ(fast->time(10), slow->time(1));
  unit().sample_stream().end(*fast);
  const std::size_t before = fast->waiting();
  run(100ms);
  EXPECT_EQ(fast->waiting(), before);
  EXPECT_GE(slow->waiting(), 30U);
}

TEST_F(StreamedUnit, IsSampledWhereItIsLate) {
  const auto buffer = buffer_for({"1/speed"}, 1ms);
  ASSERT_TRUE(unit().sample_stream().begin(buffer));
  run(20ms);
  const std::size_t before = buffer->waiting();
  unit().bus().turn(now() + 40ms, false);  // the cycles are made up for
  EXPECT_GE(buffer->waiting(), before + 37);
  EXPECT_EQ(buffer->take_lost(), 0U);
}

TEST_F(StreamedUnit, CountsSamplesThatItCouldNotTake) {
  const auto buffer = buffer_for({"1/speed"}, 1ms, 10);
  ASSERT_TRUE(unit().sample_stream().begin(buffer));
  run(40ms);
  EXPECT_EQ(buffer->waiting(), 10U);
  EXPECT_GE(buffer->take_lost(), 20U);
  buffer->release(10);
  unit().bus().turn(now() + 1s, false);  // the program was kept from running, and cycles are skipped
  EXPECT_GT(unit().device().skipped_cycles(), 0U);
  EXPECT_GE(buffer->take_lost(), 900U);
}

TEST_F(StreamedUnit, IsTracedAndSampledAtATime) {
  const auto buffer = buffer_for({"1/speed"}, 1ms);
  ASSERT_TRUE(unit().sample_stream().begin(buffer));
  result_of("trace.start", {{"signals", {"1/speed"}}, {"every", "cycle"}, {"samples", 5}});
  run(100ms);
  EXPECT_EQ(result_of("trace.status").at("phase"), "done");
  const std::size_t before = buffer->waiting();
  run(100ms);
  EXPECT_GE(buffer->waiting(), before + 96);
}

TEST_F(StreamedUnit, RefusesSignalsThatItDoesNotHave) {
  const auto outcome = unit().sample_stream().begin(buffer_for({"1/speed", "1/dance"}, 1ms));
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, trace::Problem::Kind::NotFound);
  EXPECT_EQ(outcome.error().key, "signals[1]");
}

TEST_F(StreamedUnit, TakesSoManySubscriptionsAndNoMore) {
  std::vector<std::shared_ptr<SampleBuffer>> all;
  for (std::size_t n = 0; n < SampleStream::kMost; ++n)
    ASSERT_TRUE(unit().sample_stream().begin(all.emplace_back(buffer_for({"1/speed"}, 1ms))));
  const auto outcome = unit().sample_stream().begin(buffer_for({"1/speed"}, 1ms));
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, trace::Problem::Kind::TooMuch);
  unit().sample_stream().end(*all.front());
  EXPECT_TRUE(unit().sample_stream().begin(all.front()));
}

TEST_F(StreamedUnit, MayBeListenedToByAllWhoCan) {
  ASSERT_TRUE(unit().frame_stream().begin(frames));
  ASSERT_TRUE(unit().sample_stream().begin(buffer_for({"1/speed"}, 1ms)));
  unit().tell_events(true);
  result_of("record.start", {{"name", "all"}});
  result_of("pdo.list", {{"watch", true}});
  result_of("trace.start", {{"signals", {"1/speed"}}, {"every", "cycle"}, {"samples", 5}});
  answer("000#0105");
  EXPECT_GT(frames->waiting(), 0U);
  result_of("record.stop");
}

TEST(StreamLines, TellFramesAsCandumpShowsThem) {
  FrameBuffer buffer;
  buffer.add({12345678us, Direction::Received, fakes::frame_of("205#0F00")});
  buffer.add({12346001999ns, Direction::Sent, fakes::frame_of("185#3716")});
  buffer.add({1s, Direction::Received, {.id = 0x205, .remote = true}});
  buffer.add({13s, Direction::Sent, {.id = 0x12ABCDEF, .length = 1, .extended = true, .data = {0x5A}}});
  const auto lines = frame_lines("vcan0/5", buffer);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines.front(), R"({"frames":{"unit":"vcan0/5","t":13.000000,"frames":["12.345678 R 205#0F00",)"
                           R"("12.346001 S 185#3716","1.000000 R 205#R","13.000000 S 12ABCDEF#5A"],"lost":0}})"
                           "\n");
  EXPECT_TRUE(frame_lines("vcan0/5", buffer).empty());
}

TEST(StreamLines, AreNoLongerThanALineMayBe) {
  FrameBuffer buffer;
  for (std::size_t n = 0; n < FrameBuffer::kRoom + 3; ++n)
    buffer.add({100000h, Direction::Received, {.id = 0x1FFFFFFF, .length = 8, .extended = true, .data = {1, 2}}});
  std::size_t frames = 0;
  std::uint64_t lost = 0;
  for (const std::string& line : frame_lines(std::string(100, '"'), buffer)) {
    EXPECT_LE(line.size(), 65536U);
    const auto notice = nlohmann::json::parse(line).at("frames");
    frames += notice.at("frames").size();
    lost += notice.at("lost").get<std::uint64_t>();
  }
  EXPECT_EQ(frames, FrameBuffer::kRoom);
  EXPECT_EQ(lost, 3U);
}

TEST(StreamLines, TellSamplesBySignal) {
  SampleBuffer buffer{{.signals = {"a", "b"}, .period = 1ms}, 3};
  for (int n = 0; n < 4; ++n) {
    const auto values = buffer.next(1s + 1ms * n);
    if (values.empty()) break;
    values[0] = 0.1 * n;
    values[1] = n == 1 ? std::nan("") : 7.0;
    buffer.publish();
  }
  const auto lines = sample_lines("vcan0/5", buffer);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines.front(), R"({"samples":{"unit":"vcan0/5","t":[1.000000,1.001000,1.002000],)"
                           R"("values":[[0,0.1,0.2],[7,null,7]],"lost":1}})"
                           "\n");
}

TEST(StreamLines, OfManySignalsAreSeveral) {
  SampleBuffer buffer{{.signals = std::vector<std::string>(32, "x"), .period = 1ms}, 1000};
  for (int n = 0; n < 1000; ++n) {
    std::ranges::fill(buffer.next(100000h + 1ms * n), -1.2345678901234567e-300);
    buffer.publish();
  }
  std::size_t samples = 0;
  for (const std::string& line : sample_lines("vcan0/5", buffer)) {
    EXPECT_LE(line.size(), 65536U);
    samples += nlohmann::json::parse(line).at("samples").at("t").size();
  }
  EXPECT_EQ(samples, 1000U);
}

}  // namespace
}  // namespace axisd
