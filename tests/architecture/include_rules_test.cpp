#include "tests/architecture/include_rules.hpp"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

namespace architecture {
namespace {

namespace fs = std::filesystem;
using Findings = std::vector<std::string>;

/// A source tree of its own, gone with the test.
class TemporaryTree : public testing::Test {
 protected:
  TemporaryTree() {
    std::string pattern = (fs::temp_directory_path() / "axisd-architecture-XXXXXX").string();
    if (mkdtemp(pattern.data()) != nullptr) root_ = pattern;
  }
  void SetUp() override { ASSERT_FALSE(root_.empty()); }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& path, const std::string& text) const {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream{root_ / path} << text;
  }
  [[nodiscard]] const fs::path& root() const { return root_; }
  [[nodiscard]] Findings findings() const { return find_forbidden_includes(root_, kLayers); }

 private:
  fs::path root_;
};

TEST(Layers, IncludeOnlyWhatTheyRestOn) {
  std::string report;
  for (const std::string& finding : find_forbidden_includes(SOURCE_FOLDER, kLayers)) report += finding + "\n";

  EXPECT_EQ(report, "");
}

TEST(Layers, AreTheFoldersOfTheProject) {
  EXPECT_EQ(find_lawless(SOURCE_FOLDER, kLayers), Findings{});
}

TEST_F(TemporaryTree, WithAForbiddenIncludeIsCaughtWithFileAndLine) {
  write("drive/sub/axis.cpp", "#include <vector>\n\n#include \"libcanopen/base/frame.hpp\"\n");

  EXPECT_EQ(findings(), Findings{"drive/sub/axis.cpp:3: drive may not include libcanopen/base/frame.hpp"});
}

TEST_F(TemporaryTree, WithEveryKindOfForbiddenIncludeIsCaught) {
  write("libcanopen/a.hpp", "#include <fmt/format.h>\n");
  write("motor/a.hpp", "  #  include <time.h>\n");
  write("bus/a.cpp", "#include \"libcanopen/od/data_type.hpp\"\n");
  write("device/a.cpp", "#include \"generated/other.hpp\"\n");
  write("tools/a.cpp", "#include \"daemon/config.hpp\"\n");
  write("tools/b.cpp", "#include <systemd/sd-bus.h>\n");
  write("preload/a.c", "#include \"bus/port.hpp\"\n");
  write("eds/a.cpp", "#include <libcanopen/sdo/server.hpp>\n");

  EXPECT_EQ(findings(), (Findings{"libcanopen/a.hpp:1: libcanopen may not include fmt/format.h",
                                  "motor/a.hpp:1: motor may not include time.h",
                                  "device/a.cpp:1: device may not include generated/other.hpp",
                                  "eds/a.cpp:1: eds may not include libcanopen/sdo/server.hpp",
                                  "bus/a.cpp:1: bus may not include libcanopen/od/data_type.hpp",
                                  "tools/a.cpp:1: tools may not include daemon/config.hpp",
                                  "tools/b.cpp:1: tools may not include systemd/sd-bus.h",
                                  "preload/a.c:1: preload may not include bus/port.hpp"}));
}

TEST_F(TemporaryTree, WithAFolderThatNoLayerNamesIsCaught) {
  constexpr std::array kTwo{Layer{"motor", {}}, Layer{"drive/blocks", {}}};
  for (const char* folder : {"motor", "drive", "tests"}) write(folder + std::string{"/CMakeLists.txt"}, "");
  write("motor/plant/a.cpp", "");
  write("drive/blocks/a.cpp", "");
  write("drive/a.cpp", "");
  write("tests/a.cpp", "");
  write("not-built/a.cpp", "");

  EXPECT_EQ(find_lawless(root(), kTwo), Findings{"drive/a.cpp: no layer says what it may include"});
}

TEST_F(TemporaryTree, WithoutAFileOfALayerIsCaught) {
  constexpr std::array kTwo{Layer{"motor", {}}, Layer{"drive", {}}};
  write("motor/CMakeLists.txt", "");
  write("motor/a.cpp", "");
  write("drive/CMakeLists.txt", "");

  EXPECT_EQ(find_lawless(root(), kTwo), Findings{"drive: a layer without a source file"});
}

TEST_F(TemporaryTree, WithAllowedIncludesIsAccepted) {
  write("libcanopen/a.hpp", "#include <cstdint>\n#include <tl/expected.hpp>\n#include \"libcanopen/b.hpp\"\n");
  write("motor/a.hpp", "#include <array>\n#include \"motor/b.hpp\"\n");
  write("device/a.cpp", "#include \"generated/object_table.hpp\"\n#include \"drive/unit.hpp\"\n");
  write("bus/a.cpp", "#include <linux/can.h>\n#include <unistd.h>\n#include \"libcanopen/base/frame.hpp\"\n");
  write("daemon/a.cpp", "#include <systemd/sd-event.h>\n#include <sys/timerfd.h>\n#include \"device/unit.hpp\"\n");
  write("tools/a.cpp", "#include \"daemon/control_protocol.hpp\"\n");
  write("drive/notes.md", "#include \"libcanopen/base/frame.hpp\"\n");
  write("drive/a.cpp", "// #include \"libcanopen/base/frame.hpp\"\n");

  EXPECT_EQ(findings(), Findings{});
}

}  // namespace
}  // namespace architecture
