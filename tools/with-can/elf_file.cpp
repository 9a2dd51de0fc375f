#include "tools/with-can/elf_file.hpp"

#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <limits>

#include <elf.h>
#include <link.h>

namespace with_can {

namespace {

constexpr std::uint8_t kOwnClass = sizeof(void*) == sizeof(std::uint64_t) ? ELFCLASS64 : ELFCLASS32;
constexpr std::uint8_t kOwnOrder = std::endian::native == std::endian::little ? ELFDATA2LSB : ELFDATA2MSB;

/// Longest path of a loader that is read (bytes).
constexpr std::size_t kLongestPath = 4096;

/// Reads a @p Value at @p offset; false if the file ends before.
template <class Value>
bool read_at(std::ifstream& file, std::uint64_t offset, Value& value) {
  if (offset > static_cast<std::uint64_t>(std::numeric_limits<std::streamoff>::max())) return false;
  file.clear();
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(reinterpret_cast<char*>(&value), sizeof value);
  return file.gcount() == static_cast<std::streamsize>(sizeof value);
}

std::string read_path(std::ifstream& file, std::uint64_t offset, std::uint64_t size) {
  std::string path(size < kLongestPath ? size : kLongestPath, '\0');
  file.clear();
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(path.data(), static_cast<std::streamsize>(path.size()));
  path.resize(static_cast<std::size_t>(file.gcount()));
  return path.substr(0, path.find('\0'));
}

/// Path of the loader; nothing if the file is cut off.
std::optional<std::string> read_loader(std::ifstream& file, const ElfW(Ehdr) & head) {
  for (unsigned i = 0; i < head.e_phnum; ++i) {
    ElfW(Phdr) segment{};
    if (!read_at(file, head.e_phoff + std::uint64_t{i} * head.e_phentsize, segment)) return std::nullopt;
    if (segment.p_type == PT_INTERP) return read_path(file, segment.p_offset, segment.p_filesz);
  }
  return std::string{};
}

}  // namespace

bool claims_to_be_elf(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  std::array<char, SELFMAG> magic{};
  return read_at(file, 0, magic) && std::memcmp(magic.data(), ELFMAG, SELFMAG) == 0;
}

std::optional<ElfFile> read_elf(const std::filesystem::path& path) {
  std::ifstream file{path, std::ios::binary};
  std::array<char, EI_NIDENT> identity{};
  if (!read_at(file, 0, identity) || std::memcmp(identity.data(), ELFMAG, SELFMAG) != 0) return std::nullopt;
  ElfFile found{.word_class = static_cast<std::uint8_t>(identity[EI_CLASS]),
                .byte_order = static_cast<std::uint8_t>(identity[EI_DATA]),
                .machine = 0,
                .loader = {}};
  if (found.word_class != kOwnClass || found.byte_order != kOwnOrder) return found;
  ElfW(Ehdr) head{};
  if (!read_at(file, 0, head)) return std::nullopt;
  found.machine = head.e_machine;
  const std::optional<std::string> loader = read_loader(file, head);
  if (!loader) return std::nullopt;
  found.loader = *loader;
  return found;
}

}  // namespace with_can
