#pragma once

#include <array>
#include <span>

#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/od/dictionary.hpp"
#include "tests/fuzz/table.hpp"

namespace fuzz {

/// What the dictionary of a node says of the frames that it may send.
struct LegalFrames {
  struct Pdo {
    canopen::Identifier identifier = 0;  ///< 0: not valid
    unsigned length = 0;
  };
  canopen::Identifier error_control = 0;
  canopen::Identifier emcy = 0;                          ///< 0: none
  std::array<canopen::Identifier, kServers> requests{};  ///< 0: the server does not exist
  std::array<canopen::Identifier, kServers> responses{};
  std::array<Pdo, kPdos> pdos{};
};

/// Reads LegalFrames from a dictionary.
class LegalFramesReader {
 public:
  explicit LegalFramesReader(const canopen::Dictionary& dictionary);
  LegalFrames read() const noexcept;

 private:
  using Entry = const canopen::Entry*;
  struct Pdo {
    Entry cob_id = nullptr, count = nullptr;
    std::array<Entry, 9> mapped{};
  };
  std::uint32_t word(Entry entry) const noexcept { return static_cast<std::uint32_t>(dictionary_.stored(*entry)); }
  unsigned length(const Pdo& pdo) const noexcept;

  const canopen::Dictionary& dictionary_;
  Entry emcy_;
  std::array<std::array<Entry, 2>, kServers> servers_{};
  std::array<Pdo, kPdos> pdos_{};
};

}  // namespace fuzz
