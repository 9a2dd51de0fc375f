#include <chrono>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>

#include "can/userbus/request.hpp"
#include "can/userbus/time.hpp"
#include "os/descriptor.hpp"
#include "text/duration.hpp"
#include "tools/axisctl/commands/command.hpp"

namespace axisctl {
namespace {

using Nanoseconds = std::chrono::nanoseconds;

/// What the words of step say.
struct StepWish {
  std::string duration{};
  std::string path{};  ///< of the bus; empty: the default
};

constexpr Nanoseconds kLongest = std::chrono::hours{365 * 24};

/// Lets the time of the bus of @p member go on by @p step; the present then, and errno of what went wrong.
tl::expected<Nanoseconds, int> step_by(int member, Nanoseconds step) {
  const std::int64_t count = step.count();
  const os::Descriptor reply{userbus::post(member, userbus::Operation::Step, 0, &count, sizeof count)};
  if (!reply) return tl::unexpected{errno};
  pollfd wanted{reply.get(), POLLIN, 0};  // a step takes as long as those who act in it
  ::poll(&wanted, 1, -1);
  std::int64_t now = 0;
  const userbus::Answer answer = userbus::take_reply(reply.get(), &now, sizeof now);
  if (answer.error != 0) return tl::unexpected{answer.error};
  return Nanoseconds{now};
}

Expected<void> step(const StepWish& wish) {
  const auto duration = text::duration(wish.duration, kLongest);
  if (!duration)
    return fail(ExitStatus::Usage,
                fmt::format("DURATION: expected a number of ns, us, ms, s, min or h, at most a year, got \"{}\"",
                            wish.duration));
  userbus::Path path{};
  if (!(wish.path.empty() ? userbus::default_path(path) : userbus::copy_path(wish.path.c_str(), path)))
    return fail(ExitStatus::Usage,
                fmt::format("--path: expected a path of at most {} bytes", userbus::kLongestPath));
  const userbus::Joined joined = userbus::join(path, nullptr, userbus::Kind::Port, SOCK_CLOEXEC);
  const os::Descriptor member{joined.descriptor};
  if (!member)
    return fail(ExitStatus::NotReachable, fmt::format("{}: {}", path.text, userbus::text_of(joined.error)));
  const auto now = step_by(member.get(), *duration);
  if (!now && (now.error() == EOPNOTSUPP || now.error() == EINVAL))
    return fail(ExitStatus::Refused, fmt::format("{}: its time is not stepped: canhub --time stepped", path.text));
  if (!now) return fail(ExitStatus::CutOff, fmt::format("{}: {}", path.text, std::strerror(now.error())));
  return print_line(
      fmt::format("{:.9f}", std::chrono::duration<double>{*now - Nanoseconds{userbus::kFirstInstant}}.count()));
}

}  // namespace

void add_step(CLI::App& app, Run& run) {
  CLI::App& sub = subcommand(app, "step", "Let the stepped time of a user-space bus go on");
  const auto wish = std::make_shared<StepWish>();
  sub.add_option("DURATION", wish->duration, "By how much: 10ms, 1.5s, 1h")->required()->type_name("");
  sub.add_option("--path", wish->path, "Path of the bus (default: $CAN_BUS, as canhub has it)")->type_name("PATH");
  sub.callback([&run, wish] { run = [wish](const Settings&) { return step(*wish); }; });
}

}  // namespace axisctl
