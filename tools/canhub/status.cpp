#include "tools/canhub/status.hpp"

#include <array>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/socket.h>
#include <unistd.h>

#include "can/userbus/join.hpp"
#include "can/userbus/request.hpp"
#include "can/userbus/time.hpp"
#include "os/descriptor.hpp"

namespace canhub {

namespace {

using userbus::MemberStatistics;
using userbus::Operation;

constexpr double kNanoseconds = 1e9;  // of a second
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

/// Who decides which frame is next; nothing on a bus without a bit rate.
void print_arbiter(const nlohmann::json& arbitration, std::ostream& out) {
  if (!arbitration.is_object()) return;
  const std::string name = arbitration.value("arbiter", "");
  const std::string arbiter = arbitration.value("is_here", false) ? "this hub" : name.empty() ? "none" : name;
  out << fmt::format("arbiter at {} bit/s: {}, term {}\n", arbitration.value("bit_rate", 0U), arbiter,
                     arbitration.value("term", 0U));
}

/// What is known of the way to other hosts; nothing if the bus ends with its hub.
void print_trunk(int member, std::ostream& out) {
  std::string text(userbus::kLongestMessage, '\0');
  const userbus::Answer answer = userbus::ask(member, Operation::Trunk, 0, nullptr, 0, text.data(), text.size());
  if (answer.error != 0) return;
  const auto trunk = nlohmann::json::parse(text.substr(0, answer.size), nullptr, /*allow_exceptions=*/false);
  if (!trunk.is_object()) return;
  const auto count = [&](const char* name) { return trunk.value(name, std::uint64_t{0}); };
  const auto milliseconds = [&](const char* name) {
    constexpr double kNanosecondsOfMillisecond = 1e6;
    return trunk["back_after_ns"].value(name, 0.0) / kNanosecondsOfMillisecond;
  };
  out << fmt::format("\n{}: {}, cut {} times\n", trunk.value("url", ""),
                     trunk.value("up", false) ? "whole" : "cut", count("cuts"));
  print_arbiter(trunk["arbitration"], out);
  out << fmt::format(
      "frames: {} sent, {} received, {} under way; back after {:.3f} ms (median), {:.3f} ms (99 %)\n",
      count("sent"), count("received"), count("under_way"), milliseconds("median"), milliseconds("p99"));
  out << fmt::format("lost: {} under way and {} sent while it was cut, {} of others missed, {} of others late\n",
                     count("dropped"), count("lost"), count("missed"), count("late"));
  out << fmt::format("{:<48} {:<8} {:>10} {:>10}\n", "hub", "on bus", "received", "missed");
  for (const auto& hub : trunk["hubs"])
    out << fmt::format("{:<48} {:<8} {:>10} {:>10}\n", hub.value("name", ""),
                       hub.value("present", false) ? "yes" : "no", hub.value("received", std::uint64_t{0}),
                       hub.value("missed", std::uint64_t{0}));
}

/// Who is waited for in virtual and stepped time.
std::string waited_for(int member) {
  userbus::TimeState state{};
  userbus::ask(member, Operation::Time, userbus::kAskState, nullptr, 0, &state, sizeof state);
  if (state.acting != 0) return fmt::format("process {} has its turn", state.acting);
  return state.stands != 0 ? "it stands" : "all wait";
}

/// Whose time the bus has; nothing if it is the machine's.
void print_time(int member, std::ostream& out) {
  const userbus::TimePage* const page = userbus::map_time(member);
  if (page == nullptr) return;
  const double seconds = static_cast<double>(page->now_ns.load() - page->begin_ns) / kNanoseconds;
  if (page->mode == userbus::TimeMode::Scaled)
    out << fmt::format("time: scaled, {:g} times as quick\n", page->scale);
  else
    out << fmt::format("time: {}, {:.9f} s since its start, {}\n",
                       userbus::kTimeNames[static_cast<std::size_t>(page->mode)], seconds, waited_for(member));
  userbus::unmap_time(page);
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
  print_time(member.get(), out);
  out << fmt::format(kRow, "member", "pid", "interface", "sent", "received", "dropped", "refused");
  for (const MemberStatistics& row : rows) {
    if (row.process == getpid()) continue;  // who asks is a member too
    out << fmt::format(kRow, row.name, row.process, interface_of(member.get(), row.interface_index), row.sent,
                       row.received, row.dropped, row.refused);
  }
  print_trunk(member.get(), out);
  return true;
}

}  // namespace canhub
