#include "os/clean_pages.hpp"

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace os {
namespace {

/// Pages of files that this process has in memory.
long file_pages() {
  std::ifstream statm{"/proc/self/statm"};
  long size = 0;
  long resident = 0;
  long of_files = 0;
  statm >> size >> resident >> of_files;
  return of_files;
}

TEST(CleanPages, AreGivenBackAndComeAgain) {
  const long before = file_pages();
  give_back_clean_pages();
  const long after = file_pages();
  EXPECT_LT(after, before);
  std::vector<std::string> words{"what", "was", "given", "back"};
  words.push_back(std::to_string(std::sin(1.0)));
  EXPECT_EQ(words.back(), "0.841471");
}

}  // namespace
}  // namespace os
