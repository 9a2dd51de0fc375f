#include <gtest/gtest.h>

#include "eds/catalogue.hpp"
#include "eds/eds_writer.hpp"
#include "tests/eds/eds_reader.hpp"

namespace eds_test {
namespace {

constexpr const char* kHowToRefresh =
    "the checked-in copy is not what the catalogue gives; refresh it with: cmake --build BUILD --target "
    "update_generated";

std::string in_source(const std::string& path) {
  return read_file(std::string{SOURCE_FOLDER} + "/" + path);
}

TEST(CheckedInCopies, EdsIsWhatTheCatalogueGives) {
  EXPECT_TRUE(in_source("eds/axisd.eds") == read_file(GENERATED_EDS)) << "eds/axisd.eds: " << kHowToRefresh;
}

TEST(CheckedInCopies, ReferencePageIsWhatTheCatalogueGives) {
  EXPECT_TRUE(in_source("docs/objects.md") == read_file(GENERATED_OBJECTS_PAGE))
      << "docs/objects.md: " << kHowToRefresh;
}

TEST(CheckedInCopies, GenerationGivesTheSameBytesEveryTime) {
  const std::string catalogue = in_source("eds/catalogue.json");

  EXPECT_EQ(eds::write_eds(eds::parse_catalogue(catalogue)), read_file(GENERATED_EDS));
}

}  // namespace
}  // namespace eds_test
