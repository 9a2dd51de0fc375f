#include "tests/libcanopen/fixture/lss_fixture.hpp"

namespace {

using canopen::LssState;
using canopen::NmtState;

class LssSlave : public LssTest {
 protected:
  void SetUp() override { start(); }
};

TEST_F(LssSlave, WaitsAtPowerOn) {
  EXPECT_EQ(lss.state(), LssState::Waiting);
  for (const char* const request : {"1109", "130002", "156400", "17", "5A", "5B", "5C", "5D", "5E"})
    EXPECT_EQ(asks(request), Lines{}) << request;
  EXPECT_EQ(told(), Lines{});
  EXPECT_EQ(lss.settings().node_id, 5);
}

TEST_F(LssSlave, FollowsTheSwitchOfAllNodes) {
  EXPECT_EQ(asks("0401"), Lines{});
  EXPECT_EQ(lss.state(), LssState::Configuration);
  EXPECT_TRUE(is_selected());
  EXPECT_EQ(asks("0401"), Lines{});
  EXPECT_TRUE(is_selected());

  EXPECT_EQ(asks("0400"), Lines{});
  EXPECT_EQ(lss.state(), LssState::Waiting);
  EXPECT_FALSE(is_selected());
}

TEST_F(LssSlave, IgnoresModesThatDoNotExist) {
  for (const char* const mode : {"0402", "0480", "04FF"}) asks(mode);
  EXPECT_FALSE(is_selected());
  asks("0401");
  for (const char* const mode : {"0402", "0480", "04FF"}) asks(mode);
  EXPECT_TRUE(is_selected());
}

TEST_F(LssSlave, IsSelectedByItsIdentity) {
  select();
  EXPECT_EQ(asks("5E"), answer("5E05"));
}

TEST_F(LssSlave, IsNotSelectedByAnotherIdentity) {
  const Lines right{"402A", "4102000100", "4204000300", "4378563412"};
  const Lines wrong{"402B", "4102000180", "4204000200", "4378563413"};
  for (std::size_t i = 0; i < right.size(); ++i) {
    Lines sequence = right;
    sequence[i] = wrong[i];
    for (const std::string& request : sequence) EXPECT_EQ(asks(request), Lines{}) << request;
    EXPECT_FALSE(is_selected()) << i;
  }
}

TEST_F(LssSlave, IsSelectedByTheFourNumbersInTheirOrderOnly) {
  Lines sequence{"402A", "4102000100", "4204000300", "4378563412"};
  do {
    const bool in_order = std::ranges::is_sorted(sequence);
    for (const std::string& request : sequence) asks(request);
    EXPECT_EQ(is_selected(), in_order) << sequence[0] << sequence[1] << sequence[2];
    asks("0400");
  } while (std::ranges::next_permutation(sequence).found);
}

TEST_F(LssSlave, IsNotSelectedIfAnyOtherRequestComesBetween) {
  for (unsigned command = 0; command <= 0xFF; ++command) {
    char between[3];
    std::snprintf(between, sizeof between, "%02X", command);
    asks("402A");
    asks("4102000100");
    asks(between);
    asks("4204000300");
    asks("4378563412");
    EXPECT_FALSE(is_selected()) << between;
    asks("0400");
  }
}

TEST_F(LssSlave, BeginsAnewWithTheFirstNumber) {
  asks("402A");
  asks("4102000100");
  asks("402A");
  EXPECT_EQ(asks("4204000300"), Lines{});
  EXPECT_EQ(asks("4378563412"), Lines{});
  asks("402A");
  select();
}

TEST_F(LssSlave, IsSelectedWhileItWaitsOnly) {
  select();
  for (const char* const request : {"402A", "4102000100", "4204000300", "4378563412"})
    EXPECT_EQ(asks(request), Lines{}) << request;
  EXPECT_TRUE(is_selected());
}

/// The requests of "identify remote slave" with these bounds of revision and serial number.
std::vector<std::string> identify(std::string revision_low, std::string revision_high, std::string serial_low,
                                  std::string serial_high) {
  return {"462A", "4702000100", "48" + revision_low, "49" + revision_high, "4A" + serial_low, "4B" + serial_high};
}

TEST_F(LssSlave, IdentifiesItselfWithinBothRanges) {
  struct Row {
    std::vector<std::string> requests;
    bool found;
  };
  const Row rows[] = {
      {identify("04000300", "04000300", "78563412", "78563412"), true},
      {identify("00000000", "FFFFFFFF", "00000000", "FFFFFFFF"), true},
      {identify("03000300", "05000300", "77563412", "79563412"), true},
      {identify("05000300", "FFFFFFFF", "00000000", "FFFFFFFF"), false},
      {identify("00000000", "03000300", "00000000", "FFFFFFFF"), false},
      {identify("00000000", "FFFFFFFF", "79563412", "FFFFFFFF"), false},
      {identify("00000000", "FFFFFFFF", "00000000", "77563412"), false},
      {identify("FFFFFFFF", "00000000", "00000000", "FFFFFFFF"), false},
      {identify("00000000", "FFFFFFFF", "FFFFFFFF", "00000000"), false},
  };
  for (const bool configuring : {false, true}) {
    asks(configuring ? "0401" : "0400");
    for (const Row& row : rows) {
      Lines said;
      for (const std::string& request : row.requests) said = asks(request);
      EXPECT_EQ(said, row.found ? answer("4F") : Lines{}) << row.requests[2] << ' ' << row.requests[4];
      EXPECT_EQ(is_selected(), configuring) << "to be found changes nothing";
    }
  }
}

TEST_F(LssSlave, DoesNotIdentifyItselfToThoseWhoSeekAnotherDevice) {
  for (const auto& [vendor, product] : {std::pair{"462B", "4702000100"}, std::pair{"462A", "4703000100"}}) {
    for (const char* const request : {vendor, product, "4800000000", "49FFFFFFFF", "4A00000000", "4BFFFFFFFF"})
      EXPECT_EQ(asks(request), Lines{}) << request;
  }
}

TEST_F(LssSlave, DoesNotIdentifyItselfIfAnotherRequestComesBetween) {
  const auto requests = identify("00000000", "FFFFFFFF", "00000000", "FFFFFFFF");
  for (std::size_t at = 1; at < requests.size(); ++at) {
    for (std::size_t i = 0; i < requests.size(); ++i) {
      if (i == at) asks("4C");
      EXPECT_EQ(asks(requests[i]), Lines{}) << at;
    }
  }
  for (const std::string& request : requests) {
    if (request != requests.back()) asks(request);
  }
  EXPECT_EQ(asks(requests.back()), answer("4F"));
  EXPECT_EQ(asks(requests.back()), Lines{}) << "once";
}

TEST_F(LssSlave, KeepsTheTwoSequencesApart) {
  for (const char* const request : {"402A", "4702000100", "4204000300", "4378563412"}) asks(request);
  EXPECT_FALSE(is_selected());
  for (const char* const request : {"462A", "4102000100", "4800000000", "49FFFFFFFF", "4A00000000"}) asks(request);
  EXPECT_EQ(asks("4BFFFFFFFF"), Lines{});
}

TEST_F(LssSlave, IgnoresFramesOfOtherLengths) {
  EXPECT_EQ(says("7E5#0401"), Lines{});
  EXPECT_EQ(says("7E5#"), Lines{});
  EXPECT_FALSE(is_selected());

  asks("402A");
  says("7E5#41020001000000");
  asks("4102000100");
  says("7E5#00");
  asks("4204000300");
  EXPECT_EQ(says("7E5#43785634120000"), Lines{});
  EXPECT_EQ(asks("4378563412"), answer("44")) << "they do not interrupt";
}

TEST_F(LssSlave, IgnoresFramesThatAreNoRequests) {
  for (const char* const frame :
       {"7E5#R8", "7E4#0401000000000000", "7E6#0401000000000000", "000007E5#0401000000000000"})
    EXPECT_EQ(says(frame), Lines{}) << frame;
  EXPECT_FALSE(is_selected());
}

TEST_F(LssSlave, IsSilentToWhatItDoesNotKnow) {
  constexpr std::string_view kKnown = "04 11 13 17 40 41 42 43 46 47 48 49 4A 4B 4C 51 5A 5B 5C 5D 5E";
  asks("0401");
  for (unsigned command = 0; command <= 0xFF; ++command) {
    char request[3];
    std::snprintf(request, sizeof request, "%02X", command);
    if (kKnown.find(request) == std::string_view::npos) {
      EXPECT_EQ(asks(request), Lines{}) << request;
    }
  }
  EXPECT_TRUE(is_selected());
}

TEST_F(LssSlave, WorksInEveryNmtState) {
  for (const auto& [command, state] :
       {std::pair{"000#0205", NmtState::Stopped}, std::pair{"000#8005", NmtState::PreOperational},
        std::pair{"000#0105", NmtState::Operational}}) {
    says(command);
    ASSERT_EQ(node->state(), state);
    select();
    EXPECT_EQ(asks("5D"), answer("5D78563412"));
    asks("0400");
  }
}

TEST_F(LssSlave, StaysSelectedThroughChangesOfTheNmtState) {
  select();
  says("000#0205");
  EXPECT_TRUE(is_selected());
  says("000#0105");
  EXPECT_TRUE(is_selected());
  node->reload(now);
  EXPECT_TRUE(is_selected());
}

TEST_F(LssSlave, WaitsAfterAReset) {
  for (const char* const reset : {"000#8205", "000#8105"}) {
    select();
    EXPECT_EQ(says(reset), (Lines{"705#00"}));
    EXPECT_FALSE(is_selected());
  }
  select();
  start();
  EXPECT_FALSE(is_selected());
}

TEST_F(LssSlave, ForgetsAHalfSequenceWithAReset) {
  asks("402A");
  asks("4102000100");
  asks("4204000300");
  says("000#8205");
  EXPECT_EQ(asks("4378563412"), Lines{});
}

TEST_F(LssSlave, KeepsItsIdentifiersFromOtherServices) {
  EXPECT_TRUE(node->uses(0x7E4));
  EXPECT_TRUE(node->uses(0x7E5));
  EXPECT_EQ(subscriptions(),
            (std::vector<std::uint32_t>{0, 0x80, 0x205, 0x305, 0x405, 0x585, 0x605, 0x705, 0x7E5}));
}

using NodeWithoutLss = NodeTest;

TEST_F(NodeWithoutLss, DoesNotHearIt) {
  start();
  EXPECT_FALSE(node->uses(0x7E5));
  EXPECT_EQ(says("7E5#0401000000000000"), Lines{});
  EXPECT_EQ(says("7E5#5E00000000000000"), Lines{});
}

}  // namespace
