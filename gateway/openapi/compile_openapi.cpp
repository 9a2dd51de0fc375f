#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>

#include "gateway/openapi/writers.hpp"

namespace {

constexpr const char* kUsage =
    "usage: compile_openapi --document FILE --source FILE --page FILE SCHEMA\n"
    "       compile_openapi --update PAGE\n";
constexpr std::size_t kPart = 8000;  // of a literal

std::string read_file(const std::string& path) {
  std::ifstream file{path};
  if (!file) throw std::runtime_error{path + ": cannot be read"};
  return {std::istreambuf_iterator<char>{file}, {}};
}

void write_file(const std::string& path, const std::string& text) {
  std::ofstream file{path, std::ios::binary};
  if (!(file << text).flush()) throw std::runtime_error{path + ": cannot be written"};
}

}  // namespace

std::string gateway::write_source(std::string_view document) {
  std::string literals;
  for (std::size_t at = 0; at < document.size(); at += kPart)
    literals += "    R\"~~~(" + std::string{document.substr(at, kPart)} + ")~~~\"\n";
  return "// Made by compile_openapi.\n#include \"gateway/openapi/document.hpp\"\n\n"
         "std::string_view gateway::openapi_document() noexcept {\n  return\n" +
         literals + "      ;\n}\n";
}

int main(int count, char** given) try {
  const std::vector<std::string> words{given + 1, given + count};
  if (words.size() == 2 && words[0] == "--update") {
    write_file(words[1], gateway::with_part(read_file(words[1]), gateway::write_page()));
    return 0;
  }
  constexpr std::size_t kWords = 7;
  if (words.size() != kWords || words[0] != "--document" || words[2] != "--source" || words[4] != "--page")
    return std::fputs(kUsage, stderr), 2;
  const std::string document = gateway::write_document(nlohmann::json::parse(read_file(words[6])), AXISD_VERSION);
  write_file(words[1], document);
  write_file(words[3], gateway::write_source(document));
  write_file(words[5], gateway::write_page());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "compile_openapi: %s\n", error.what());
  return 1;
}
