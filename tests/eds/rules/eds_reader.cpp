#include "tests/eds/rules/eds_reader.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace eds_test {
namespace {

[[noreturn]] void fail(int line, const std::string& why) {
  throw std::runtime_error{"line " + std::to_string(line) + ": " + why};
}

std::string entry_section(std::uint16_t index) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string name;
  for (int shift = 12; shift >= 0; shift -= 4) name += kDigits[static_cast<std::size_t>(index >> shift & 0xF)];
  return name;
}

}  // namespace

EdsFile read_eds(std::string_view text) {
  EdsFile file;
  Section* section = nullptr;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) fail(number, "not ended by LF");
    const std::string line{text.substr(0, end)};
    text.remove_prefix(end + 1);
    if (line.empty()) continue;
    if (line.back() == ' ' || line.back() == '\r' || line.front() == ' ') fail(number, "space at an end");
    if (line.front() == '[') {
      if (line.back() != ']') fail(number, "section without ]");
      const auto [place, added] = file.try_emplace(line.substr(1, line.size() - 2));
      if (!added) fail(number, "second " + line);
      section = &place->second;
      continue;
    }
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos || equals == 0 || section == nullptr)
      fail(number, "neither section nor entry");
    if (!section->emplace(line.substr(0, equals), line.substr(equals + 1)).second) fail(number, "second " + line);
  }
  return file;
}

std::optional<std::int64_t> number(std::string_view text, std::int64_t node_id) {
  constexpr std::string_view kNode = "$NODEID+";
  const bool relative = text.starts_with(kNode);
  const std::string digits{relative ? text.substr(kNode.size()) : text};
  if (digits.empty()) return std::nullopt;
  char* end = nullptr;
  const long long value = std::strtoll(digits.c_str(), &end, digits.find('x') == std::string::npos ? 10 : 16);
  if (*end != '\0') return std::nullopt;
  return relative ? value + node_id : value;
}

std::int64_t number_at(const Section& section, std::string_view key) {
  const auto found = section.find(key);
  const auto value = found == section.end() ? std::nullopt : number(found->second);
  if (!value) throw std::runtime_error{"no number at " + std::string{key}};
  return *value;
}

const Section* find_entry(const EdsFile& file, std::uint16_t index, std::uint8_t sub_index) {
  const std::string name = entry_section(index);
  const auto object = file.find(name);
  if (object == file.end()) return nullptr;
  if (object->second.find("SubNumber") == object->second.end()) return sub_index == 0 ? &object->second : nullptr;
  const std::string low = entry_section(sub_index).substr(sub_index < 0x10 ? 3 : 2);
  const auto entry = file.find(name + "sub" + low);
  return entry == file.end() ? nullptr : &entry->second;
}

std::string read_file(const std::string& path) {
  std::ifstream file{path, std::ios::binary};
  if (!file) throw std::runtime_error{path + ": cannot be read"};
  return {std::istreambuf_iterator<char>{file}, {}};
}

const EdsFile& generated_eds(const std::string& name) {
  static std::map<std::string, EdsFile> files;
  const auto known = files.find(name);
  if (known != files.end()) return known->second;
  return files.emplace(name, read_eds(read_file(std::string{GENERATED_EDS_FOLDER} + "/" + name))).first->second;
}

}  // namespace eds_test
