#include "farm/agent/host/state_transfer.hpp"

#include <gtest/gtest.h>

#include "farm/documents/place.hpp"
#include "tests/fakes/fake_key_value.hpp"
#include "tests/fakes/fake_object_store.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace farm::agent {
namespace {

const UnitName kUnit{"line1", "5"};
constexpr std::uint32_t kChecksum = 0xCBF43926;  // of "123456789"

class StateTransferTest : public testing::Test {
 protected:
  void place(std::uint64_t term) {
    (void)keys.put("axisd_lab_places", "line1.5", text_of(Place{.host = "a", .instance = 1, .term = term}));
  }
  std::string& object() { return objects.objects[{"axisd_lab_state", "line1.5/parameters.bin"}]; }

  fakes::TemporaryDirectory root;
  Folders folders{root.path("run"), root.path("state")};
  StateTransfer transfer{"lab", folders};
  fakes::FakeKeyValue keys;
  fakes::FakeObjectStore objects;
  Storage storage{keys, objects};
};

TEST_F(StateTransferTest, FetchesWhatLiesOnTheServer) {
  object() = "123456789";

  EXPECT_EQ(transfer.fetch(storage, kUnit).value(), kChecksum);
  EXPECT_EQ(read_parameters(folders, kUnit).value(), "123456789");
}

TEST_F(StateTransferTest, LeavesWhatIsHereWhereNothingLiesOnTheServer) {
  ASSERT_TRUE(replace_file(folders.parameters(kUnit), "here"));

  EXPECT_EQ(transfer.fetch(storage, kUnit).value(), std::nullopt);
  EXPECT_EQ(read_parameters(folders, kUnit).value(), "here");
}

TEST_F(StateTransferTest, SaysWhyNothingIsFetched) {
  objects.error = "no connection";

  EXPECT_EQ(transfer.fetch(storage, kUnit).error(), "no connection");
}

TEST_F(StateTransferTest, PutsWhatIsHereOnTheServer) {
  ASSERT_TRUE(replace_file(folders.parameters(kUnit), "123456789"));
  place(7);

  const auto upload = transfer.upload(storage, kUnit, 7);

  ASSERT_TRUE(upload);
  EXPECT_FALSE(upload->is_others);
  EXPECT_EQ(upload->checksum, kChecksum);
  EXPECT_EQ(object(), "123456789");
}

TEST_F(StateTransferTest, PutsNothingOverWhatAnotherHostHasSaved) {
  ASSERT_TRUE(replace_file(folders.parameters(kUnit), "old"));
  object() = "newer";
  place(8);

  EXPECT_TRUE(transfer.upload(storage, kUnit, 7).value().is_others);
  EXPECT_EQ(object(), "newer");
}

TEST_F(StateTransferTest, PutsNothingWhileNobodySaysWhoHasTheUnit) {
  ASSERT_TRUE(replace_file(folders.parameters(kUnit), "mine"));

  EXPECT_EQ(transfer.upload(storage, kUnit, 7).error(), "place of line1/5 is not known");
  EXPECT_EQ(object(), "");
}

}  // namespace
}  // namespace farm::agent
