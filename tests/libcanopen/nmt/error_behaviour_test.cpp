#include "tests/libcanopen/fixture/service_fixture.hpp"

namespace {

using canopen::CommunicationError;
using canopen::NmtState;

constexpr NmtState kStates[] = {NmtState::PreOperational, NmtState::Operational, NmtState::Stopped};

class ErrorBehaviour : public ServiceTest {
 protected:
  /// The state that the silence of node 7 leads to from @p from.
  NmtState after_time_out(NmtState from) {
    writes_u32(0x1016, 1, 0x00070064);
    take_to(from);
    says("707#05");
    passes(100ms);
    EXPECT_EQ(errors(), (Lines{"8130 7"}));
    const NmtState to = node->state();
    says("707#05");
    errors();
    EXPECT_EQ(node->state(), to) << "the end of an error changes nothing";
    take_to(NmtState::PreOperational);
    return to;
  }
};

TEST_F(ErrorBehaviour, LeavesOperationalWithValue0) {
  start();

  EXPECT_EQ(after_time_out(NmtState::PreOperational), NmtState::PreOperational);
  EXPECT_EQ(after_time_out(NmtState::Operational), NmtState::PreOperational);
  EXPECT_EQ(after_time_out(NmtState::Stopped), NmtState::Stopped);
}

TEST_F(ErrorBehaviour, ChangesNothingWithValue1) {
  start();
  EXPECT_EQ(writes_u8(0x1029, 1, 1), 0U);

  for (const NmtState state : kStates) EXPECT_EQ(after_time_out(state), state) << name_of(state);
}

TEST_F(ErrorBehaviour, StopsWithValue2) {
  start();
  EXPECT_EQ(writes_u8(0x1029, 1, 2), 0U);

  for (const NmtState state : kStates) EXPECT_EQ(after_time_out(state), NmtState::Stopped) << name_of(state);
}

TEST_F(ErrorBehaviour, RefusesReservedValues) {
  start();

  for (const std::uint32_t value : {3U, 127U, 128U, 255U}) {
    EXPECT_EQ(writes_u8(0x1029, 1, value), 0x06090030U) << value;
    EXPECT_EQ(writes_u8(0x1029, 2, value), 0x06090030U) << value;
  }
  EXPECT_EQ(value_of(0x1029, 1), 0);
}

TEST_F(ErrorBehaviour, SendsTheEmergencyMessageBeforeItStops) {
  start();
  writes_u8(0x1029, 1, 2);
  writes_u32(0x1016, 1, 0x00070064);
  says("707#05");
  told();

  EXPECT_EQ(passes(100ms), (Lines{"100ms 085#3081110700000000"}));
  EXPECT_EQ(told(), (Lines{"Pre-operational -> Stopped"}));
}

TEST_F(ErrorBehaviour, AppliesToTheErrorsThatCia301NamesOnly) {
  struct Row {
    CommunicationError error;
    NmtState state;
  };
  const Row rows[] = {
      {CommunicationError::CanOverrun, NmtState::Operational},
      {CommunicationError::ErrorPassive, NmtState::Operational},
      {CommunicationError::LifeGuarding, NmtState::PreOperational},
      {CommunicationError::Heartbeat, NmtState::PreOperational},
      {CommunicationError::BusOffRecovered, NmtState::PreOperational},
      {CommunicationError::RpdoTooShort, NmtState::Operational},
      {CommunicationError::RpdoTooLong, NmtState::Operational},
      {CommunicationError::SyncLength, NmtState::Operational},
      {CommunicationError::RpdoTimeout, NmtState::Operational},
      {CommunicationError::SyncTimeout, NmtState::Operational},
  };
  start();

  for (const Row& row : rows) {
    take_to(NmtState::Operational);
    node->report(row.error, now);
    EXPECT_EQ(node->state(), row.state) << row_of(row.error).emcy_code;
  }
}

TEST_F(ErrorBehaviour, HasAClassOfItsOwnForTheApplication) {
  start();
  writes_u8(0x1029, 1, 1);
  writes_u8(0x1029, 2, 2);
  take_to(NmtState::Operational);

  node->apply_error_behaviour(1);
  EXPECT_EQ(node->state(), NmtState::Operational);
  node->apply_error_behaviour(2);
  EXPECT_EQ(node->state(), NmtState::Stopped);
}

TEST_F(ErrorBehaviour, LeavesOperationalForAClassThatTheDictionaryDoesNotHave) {
  start();
  writes_u8(0x1029, 1, 2);

  for (const unsigned error_class : {0U, 3U, 255U}) {  // 0 is the number of classes
    take_to(NmtState::Operational);
    node->apply_error_behaviour(static_cast<std::uint8_t>(error_class));
    EXPECT_EQ(node->state(), NmtState::PreOperational) << error_class;
  }
}

TEST_F(ErrorBehaviour, DoesNothingBeforeStart) {
  node->apply_error_behaviour(1);

  EXPECT_EQ(node->state(), NmtState::Initialising);
}

using NodeWithoutErrorBehaviour = NodeTest;

TEST_F(NodeWithoutErrorBehaviour, LeavesOperational) {
  start_operational();

  node->report(CommunicationError::BusOffRecovered, now);

  EXPECT_EQ(node->state(), NmtState::PreOperational);
}

}  // namespace
