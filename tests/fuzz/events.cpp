#include "tests/fuzz/events.hpp"

#include "libcanopen/sdo/command.hpp"

namespace fuzz {

using canopen::Entry;
using canopen::Frame;
using canopen::Identifier;

namespace {

constexpr std::array<canopen::Duration, 8> kScales{std::chrono::microseconds{1},   std::chrono::microseconds{100},
                                                   std::chrono::milliseconds{1},   std::chrono::milliseconds{10},
                                                   std::chrono::milliseconds{100}, std::chrono::seconds{1},
                                                   std::chrono::seconds{10},       std::chrono::minutes{1}};
constexpr std::array<std::uint8_t, 8> kCommands{1, 1, 2, 128, 129, 130, 3, 255};
constexpr std::size_t kErrors = canopen::kCommunicationErrors.size();
constexpr std::uint8_t kMostCounter = 240;

}  // namespace

Events::Events(Station& station) : station_{station} {}

void Events::play(std::span<const std::uint8_t> bytes) {
  static constexpr std::array<Handler, 16> kHandlers{
      &Events::request,
      &Events::upload,
      &Events::download,
      &Events::upload_segments,
      &Events::download_segment,
      &Events::block_segments,
      &Events::block_control,
      &Events::known,
      &Events::any,
      &Events::remote,
      &Events::time,
      &Events::deadline,
      &Events::value,
      &Events::nmt,
      &Events::sync,
      &Events::owner,
  };
  source_ = ByteSource{bytes};
  clients_ = {};
  counter_ = 0;
  for (int i = 0; i < kMost && !source_.is_empty(); ++i) {
    const std::uint8_t head = source_.u8();
    (this->*kHandlers[head & 0xF])(head >> 4);
  }
  station_.finish_run();
}

void Events::ask(std::size_t server, Frame request) {
  const Identifier identifier = station_.legal().requests[server];
  const Identifier under = identifier != 0 ? identifier : 0x605;
  request.id = under & canopen::cob_id::kLong;
  request.extended = under != request.id;
  clients_[server].note(request);
  station_.receive(request);
}

const Entry& Events::entry() {
  const auto entries = station_.dictionary().entries();
  return entries[source_.u16() % entries.size()];
}

void Events::request(unsigned argument) {
  Frame frame{.length = 8};
  source_.fill(frame.data);
  ask(argument % kServers, frame);
}

void Events::upload(unsigned argument) {
  const Entry& at = entry();
  const bool is_block = (argument & 4) != 0;
  Frame frame = canopen::sdo::response(0, is_block ? 0xA4 : 0x40, {at.index, at.sub_index}, 0);
  if (is_block) {
    frame.data[4] = source_.u8();
    frame.data[5] = (argument & 8) != 0 ? source_.u8() : std::uint8_t{0};
  }
  ask((argument & 3) % kServers, frame);
}

void Events::download(unsigned argument) {
  const Entry& at = entry();
  unsigned size = (argument & 4) != 0 ? source_.u8() : at.size;
  if (size == 0) size = 1;
  const bool is_block = (argument & 8) != 0;
  const bool is_expedited = !is_block && size <= 4;
  const unsigned command = is_block ? 0xC6U : is_expedited ? 0x23U | (4 - size) << 2 : 0x21U;
  const std::uint32_t word = is_expedited ? source_.u32() : size;
  ask((argument & 3) % kServers,
      canopen::sdo::response(0, static_cast<std::uint8_t>(command), {at.index, at.sub_index}, word));
}

void Events::upload_segments(unsigned argument) {
  const std::size_t server = (argument & 3) % kServers;
  for (unsigned i = 0; i <= argument >> 2; ++i) ask(server, clients_[server].upload_segment());
}

void Events::download_segment(unsigned argument) {
  const std::size_t server = (argument & 3) % kServers;
  const std::uint8_t control = source_.u8();
  ask(server, clients_[server].download_segment(control & 7U, (argument & 4) != 0, control));
}

void Events::block_segments(unsigned argument) {
  const std::size_t server = (argument & 3) % kServers;
  const std::uint8_t control = source_.u8();
  const unsigned count = control & 0x7FU;
  const unsigned gap = (argument & 8) != 0 ? 1 + count / 2 : 0;
  for (unsigned number = 1; number <= count; ++number) {
    const bool is_last = (argument & 4) != 0 && number == count;
    if (number != gap) ask(server, Client::block_segment(number, is_last, control));
  }
}

void Events::block_control(unsigned argument) {
  const std::size_t server = (argument & 3) % kServers;
  Frame frame{.length = 8};
  switch (argument >> 2) {
    case 0:
      frame = clients_[server].end_block(source_.u8() & 7U);
      break;
    case 1:
      frame.data[0] = 0xA3;
      break;
    case 2:
      frame.data = {0xA2, source_.u8(), 0x7F};
      frame.data[2] = source_.u8();
      break;
    default:
      frame.data[0] = 0xA1;
      break;
  }
  ask(server, frame);
}

/// Identifiers that mean something to the node, or nearly.
Identifier Events::known_identifier(unsigned which) const {
  canopen::Dictionary& dictionary = station_.dictionary();
  const auto value = [&](unsigned index, unsigned sub_index) {
    const auto at = dictionary.find(static_cast<std::uint16_t>(index), static_cast<std::uint8_t>(sub_index));
    return static_cast<std::uint32_t>(at ? dictionary.stored(**at) : 0);
  };
  const auto in = [&](unsigned index, unsigned sub) { return canopen::identifier_in(value(index, sub)); };
  const auto subscriptions = station_.node().subscriptions();
  switch (which >> 4 & 7) {
    case 0:
      return in(0x1400 + (which & 3), 1);
    case 1:
      return in(0x1800 + (which & 3), 1);
    case 2:
      return in(0x1200 + which % 3, 1 + (which >> 2 & 1));
    case 3:
      return in(std::array{0x1005U, 0x1012U, 0x1014U, 0x1000U}[which & 3], 0);
    case 4:
      return 0x700 + (dictionary.node_id() + (which & 1) * (which & 0xF));
    case 5:
      return 0x700 + (value(0x1016, 1 + which % 3) >> 16 & 0x7F);
    default:
      return subscriptions[which % subscriptions.size()].identifier;
  }
}

void Events::known(unsigned argument) {
  const Identifier identifier = known_identifier(source_.u8());
  Frame frame = canopen::frame_under(identifier, static_cast<std::uint8_t>(argument > 8 ? 8 : argument));
  source_.fill(std::span{frame.data}.first(frame.length));
  station_.receive(frame);
}

void Events::any(unsigned argument) {
  const std::uint32_t word = source_.u32();
  const bool is_extended = (word & canopen::cob_id::kExtended) != 0;
  Frame frame{.id = word & (is_extended ? canopen::cob_id::kLong : canopen::cob_id::kBase),
              .length = static_cast<std::uint8_t>(argument > 8 ? 8 : argument),
              .remote = (word & canopen::cob_id::kNoRemote) != 0,
              .extended = is_extended};
  if (!frame.remote) source_.fill(std::span{frame.data}.first(frame.length));
  station_.receive(frame);
}

void Events::remote(unsigned argument) {
  Frame frame =
      canopen::frame_under(known_identifier(source_.u8()), static_cast<std::uint8_t>(argument > 8 ? 0 : argument));
  frame.remote = true;
  station_.receive(frame);
}

void Events::time(unsigned argument) {
  station_.pass(kScales[argument & 7] * source_.u8(), (argument & 8) != 0);
}

void Events::deadline(unsigned argument) {
  for (unsigned i = 0; i <= argument; ++i) station_.pass_to_deadline();
}

void Events::value(unsigned argument) {
  static constexpr std::array<std::uint16_t, 4> kValues{0x6041, 0x6063, 0x606C, 0x2031};
  const auto found = station_.dictionary().find(kValues[argument & 3], 0);
  station_.set(
      argument < 8 ? **found : **station_.dictionary().find(0x2050, static_cast<std::uint8_t>(argument & 7) + 1),
      argument < 8 ? source_.u16() : source_.u8() & 1);
}

void Events::nmt(unsigned argument) {
  const std::uint8_t node_id = (argument & 8) != 0 ? std::uint8_t{0} : std::uint8_t{5};
  station_.receive(Frame{.length = 2, .data = {kCommands[argument & 7], node_id}});
}

void Events::sync(unsigned argument) {
  const auto cob_id =
      static_cast<std::uint32_t>(station_.dictionary().stored(**station_.dictionary().find(0x1005, 0)));
  Frame frame = canopen::frame_under(canopen::identifier_in(cob_id), argument & 1);
  for (unsigned i = 0; i <= argument >> 2; ++i) {
    counter_ = static_cast<std::uint8_t>(counter_ % kMostCounter + 1);
    if ((argument & 2) != 0) counter_ = source_.u8();
    if (frame.length != 0) frame.data[0] = counter_;
    station_.receive(frame);
  }
}

void Events::owner(unsigned argument) {
  const auto event = static_cast<OwnerEvent>(argument);
  if (event > OwnerEvent::Answers) return node_event(event);
  if (event == OwnerEvent::Answers) {
    const std::uint8_t bits = source_.u8();
    station_.answers() = {(bits & 1) == 0, (bits & 2) == 0, (bits & 4) == 0, (bits & 8) == 0};
    return;
  }
  DomainMode& mode = station_.domains()[source_.u8() % kDomains].mode;
  if (event == OwnerEvent::DomainSizes) {
    mode.size = source_.u16() % 4096;
    mode.most = source_.u16();
  } else {
    const std::uint8_t bits = source_.u8();
    mode.unknown_size = (bits & 1) != 0;
    mode.refuse_begin = (bits & 2) != 0;
    mode.refuse_end = (bits & 4) != 0;
    mode.refuse_at = (bits & 8) != 0 ? source_.u16() : std::uint16_t{0xFFFF};
  }
}

void Events::node_event(OwnerEvent event) {
  const std::uint8_t a = source_.u8();
  const auto error = canopen::kCommunicationErrors[a % kErrors].error;
  switch (event) {
    case OwnerEvent::RaiseError:
      return station_.act([=](auto& node, auto) { node.raise_error(0xFF00U | (a & 0x3F), a >> 6, a); });
    case OwnerEvent::ClearError:
      return station_.act([=](auto& node, auto) { node.clear_error(0xFF00U | (a & 0x3F), a >> 6); });
    case OwnerEvent::Report:
      return station_.act([=](auto& node, auto now) { node.report(error, now); });
    case OwnerEvent::Recovery:
      return station_.act([=](auto& node, auto now) { node.report_recovery(error, now); });
    case OwnerEvent::Restart:
      return station_.act([](auto& node, auto now) { node.start(now); });
    case OwnerEvent::ErrorBehaviour:
      return station_.act([=](auto& node, auto) { node.apply_error_behaviour(a & 3); });
    case OwnerEvent::Emergency:
      return station_.act([=](auto& node, auto) { node.send_emcy(0x8100U | a, a, {a, 1, 2, 3, 4}); });
    case OwnerEvent::Heartbeat: {
      const Frame frame{.id = 0x700U + (a & 0x7FU), .length = 1, .data = {source_.u8()}};
      return station_.receive(frame);
    }
    case OwnerEvent::TimeOfDay: {
      const Frame frame{.id = 0x100, .length = 6, .data = {a, 1, 2, 3, 4, 5}};
      return station_.receive(frame);
    }
    default:
      return;
  }
}

}  // namespace fuzz
