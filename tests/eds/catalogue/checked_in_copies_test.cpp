#include <gtest/gtest.h>

#include "eds/catalogue/catalogue.hpp"
#include "eds/writer/eds_writer.hpp"
#include "tests/eds/rules/eds_reader.hpp"

namespace eds_test {
namespace {

constexpr const char* kHowToRefresh =
    "the checked-in copy is not what the catalogue gives; refresh it with: cmake --build BUILD --target "
    "update_generated";

std::string in_source(const std::string& path) {
  return read_file(std::string{SOURCE_FOLDER} + "/" + path);
}

std::string generated(const std::string& name) {
  return read_file(std::string{GENERATED_EDS_FOLDER} + "/" + name);
}

TEST(CheckedInCopies, EdsFilesAreWhatTheCatalogueGives) {
  for (const char* name : {"axisd.eds", "axisd-unit.eds", "axisd-control-unit.eds", "axisd-servo.eds",
                           "axisd-vector.eds", "axisd-cia402.eds"})
    EXPECT_TRUE(in_source(std::string{"eds/"} + name) == generated(name)) << name << ": " << kHowToRefresh;
}

TEST(CheckedInCopies, ReferencePagesAreWhatTheCataloguesGive) {
  for (const std::string name : {"objects.md", "objects-cia402.md"})
    EXPECT_TRUE(in_source("docs/reference/" + name) == read_file(GENERATED_PAGES_FOLDER "/" + name))
        << name << ": " << kHowToRefresh;
}

TEST(CheckedInCopies, GenerationGivesTheSameBytesEveryTime) {
  eds::Catalogue catalogue = eds::parse_catalogue(in_source("eds/catalogue.json"));
  eds::add_parameters(catalogue, read_file(GENERATED_PARAMETER_ROWS));

  for (const eds::EdsFile& file : catalogue.files)
    EXPECT_TRUE(eds::write_eds(catalogue, file) == generated(file.name)) << file.name;

  const eds::Catalogue cia402 = eds::parse_catalogue(in_source("eds/catalogue-cia402.json"));
  for (const eds::EdsFile& file : cia402.files)
    EXPECT_TRUE(eds::write_eds(cia402, file) == generated(file.name)) << file.name;
}

}  // namespace
}  // namespace eds_test
