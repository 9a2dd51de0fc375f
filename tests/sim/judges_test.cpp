/// Each invariant can be broken: what a unit must never do is told to its judge.
#include <chrono>
#include <memory>

#include <fcntl.h>
#include <gtest/gtest.h>

#include "libcanopen/base/nmt_state.hpp"
#include "libcanopen/storage/storage_objects.hpp"
#include "sim/base/allocations.hpp"
#include "sim/judges/bus_rules.hpp"
#include "sim/judges/sdo_answers.hpp"
#include "sim/judges/state_tables.hpp"
#include "sim/judges/table.hpp"
#include "sim/judges/unit_rules.hpp"
#include "sim/world/world.hpp"

namespace sim {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// A world of one unit that has come to its master, and judges of which it knows nothing.
class Judges : public testing::Test {
 protected:
  static WorldPlan plan() {
    WorldPlan plan;
    plan.units.push_back({.heartbeat_ms = 100, .inhibit_100us = 200, .seed = 1});
    plan.units[0].configuration = {{"node_id", 1}, {"axes", {nlohmann::json::object()}}};
    plan.length = seconds{2};
    plan.calm = milliseconds{1500};
    return plan;
  }
  Judges() { world_.run(); }

  SimulatedUnit& unit() { return world_.unit(0); }
  canopen::TimePoint now() const { return world_.now(); }
  static canopen::Frame frame(std::uint32_t id, std::initializer_list<std::uint8_t> data) {
    canopen::Frame frame{.id = id, .length = static_cast<std::uint8_t>(data.size())};
    std::ranges::copy(data, frame.data.begin());
    return frame;
  }
  static std::string broken(const Judge& judge) { return judge.breach() ? judge.breach()->text : ""; }

