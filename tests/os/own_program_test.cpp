#include "os/own_program.hpp"

#include <gtest/gtest.h>

namespace os {
namespace {

TEST(OwnProgram, LiesInTheFolderOfTheProgramThatRuns) {
  EXPECT_TRUE(std::filesystem::exists(program_folder() / "os_test")) << program_folder();
}

}  // namespace
}  // namespace os
