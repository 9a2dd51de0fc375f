#include "tools/canhub/status.hpp"

#include <array>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include "can/userbus/join.hpp"
#include "can/userbus/request.hpp"
#include "os/descriptor.hpp"

namespace canhub {

namespace {

using userbus::MemberStatistics;
using userbus::Operation;

constexpr std::string_view kRow = "{:<24} {:>8} {:<15} {:>10} {:>10} {:>8} {:>8}\n";

std::string interface_of(int member, int index) {
  if (index < 0) return "-";
  if (index == 0) return "any";
  std::array<char, sizeof(userbus::InterfaceEntry::name)> name{};
  const userbus::Answer answer =
      userbus::ask(member, Operation::InterfaceName, index, nullptr, 0, name.data(), name.size());
  return answer.error == 0 ? std::string{name.data(), answer.size} : std::to_string(index);
}

/// All rows, one message after the other; false if the hub has gone meanwhile.
bool read_statistics(int member, userbus::BusStatistics& bus, std::vector<MemberStatistics>& rows) {
  std::vector<std::byte> room(userbus::kLongestMessage);
  do {
    const userbus::Answer answer = userbus::ask(member, Operation::Statistics, static_cast<int>(rows.size()),
                                                nullptr, 0, room.data(), room.size());
    if (answer.error != 0 || answer.size < sizeof bus) return false;
    std::memcpy(&bus, room.data(), sizeof bus);
    const std::size_t count = (answer.size - sizeof bus) / sizeof(MemberStatistics);
    if (count == 0) return true;
    rows.resize(rows.size() + count);
    std::memcpy(&rows[rows.size() - count], &room[sizeof bus], count * sizeof(MemberStatistics));
  } while (rows.size() < bus.members);
  return true;
}

}  // namespace

bool print_status(const userbus::Path& path, std::ostream& out, std::ostream& errors) {
  const userbus::Joined joined = userbus::join(path, nullptr, userbus::Kind::Port, SOCK_CLOEXEC);
  const os::Descriptor member{joined.descriptor};
  userbus::BusStatistics bus{};
  std::vector<MemberStatistics> rows;
  if (!member || !read_statistics(member.get(), bus, rows)) {
    const bool nobody = joined.error == userbus::JoinError::NotServed || joined.error == userbus::JoinError::None;
    errors << "canhub: " << path.text
           << (nobody ? ": is not served" : std::string{": "} + userbus::text_of(joined.error)) << '\n';
    return false;
  }
  const std::string rate = bus.bit_rate == 0 ? "no bit rate" : fmt::format("{} bit/s", bus.bit_rate);
  out << fmt::format("bus {}: {}, {} frames\n", path.text, rate, bus.frames);
  out << fmt::format(kRow, "member", "pid", "interface", "sent", "received", "dropped", "refused");
  for (const MemberStatistics& row : rows) {
    if (row.process == getpid()) continue;  // who asks is a member too
    out << fmt::format(kRow, row.name, row.process, interface_of(member.get(), row.interface_index), row.sent,
                       row.received, row.dropped, row.refused);
  }
  return true;
}

}  // namespace canhub
