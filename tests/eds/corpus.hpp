#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "eds/lint/lint.hpp"

namespace eds {

/// The whole file at @p path.
inline std::string content_of(const std::filesystem::path& path) {
  std::ifstream stream{path, std::ios::binary};
  if (!stream) throw std::runtime_error{"cannot read " + path.string()};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

/// A file of the corpus, as "good/plain.eds", or one that the build made, as "generated/axisd.eds".
inline std::string corpus_file(const std::string& name) {
  const std::filesystem::path path{name};
  if (*path.begin() == "generated")
    return content_of(std::filesystem::path{GENERATED_EDS_FOLDER} / path.filename());
  return content_of(std::filesystem::path{SOURCE_FOLDER} / "tests/data/eds" / path);
}

/// The findings of @p text, a line each.
inline std::string lint_report(const std::string& text, const std::string& file) {
  std::string report;
  for (const Finding& finding : lint(text, file).all()) report += to_text(finding) + "\n";
  return report;
}

}  // namespace eds
