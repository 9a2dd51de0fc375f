#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "eds/catalogue/catalogue.hpp"
#include "eds/writer/eds_writer.hpp"
#include "eds/writer/file_text.hpp"
#include "eds/writer/reference_writer.hpp"
#include "eds/writer/table_writer.hpp"

namespace {

constexpr const char* kUsage =
    "usage: compile_catalogue CATALOGUE [--namespace NAME] [--table FILE] [--offsets FILE] [--objects FILE] "
    "[--parameters ROWS] [--eds FOLDER]\n";

/// What is written, and what the options before have said of it.
struct Work {
  eds::Catalogue catalogue;
  std::string source;                    ///< the catalogue in the project
  std::string name_space = "generated";  ///< of the C++ headers
};

void set_namespace(Work& work, const std::string& name) {
  work.name_space = name;
}

void write_table(Work& work, const std::string& path) {
  eds::write_file(path, eds::write_table(work.catalogue, work.name_space));
}

void write_offsets(Work& work, const std::string& path) {
  eds::write_file(path, eds::write_offsets(work.catalogue, work.name_space));
}

void write_reference(Work& work, const std::string& path) {
  eds::write_file(path, eds::write_reference(work.catalogue, work.source));
}

/// What follows knows the parameters at @p path too.
void read_parameters(Work& work, const std::string& path) {
  const std::string rows = eds::read_file(path);
  try {
    eds::add_parameters(work.catalogue, rows);
  } catch (const eds::CatalogueError& error) {
    throw std::runtime_error{path + ": " + error.what()};
  }
}

void write_eds_files(Work& work, const std::string& folder) {
  for (const eds::EdsFile& file : work.catalogue.files)
    eds::write_file(folder + "/" + file.name, eds::write_eds(work.catalogue, file));
}

/// What an option asks for, in the order of the command line.
struct Step {
  std::string_view option;
  void (*run)(Work&, const std::string& value);
};

constexpr std::array kSteps{
    Step{"--namespace", set_namespace}, Step{"--table", write_table},          Step{"--offsets", write_offsets},
    Step{"--objects", write_reference}, Step{"--parameters", read_parameters}, Step{"--eds", write_eds_files},
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

  Work work{.catalogue = read_catalogue(words[1]),
            .source = "eds/" + std::filesystem::path{words[1]}.filename().string()};
  for (int n = 2; n < count; n += 2) known(words[n])->run(work, words[n + 1]);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
