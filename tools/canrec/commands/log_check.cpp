#include "tools/canrec/commands/log_check.hpp"

#include <fmt/format.h>

#include "tools/canrec/commands/command.hpp"
#include "tools/canrec/frames/log_frames.hpp"

namespace canrec {

namespace {

/// Damaged lines that are told; more are counted.
constexpr unsigned kMostTold = 10;

}  // namespace

Expected<std::string> check_log(const LogChoice& choice) {
  unsigned told = 0;
  const auto on_damage = [&told](std::string_view line) {
    if (told++ < kMostTold) tell(line);
  };
  auto log = LogFrames::open(choice.path, choice.interface,
                             choice.skip_damaged ? LogFrames::OnDamage{on_damage} : LogFrames::OnDamage{});
  if (!log) return tl::unexpected{log.error()};
  std::uint64_t frames = 0;
  for (;;) {
    const auto frame = (*log)->next();
    if (!frame) return tl::unexpected{frame.error()};
    if (!*frame) break;
    ++frames;
  }
  if ((*log)->damaged() > 0)
    tell(fmt::format("{}: {} damaged lines are left out", choice.path, (*log)->damaged()));
  if (frames > 0) return (*log)->interface();
  return fail(Status::Damaged, fmt::format("{}: expected a log of candump{}, there is no frame in it", choice.path,
                                           choice.interface.empty() ? "" : " with frames of " + choice.interface));
}

}  // namespace canrec
