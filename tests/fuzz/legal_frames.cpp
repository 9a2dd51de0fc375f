#include "tests/fuzz/legal_frames.hpp"

#include "tests/fuzz/check.hpp"

namespace fuzz {
namespace {

using canopen::Identifier;

Identifier identifier_if_valid(std::uint32_t cob_id) noexcept {
  return (cob_id & canopen::cob_id::kInvalid) != 0 ? 0 : canopen::identifier_in(cob_id);
}

const canopen::Entry* existing(const canopen::Dictionary& dictionary, std::size_t index, std::size_t sub_index) {
  const auto entry = dictionary.find(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub_index));
  require(entry.has_value(), "the table has the objects of the communication");
  return *entry;
}

}  // namespace

LegalFramesReader::LegalFramesReader(const canopen::Dictionary& dictionary)
    : dictionary_{dictionary}, emcy_{existing(dictionary, 0x1014, 0)} {
  for (std::size_t server = 0; server < kServers; ++server)
    servers_[server] = {existing(dictionary, 0x1200 + server, 1), existing(dictionary, 0x1200 + server, 2)};
  for (std::size_t number = 0; number < kPdos; ++number) {
    Pdo& pdo = pdos_[number];
    pdo.cob_id = existing(dictionary, 0x1800 + number, 1);
    pdo.count = existing(dictionary, 0x1A00 + number, 0);
    for (std::size_t i = 0; i < pdo.mapped.size(); ++i)
      pdo.mapped[i] = existing(dictionary, 0x1A00 + number, i + 1);
  }
}

unsigned LegalFramesReader::length(const Pdo& pdo) const noexcept {
  unsigned bits = 0;
  for (std::size_t i = 0; i < word(pdo.count); ++i) bits += word(pdo.mapped[i]) & 0xFF;
  return (bits + 7) / 8;
}

LegalFrames LegalFramesReader::read() const noexcept {
  LegalFrames legal;
  legal.error_control = canopen::function_code::kErrorControl + dictionary_.node_id();
  legal.emcy = identifier_if_valid(word(emcy_));
  for (std::size_t server = 0; server < kServers; ++server) {
    const Identifier request = identifier_if_valid(word(servers_[server][0]));
    const Identifier response = identifier_if_valid(word(servers_[server][1]));
    if (request == 0 || response == 0) continue;
    legal.requests[server] = request;
    legal.responses[server] = response;
  }
  for (std::size_t number = 0; number < kPdos; ++number) {
    const Identifier identifier = identifier_if_valid(word(pdos_[number].cob_id));
    if (identifier != 0) legal.pdos[number] = {identifier, length(pdos_[number])};
  }
  return legal;
}

}  // namespace fuzz