  WorldPlan plan_ = plan();
  axisd::Log log_{axisd::LogLevel{0}};
  World world_{plan_, log_};
};

TEST_F(Judges, SdoAnswersAreOneARequest) {
  SdoAnswers judge{"", 1};
  const auto request = frame(0x601, {0x40, 0, 0x10, 0, 0, 0, 0, 0});
  const auto answer = frame(0x581, {0x43, 0, 0x10, 0, 0, 0, 0, 0});
  judge.on_taken(unit(), request, now());
  judge.on_sent(unit(), answer, now());
  EXPECT_EQ(broken(judge), "");
  judge.on_sent(unit(), answer, now());
  EXPECT_EQ(broken(judge), "an answer to nothing: 43h");
}

TEST_F(Judges, SdoAnswersAreNotMissing) {
  SdoAnswers judge{"", 1};
  judge.on_taken(unit(), frame(0x601, {0x40, 0, 0x10, 0, 0, 0, 0, 0}), now());
  judge.on_turn(unit(), now() + seconds{1}, 0);
  EXPECT_EQ(broken(judge), "");
  judge.on_turn(unit(), now() + seconds{3}, 0);
  EXPECT_EQ(broken(judge), "no answer to a request for 3000 ms");
}

TEST_F(Judges, WhatIsAskedBehindASaveIsOwedBesideItsAnswer) {
  SdoAnswers judge{"", 1};
  device::Device& device = unit().instance().device();
  const auto save = frame(0x601, {0x23, 0x10, 0x10, 1, 's', 'a', 'v', 'e'});
  const auto request = frame(0x601, {0x40, 0, 0x10, 0, 0, 0, 0, 0});
  const auto answer = frame(0x581, {0x43, 0, 0x10, 0, 0, 0, 0, 0});
  judge.on_taken(unit(), save, now());
  const canopen::Entry* const entry = device.dictionary().lookup(canopen::object::kStoreParameters, 1);
  ASSERT_TRUE(device.write_object(*entry, std::int64_t{canopen::kSaveSignature}, now()));
  ASSERT_TRUE(device.is_saving());
  judge.on_taken(unit(), save, now());  // again: both have one answer
  device.on_stored(true, now());
  judge.on_taken(unit(), request, now());
  judge.on_sent(unit(), frame(0x581, {0x60, 0x10, 0x10, 1, 0, 0, 0, 0}), now());
  judge.on_sent(unit(), answer, now());
  judge.on_turn(unit(), now(), 0);
  EXPECT_EQ(broken(judge), "");
  judge.on_sent(unit(), answer, now());
  EXPECT_EQ(broken(judge), "an answer to nothing: 43h");
}

axisd::UnitEvent nmt_event(canopen::NmtState from, canopen::NmtState to) {
  return {.kind = record::EventKind::Nmt,
          .number = static_cast<std::uint16_t>(to),
          .text = name_of(to),
          .text_before = name_of(from)};
}

TEST_F(Judges, OperationalNeedsACommand) {
  using canopen::NmtState;
  NmtTransitions judge{"", 1};
  judge.on_taken(unit(), frame(0, {1, 1}), now());
  judge.on_event(unit(), nmt_event(NmtState::PreOperational, NmtState::Operational));
  EXPECT_EQ(broken(judge), "");
  judge.on_event(unit(), nmt_event(NmtState::Operational, NmtState::PreOperational));
  judge.on_event(unit(), nmt_event(NmtState::PreOperational, NmtState::Operational));
  EXPECT_EQ(broken(judge), "Pre-operational -> Operational");
}

TEST_F(Judges, TheBootUpMessageComesFirst) {
  FirstFrames judge{"", 1};
  judge.on_power(unit(), true);
  judge.on_sent(unit(), frame(0x581, {0x43, 0, 0, 0, 0, 0, 0, 0}), now());
  EXPECT_EQ(broken(judge), "581h before the boot-up message");
}

TEST_F(Judges, NoPdoComesBeforeAStart) {
  FirstFrames judge{"", 1};
  judge.on_power(unit(), true);
  judge.on_sent(unit(), frame(0x701, {0}), now());
  judge.on_sent(unit(), frame(0x181, {0, 0}), now());
  EXPECT_EQ(broken(judge), "TPDO 181h outside Operational");
}

TEST_F(Judges, InhibitTimesHold) {
  InhibitTimes judge{"", 1};
  const auto tpdo = frame(0x281, {0, 0, 0, 0, 0, 0});
  judge.on_sent(unit(), tpdo, now());
  judge.on_sent(unit(), tpdo, now() + milliseconds{20});
  EXPECT_EQ(broken(judge), "");
  judge.on_sent(unit(), tpdo, now() + milliseconds{39});
  EXPECT_EQ(broken(judge), "TPDO 2: 19000 us after the one before, the inhibit time is 20000 us");
}

TEST_F(Judges, HeartbeatsAreNotMissing) {
  HeartbeatTimes judge{"", 1};
  judge.on_turn(unit(), now(), 0);
  judge.on_turn(unit(), now(), 0);
  judge.on_sent(unit(), frame(0x701, {5}), now());
  judge.on_turn(unit(), now() + milliseconds{100}, 0);
  EXPECT_EQ(broken(judge), "");
  judge.on_turn(unit(), now() + milliseconds{101}, 0);
  EXPECT_EQ(broken(judge), "none for 101 ms, 1017h is 100 ms");
}

TEST_F(Judges, TheEndOfErrorsIsToldOnce) {
  EmergencyPairs judge{"", 1};
  const auto error = frame(0x081, {0x30, 0x81, 0x11, 0, 0, 1, 0, 0});
  const auto none = frame(0x081, {0, 0, 0, 0, 0, 0, 0, 0});
  judge.on_sent(unit(), error, now());
  judge.on_sent(unit(), none, now());
  EXPECT_EQ(broken(judge), "");
  judge.on_sent(unit(), none, now());
  EXPECT_EQ(broken(judge), "0000h, and no error was told before");
}

TEST_F(Judges, TheEndOfErrorsIsNotMissing) {
  EmergencyPairs judge{"", 1};
  judge.on_sent(unit(), frame(0x081, {0x30, 0x81, 0x11, 0, 0, 1, 0, 0}), now());
  judge.on_turn(unit(), now(), 0);
  judge.on_turn(unit(), now() + seconds{1}, 0);
  EXPECT_EQ(broken(judge), "1001h is 0, and EMCY 0000h has not come");
}

TEST_F(Judges, ASetThatNobodySavedIsSeen) {
  StoredSets judge{"", 1};
  judge.on_power(unit(), true);
  EXPECT_EQ(broken(judge), "");
  os::Disk& disk = unit().disk();
  const os::Descriptor file{disk.open("/0/other", O_WRONLY | O_CREAT | O_EXCL, 0600)};
  ASSERT_EQ(disk.rename("/0/other", "/0/parameters.bin"), 0);
  judge.on_event(unit(), {.kind = record::EventKind::Store, .active = true});
  judge.on_power(unit(), true);
  EXPECT_EQ(broken(judge), "");
  ASSERT_EQ(disk.unlink("/0/parameters.bin"), 0);
  judge.on_power(unit(), true);
  EXPECT_EQ(broken(judge), "the set that was saved is lost");
}

TEST_F(Judges, AnAxisThatIsNotEnabledIsMissed) {
  EnabledAgain judge{"", 1};
  judge.on_calm(now());
  judge.on_end(now() + EnabledAgain::kLongest + seconds{1});
  EXPECT_EQ(broken(judge), "not all axes have come to Operation enabled");
}

TEST_F(Judges, AnAxisThatDoesNotComeToOperationEnabledIsMissed) {
  unit().instance().device().raise(1, 7011, 0, now());
  EnabledAgain judge{"", 1};
  judge.on_calm(now());
  judge.on_full_bus(seconds{1});  // time in which it could not
  judge.on_turn(unit(), now() + seconds{1} + EnabledAgain::kLongest, 0);
  EXPECT_EQ(broken(judge), "");
  judge.on_turn(unit(), now() + seconds{2} + EnabledAgain::kLongest, 0);
  EXPECT_EQ(broken(judge), "axis 1 is in Fault, F07011 of drive object 2");
}

TEST_F(Judges, AChangeOfStateThatNoTransitionMakesIsSeen) {
  WorldPlan plan = plan_;
  plan.units[0].configuration["profile"] = "cia402";
  World world{plan, log_};
  DriveTransitions judge{"", 1};
  const auto event = [](drive::State from, drive::State to) {
    return axisd::UnitEvent{.kind = record::EventKind::DriveState,
                            .axis = 1,
                            .number = static_cast<std::uint16_t>(to),
                            .text = name_of(to),
                            .text_before = name_of(from)};
  };
  judge.on_event(world.unit(0), event(drive::State::SwitchOnDisabled, drive::State::ReadyToSwitchOn));
  EXPECT_EQ(broken(judge), "");
  judge.on_event(world.unit(0), event(drive::State::SwitchOnDisabled, drive::State::OperationEnabled));
  EXPECT_EQ(broken(judge), "axis 1: Switch on disabled -> Operation enabled");
}

TEST_F(Judges, EnergyThatNobodyHasIsSeen) {
  World world{plan_, log_};
  EnergyBalance judge{"", 1};
  judge.on_cycle(world.unit(0), world.now());
  judge.on_cycle(world.unit(0), world.now());
  EXPECT_EQ(broken(judge), "");
  world.run();  // of whose steps it is not told
  judge.on_cycle(world.unit(0), world.now());
  EXPECT_TRUE(broken(judge).ends_with("J are nowhere")) << broken(judge);
}

TEST_F(Judges, AnAllocationIsSeen) {
  NoAllocation judge{"", 1};
  judge.on_turn(unit(), now(), 0);
  EXPECT_EQ(broken(judge), "");
  judge.on_turn(unit(), now(), 2);
  EXPECT_EQ(broken(judge), "2 allocations in one turn");
}

TEST_F(Judges, AnAllocationIsCounted) {
  const std::uint64_t before = allocations.count;
  {
    const Counted counted;
    const auto one = std::make_unique<int>(1);
    const Uncounted uncounted;
    const auto other = std::make_unique<int>(*one);
    EXPECT_EQ(*other, 1);
  }
  EXPECT_EQ(allocations.count, before + 1);
}

TEST_F(Judges, EachInvariantHasAName) {
  for (const Invariant& each : invariants()) {
    EXPECT_FALSE(each.name.empty());
    EXPECT_FALSE(each.text.empty());
  }
  EXPECT_EQ(make_judges(3).size(), invariants().size());
}

}  // namespace
}  // namespace sim
