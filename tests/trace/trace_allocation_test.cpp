// A trace that is armed allocates nothing, whatever it sees.
#include "tests/fakes/allocation_counter.hpp"
#include "tests/trace/traced_unit.hpp"

namespace trace {
namespace {

TEST_F(TracedUnit, AllocatesNothingWhileItIsArmed) {
  write(kX, 1120, 0.0);
  asks_for(kX, 500.0);
  ASSERT_TRUE(traces({.signals = {"1/speed", "1/r0063", "1/r0899.2", "2/torque", "0/dc_voltage", "0/p8620",
                                  "1/p1120", "2/r0949[0]"},
                      .trigger = {.kind = TriggerKind::Rising, .signal = "1/speed", .level = 100.0},
                      .before = 10ms,
                      .length = 50ms,
                      .repeat = true,
                      .keep = 2}));
  const std::uint64_t before = fakes::allocations();

  for (int round = 0; round < 5; ++round) {
    switch_on(kX);
    passes(200ms);
    for (int i = 0; i < 100; ++i) tracer.on_frame({.time = runner.now(), .id = 0x205});
    raises(1, 7860);
    passes(500ms);
    runner.acknowledge(1, runner.now());
    tracer.on_event({.time = runner.now(), .kind = "nmt", .text = "Operational"});
    commands(kX, 0x0000);
    passes(500ms);
  }

  EXPECT_EQ(fakes::allocations(), before);
  EXPECT_GE(tracer.results().last, 3U) << "and it has traced";
}

}  // namespace
}  // namespace trace
