// Frames on the time axis of a trace, and as its trigger.
#include "tests/trace/traced_unit.hpp"

namespace trace {
namespace {

Frame rpdo(unit::TimePoint time, std::uint8_t first = 0x0F) {
  return {.time = time, .id = 0x205, .length = 2, .data = {first, 0x00}};
}

/// A trace that waits for a frame that @p pattern describes.
Settings waiting_for(const FramePattern& pattern) {
  return {.signals = {"1/speed"},
          .trigger = {.kind = TriggerKind::Frame, .frame = pattern},
          .before = 4ms,
          .length = 12ms};
}

TEST_F(TracedUnit, BeginsWithAFrame) {
  ASSERT_TRUE(traces(waiting_for({.id = 0x205})));
  passes(20ms);
  tracer.on_frame({.time = runner.now(), .id = 0x206});
  tracer.on_frame({.time = runner.now(), .id = 0x205, .extended = true});
  EXPECT_EQ(tracer.phase(), Phase::Waiting);

  const unit::TimePoint there = runner.now() + 1ms;
  tracer.on_frame(rpdo(there));
  EXPECT_EQ(tracer.phase(), Phase::Recording);
  passes(20ms);

  ASSERT_EQ(tracer.phase(), Phase::Done);
  EXPECT_EQ(tracer.result(1)->trigger_time(), there);
  ASSERT_EQ(tracer.result(1)->frames().size(), 3U);
  EXPECT_EQ(tracer.result(1)->frames()[2].data[0], 0x0F);
}

TEST_F(TracedUnit, BeginsWithAFrameOfAMaskADirectionAndSomeBytes) {
  ASSERT_TRUE(traces(waiting_for({.id = 0x200,
                                  .id_mask = 0x780,
                                  .direction = Direction::Received,
                                  .length = 1,
                                  .data = {0x0F},
                                  .data_mask = {0x8F}})));
  Frame sent = rpdo(runner.now());
  sent.direction = Direction::Sent;
  tracer.on_frame(sent);
  tracer.on_frame(rpdo(runner.now(), 0x07));
  tracer.on_frame({.time = runner.now(), .id = 0x205});
  tracer.on_frame({.time = runner.now(), .id = 0x305, .length = 1, .data = {0x0F}});
  EXPECT_EQ(tracer.phase(), Phase::Waiting) << "sent, other bits, too short, another identifier";

  tracer.on_frame(rpdo(runner.now(), 0x7F));

  EXPECT_EQ(tracer.phase(), Phase::Recording);
}

TEST_F(TracedUnit, KeepsOnlyFramesAndEventsOfItsWindow) {
  ASSERT_TRUE(traces(waiting_for({.id = 0x80})));
  tracer.on_frame(rpdo(runner.now()));
  tracer.on_event({.time = runner.now(), .kind = "nmt", .text = "Operational"});
  passes(20ms);
  const unit::TimePoint near = runner.now() - 1ms;
  tracer.on_frame(rpdo(near));
  tracer.on_event({.time = near, .kind = "nmt", .text = "Stopped"});
  tracer.on_frame({.time = runner.now(), .id = 0x80});
  passes(20ms);

  ASSERT_EQ(tracer.phase(), Phase::Done);
  const Recording& result = *tracer.result(1);
  ASSERT_EQ(result.frames().size(), 2U);
  EXPECT_EQ(result.frames()[0].time, near);
  ASSERT_EQ(result.events().size(), 1U);
  EXPECT_EQ(result.events()[0].text, "Stopped");
  EXPECT_EQ(result.frames().lost(), 0U);
}

TEST_F(TracedUnit, CountsFramesThatThereIsNoRoomFor) {
  ASSERT_TRUE(traces({.signals = {"1/speed"}, .length = 1s}));
  passes(8ms);
  for (std::size_t i = 0; i < Recording::kMostFrames + 10; ++i) tracer.on_frame(rpdo(runner.now()));

  ASSERT_EQ(tracer.phase(), Phase::Recording);
  EXPECT_EQ(tracer.current()->frames().size(), Recording::kMostFrames);
  EXPECT_EQ(tracer.current()->frames().lost(), 10U);
}

}  // namespace
}  // namespace trace
