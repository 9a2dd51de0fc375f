#include <csignal>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tools/canrec/commands/command.hpp"
#include "tools/canrec/commands/limits.hpp"
#include "tools/canrec/commands/log_check.hpp"
#include "tools/canrec/frames/log_frames.hpp"
#include "tools/canrec/play/player.hpp"
#include "tools/canrec/play/read_ahead.hpp"
#include "tools/canrec/server/recording_frames.hpp"

namespace canrec {

namespace {

struct PlayWords {
  LogChoice source;
  std::string onto;
  std::string speed;
  bool fast = false;
  std::string from;
  std::string to;
};

/// What the options ask of a player.
struct Wishes {
  bus::Address onto;
  Pace pace{1.0};
  TimeRange range;
};

Expected<std::optional<Moment>> moment_of(const char* option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto moment = read_moment(text);
  if (!moment) return fail(Status::Usage, fmt::format("{}: {}, got \"{}\"", option, moment.error(), text));
  return *moment;
}

Expected<Wishes> wishes_of(const PlayWords& words) {
  auto onto = bus::parse_address(words.onto);
  if (!onto) return fail(Status::Usage, fmt::format("--onto: expected {}, got \"{}\"", onto.error(), words.onto));
  Wishes wishes{.onto = *std::move(onto), .range = {}};
  if (!words.speed.empty()) {
    const auto speed = read_speed(words.speed);
    if (!speed)
      return fail(Status::Usage,
                  fmt::format("--speed: expected a number above 0, up to 1000000, got \"{}\"; --fast "
                              "does not wait at all",
                              words.speed));
    wishes.pace = Pace{*speed};
  }
  if (words.fast) wishes.pace = Pace{0.0};
  const auto from = moment_of("--from", words.from);
  if (!from) return tl::unexpected{from.error()};
  const auto to = moment_of("--to", words.to);
  if (!to) return tl::unexpected{to.error()};
  wishes.range = {.from = *from, .to = *to};
  return wishes;
}

std::string text_of(const Player::Figures& figures, bool waits) {
  const auto count = [](std::chrono::nanoseconds time, double unit) {
    return static_cast<double>(time.count()) / unit;
  };
  constexpr double kSecond = 1e9;
  constexpr double kMillisecond = 1e6;
  std::string text = fmt::format("{} frames sent in {:.3f} s", figures.sent, count(figures.duration, kSecond));
  if (waits) text += fmt::format(", {:.3f} ms late at most", count(figures.latest, kMillisecond));
  if (figures.errors > 0) text += fmt::format("; {} error frames left out", figures.errors);
  if (figures.refused > 0) text += fmt::format("; {} that the bus does not carry", figures.refused);
  return text;
}

/// Ends the program by @p signal, as if it had not been held back.
void end_by(int signal) {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, signal);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
  sigprocmask(SIG_UNBLOCK, &set, nullptr);
}

Expected<void> play_frames(FrameSource& frames, const Wishes& wishes) {
  auto connection = open_bus(wishes.onto);
  if (!connection) return tl::unexpected{connection.error()};
  Player player{*std::move(connection), wishes.onto.text, wishes.pace};
  ReadAhead ahead{frames};
  const auto whole = player.play(ahead, wishes.range);
  if (!whole) return tl::unexpected{whole.error()};
  tell(text_of(player.figures(), wishes.pace.waits()));
  if (!*whole) end_by(player.signal());
  return {};
}

Expected<void> play_recording(const PlayWords& words, const Wishes& wishes, const nats::ServerOptions& options) {
  const auto url = read_url(words.source.path, "RECORDING", options);
  if (!url) return tl::unexpected{url.error()};
  auto store = Store::open(url->server);
  if (!store) return tl::unexpected{store.error()};
  const auto recording = store->find(url->name);
  if (!recording) return tl::unexpected{recording.error()};
  auto messages = Messages::open(*store, *recording);
  if (!messages) return tl::unexpected{messages.error()};
  RecordingFrames frames{*std::move(messages)};
  auto done = play_frames(frames, wishes);
  if (done) tell(fmt::format("in the recording: {}", frames.transcript().text()));
  return done;
}

Expected<void> play_log(const PlayWords& words, const Wishes& wishes) {
  const auto interface = check_log(words.source);
  if (!interface) return tl::unexpected{interface.error()};
  auto log = LogFrames::open(words.source.path, *interface, [](std::string_view) {});
  if (!log) return tl::unexpected{log.error()};
  return play_frames(**log, wishes);
}

Expected<void> play(const PlayWords& words, const nats::ServerOptions& options) {
  const auto wishes = wishes_of(words);
  if (!wishes) return tl::unexpected{wishes.error()};
  if (nats::is_url(words.source.path)) return play_recording(words, *wishes, options);
  if (options.are_given()) return fail(Status::Usage, "--credentials, --tls-... and --plain go with a URL");
  return play_log(words, *wishes);
}

}  // namespace

void add_play(CLI::App& app, Run& run) {
  CLI::App& sub = subcommand(app, "play", "Send the frames of a recording or a log onto a bus");
  const auto words = std::make_shared<PlayWords>();
  sub.add_option("SOURCE", words->source.path, "nats://HOST[:PORT]/RECORDING or tls://..., or a log of candump")
      ->required()
      ->type_name("FILE");
  sub.add_option("--onto", words->onto, "CAN interface, or the URL of a bus as axisd takes it")
      ->required()
      ->type_name("IF");
  auto* const speed =
      sub.add_option("--speed", words->speed, "so many times as fast (default: 1)")->type_name("X");
  sub.add_flag("--fast", words->fast, "as fast as the bus takes it")->excludes(speed);
  sub.add_option("--from", words->from, "begin at T: seconds behind the first frame, or @ and a time stamp")
      ->type_name("T");
  sub.add_option("--to", words->to, "end before T")->type_name("T");
  sub.add_option("--interface", words->source.interface, "the frames of this interface, if a log has several")
      ->type_name("NAME");
  sub.add_flag("--skip-damaged", words->source.skip_damaged, "leave lines of a log out that are damaged");
  sub.callback(
      [&run, words] { run = [words](const nats::ServerOptions& options) { return play(*words, options); }; });
}

}  // namespace canrec
