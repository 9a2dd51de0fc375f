#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace with_can {

/// What the head of an ELF file tells of the machine and the C library that it was built for.
struct ElfFile {
  std::uint8_t word_class = 0;  ///< ELFCLASS32 or ELFCLASS64
  std::uint8_t byte_order = 0;  ///< ELFDATA2LSB or ELFDATA2MSB
  std::uint16_t machine = 0;    ///< EM_…; of a file in the byte order of this machine
  std::string loader;           ///< path of its dynamic loader (PT_INTERP); empty: it is linked statically
};

/// Reads @p path; nothing if it is no ELF file, or one that is cut off. The loader is looked for only in a file of
/// this machine's word size and byte order.
std::optional<ElfFile> read_elf(const std::filesystem::path& path);

/// Whether @p path begins as an ELF file does, whatever follows.
bool claims_to_be_elf(const std::filesystem::path& path);

}  // namespace with_can
