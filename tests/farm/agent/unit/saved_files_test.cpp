#include "farm/agent/unit/saved_files.hpp"

#include <vector>

#include "tests/fakes/temporary_directory.hpp"
#include "tests/farm/agent/process/process_fixture.hpp"

namespace farm::agent {
namespace {

class SavedFilesTest : public ProcessFixture {
 protected:
  fakes::TemporaryDirectory root;
  Folders folders{root.path("run"), root.path("state")};
  std::vector<UnitName> told;
  SavedFiles files{events, folders, [this](const UnitName& unit) { told.push_back(unit); }};
};

TEST_F(SavedFilesTest, TellWhichUnitHasSaved) {
  const UnitName five{"line1", "5"};
  const UnitName six{"line1", "6"};
  for (const UnitName& unit : {five, six}) {
    ASSERT_TRUE(replace_file(folders.note(unit), "{}"));
    ASSERT_TRUE(files.watch(unit));
  }

  ASSERT_TRUE(replace_file(folders.note(five), "not what the unit saves"));
  ASSERT_TRUE(replace_file(folders.parameters(six), "saved"));
  ASSERT_TRUE(wait_for([this] { return !told.empty(); }));
  EXPECT_EQ(told, std::vector{six});

  files.leave(six);
  ASSERT_TRUE(replace_file(folders.parameters(six), "saved again"));
  ASSERT_TRUE(replace_file(folders.parameters(five), "saved"));
  ASSERT_TRUE(wait_for([this] { return told.size() > 1; }));
  EXPECT_EQ(told, (std::vector{six, five}));
}

TEST_F(SavedFilesTest, SayWhatCannotBeWatched) {
  const auto watched = files.watch({"line1", "5"});

  ASSERT_FALSE(watched);
  EXPECT_EQ(watched.error(), folders.saved({"line1", "5"}) + ": cannot be watched: No such file or directory");
}

}  // namespace
}  // namespace farm::agent
