#include "control/eds_file.hpp"

#include <filesystem>

#include <gtest/gtest.h>

namespace control {
namespace {

TEST(EdsFile, IsThatOfTheProfileAndTheNumberOfAxes) {
  EXPECT_EQ(eds_file_name("s120", 1), "axisd.eds");
  EXPECT_EQ(eds_file_name("s120", 8), "axisd-8-axes.eds");
  EXPECT_EQ(eds_file_name("cia402", 1), "axisd-cia402.eds");
  EXPECT_EQ(eds_file_name("cia402", 2), "axisd-cia402-2-axes.eds");
}

TEST(EdsFile, IsOneOfTheDriveUnitForAProfileThatNobodyKnows) {
  EXPECT_EQ(eds_file_name("", 1), "axisd.eds");
  EXPECT_EQ(eds_file_name("../../etc", 2), "axisd-2-axes.eds");
}

TEST(EdsFile, IsInstalledForEveryUnitThatThereCanBe) {
  for (const std::string_view profile : {kProfileS120, kProfileCia402})
    for (std::size_t axes = 1; axes <= 8; ++axes)
      EXPECT_TRUE(std::filesystem::exists(std::filesystem::path{EDS_FOLDER} / eds_file_name(profile, axes)))
          << eds_file_name(profile, axes);
}

}  // namespace
}  // namespace control
