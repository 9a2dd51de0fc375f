#include <array>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

#include "eds/catalogue.hpp"
#include "eds/eds_writer.hpp"
#include "eds/file_text.hpp"
#include "eds/reference_writer.hpp"
#include "eds/table_writer.hpp"

namespace {

constexpr const char* kUsage =
    "usage: compile_catalogue CATALOGUE [--table FILE] [--offsets FILE] [--objects FILE] [--parameters ROWS] "
    "[--eds FOLDER]\n";

void write_table(eds::Catalogue& catalogue, const std::string& path) {
  eds::write_file(path, eds::write_table(catalogue));
}

void write_offsets(eds::Catalogue& catalogue, const std::string& path) {
  eds::write_file(path, eds::write_offsets(catalogue));
}

void write_reference(eds::Catalogue& catalogue, const std::string& path) {
  eds::write_file(path, eds::write_reference(catalogue));
}

/// What follows knows the parameters at @p path too.
void read_parameters(eds::Catalogue& catalogue, const std::string& path) {
  const std::string rows = eds::read_file(path);
  try {
    eds::add_parameters(catalogue, rows);
  } catch (const eds::CatalogueError& error) {
    throw std::runtime_error{path + ": " + error.what()};
  }
}

void write_eds_files(eds::Catalogue& catalogue, const std::string& folder) {
  for (const eds::EdsFile& file : catalogue.files)
    eds::write_file(folder + "/" + file.name, eds::write_eds(catalogue, file));
}

/// What an option asks for, in the order of the command line.
struct Step {
  std::string_view option;
  void (*run)(eds::Catalogue&, const std::string& path);
};

constexpr std::array kSteps{
    Step{"--table", write_table},          Step{"--offsets", write_offsets}, Step{"--objects", write_reference},
    Step{"--parameters", read_parameters}, Step{"--eds", write_eds_files},
};

eds::Catalogue read_catalogue(const std::string& path) {
  const std::string text = eds::read_file(path);
  try {
    return eds::parse_catalogue(text);
  } catch (const eds::CatalogueError& error) {
    throw std::runtime_error{path + ": " + error.what()};
  }
}

}  // namespace

int main(int count, char** words) try {
  const auto known = [](std::string_view word) {
    for (const Step& step : kSteps)
      if (step.option == word) return &step;
    return static_cast<const Step*>(nullptr);
  };
  bool usable = count >= 2 && count % 2 == 0;
  for (int n = 2; usable && n < count; n += 2) usable = known(words[n]) != nullptr;
  if (!usable) return std::fputs(kUsage, stderr), 2;

  eds::Catalogue catalogue = read_catalogue(words[1]);
  for (int n = 2; n < count; n += 2) known(words[n])->run(catalogue, words[n + 1]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
