#include "tests/architecture/include_graph.hpp"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

namespace architecture {
namespace {

using Circles = std::vector<std::string>;

constexpr std::array<std::string_view, 12> kFolders{"libcanopen", "text",   "motor", "drive", "device",   "eds",
                                                    "can",        "daemon", "tools", "bench", "examples", "tests"};

/// Folders whose parts still include each other; a name goes from here when they no longer do.
constexpr std::array<std::string_view, 1> kTangled{"libcanopen"};

bool is_tangled(const std::string& circle) {
  return std::ranges::any_of(kTangled, [&](std::string_view folder) { return circle.starts_with(folder); });
}

IncludeGraph project() {
  return include_graph(SOURCE_FOLDER, kFolders);
}

std::string report_of(const Circles& circles) {
  std::string report;
  for (const std::string& circle : circles) report += circle + "\n";
  return report;
}

TEST(Includes, OfFilesFormNoCircle) {
  EXPECT_EQ(report_of(find_circles(project())), "");
}

TEST(Includes, OfFoldersFormNoCircle) {
  Circles circles = find_circles(folder_graph(project()));
  std::erase_if(circles, is_tangled);

  EXPECT_EQ(report_of(circles), "");
}

TEST(Includes, AreSeenFromTheRootAndBesideTheFile) {
  const IncludeGraph files = project();

  EXPECT_TRUE(files.at("can/port/port.hpp").contains("libcanopen/base/frame.hpp"));
  EXPECT_TRUE(files.at("examples/example_slave.cpp").contains("examples/example_objects.hpp"));
  EXPECT_TRUE(files.at("text/number.hpp").empty());
}

TEST(Circles, OfFilesAreToldOnce) {
  const IncludeGraph files{{"a/one.hpp", {"b/two.hpp"}},
                           {"b/three.hpp", {"a/one.hpp", "b/two.hpp"}},
                           {"b/two.cpp", {"b/two.hpp"}},
                           {"b/two.hpp", {"b/three.hpp"}}};

  EXPECT_EQ(find_circles(files), Circles{"a/one.hpp -> b/two.hpp -> b/three.hpp -> a/one.hpp"});
}

TEST(Circles, OfFoldersNeedNoneOfFiles) {
  const IncludeGraph files{{"a/one.hpp", {"a/below/two.hpp", "a/four.hpp"}},
                           {"a/below/three.cpp", {"a/four.hpp"}}};

  EXPECT_EQ(find_circles(files), Circles{});
  EXPECT_EQ(find_circles(folder_graph(files)), Circles{"a -> a/below -> a"});
}

TEST(Circles, AreNotSeenWhereWaysMeetAgain) {
  const IncludeGraph files{{"a/one.hpp", {"a/two.hpp", "b/three.hpp"}}, {"a/two.hpp", {"b/three.hpp"}}};

  EXPECT_EQ(find_circles(files), Circles{});
  EXPECT_EQ(find_circles(folder_graph(files)), Circles{});
}

}  // namespace
}  // namespace architecture
