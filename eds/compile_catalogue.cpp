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
    "usage: compile_catalogue CATALOGUE [--table FILE] [--objects FILE] [--eds FOLDER]\n";

void write_table(const eds::Catalogue& catalogue, const std::string& path) {
  eds::write_file(path, eds::write_table(catalogue));
}

void write_reference(const eds::Catalogue& catalogue, const std::string& path) {
  eds::write_file(path, eds::write_reference(catalogue));
}

void write_eds_files(const eds::Catalogue& catalogue, const std::string& folder) {
  for (const eds::EdsFile& file : catalogue.files)
    eds::write_file(folder + "/" + file.name, eds::write_eds(catalogue, file));
}

/// What an option asks for.
struct Output {
  std::string_view option;
  void (*write)(const eds::Catalogue&, const std::string& path);
};

constexpr std::array kOutputs{
    Output{"--table", write_table},
    Output{"--objects", write_reference},
    Output{"--eds", write_eds_files},
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
    for (const Output& output : kOutputs)
      if (output.option == word) return &output;
    return static_cast<const Output*>(nullptr);
  };
  bool usable = count >= 2 && count % 2 == 0;
  for (int n = 2; usable && n < count; n += 2) usable = known(words[n]) != nullptr;
  if (!usable) return std::fputs(kUsage, stderr), 2;

  const eds::Catalogue catalogue = read_catalogue(words[1]);
  for (int n = 2; n < count; n += 2) known(words[n])->write(catalogue, words[n + 1]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
