#include "tools/axisctl/runs/compare/report.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace runs {
namespace {

using nlohmann::json;
using std::chrono::nanoseconds;

double seconds_since(nanoseconds begin, nanoseconds at) {
  return std::chrono::duration<double>{at - begin}.count();
}

std::string bits_text(const ByteDifference& byte) {
  std::vector<unsigned> bits;
  for (unsigned bit = 0; bit < 8; ++bit)
    if ((unsigned{byte.bits()} >> bit & 1U) != 0) bits.push_back(bit);
  return fmt::format("byte {}: {:02X} and {:02X}, bit{} {}", byte.byte, byte.a, byte.b,
                     bits.size() == 1 ? "" : "s", fmt::join(bits, ", "));
}

/// "1.234567 605#40...", or nothing.
std::string side_text(const std::optional<LoggedFrame>& logged, nanoseconds begin, bool has_times) {
  if (!logged) return "-";
  const std::string frame = text_of(*logged);
  return has_times ? fmt::format("{:11.6f} {}", seconds_since(begin, logged->at), frame) : frame;
}

/// The two sides of @p pair, with their lines.
std::string pair_text(std::string_view mark, const FramePair& pair, const Compared& compared) {
  const auto place = [](const std::optional<LoggedFrame>& logged) {
    return logged ? fmt::format("{}", logged->place) : std::string{};
  };
  return fmt::format("  {:>3} {:>8} {:<40} {:>8} {}\n", mark, place(pair.a),
                     side_text(pair.a, compared.begin_a, compared.has_times), place(pair.b),
                     side_text(pair.b, compared.begin_b, compared.has_times));
}

std::string what_differs(const Difference& difference) {
  const auto& [a, b] = difference.at;
  switch (difference.kind) {
    case DifferenceKind::Identifier:
      return "another frame";
    case DifferenceKind::Format:
      return "frames of another format";
    case DifferenceKind::Length:
      return fmt::format("{} and {} bytes", a->frame.length, b->frame.length);
    case DifferenceKind::Data: {
      std::vector<std::string> bytes;
      std::ranges::transform(difference.bytes, std::back_inserter(bytes), bits_text);
      return fmt::format("{}", fmt::join(bytes, "; "));
    }
    case DifferenceKind::Time:
      return "the same frame at another time";
    case DifferenceKind::End:
      return a ? "only the first log has more frames" : "only the second log has more frames";
  }
  return "";
}

/// What there is to say of a frame that comes later in the other log.
std::string order_text(const Difference& difference) {
  std::string text;
  if (difference.a_in_b != 0)
    text += fmt::format("  the second log has the frame of the first one {} frame{} later\n", difference.a_in_b,
                        difference.a_in_b == 1 ? "" : "s");
  if (difference.b_in_a != 0)
    text += fmt::format("  the first log has the frame of the second one {} frame{} later\n", difference.b_in_a,
                        difference.b_in_a == 1 ? "" : "s");
  return text;
}

std::string times_text(const Compared& compared) {
  const TimeFigures& times = compared.times;
  if (!compared.has_times) return "times are not compared: a log has none\n";
  if (times.first_place == 0) return "all times before are the same, to the microsecond\n";
  return fmt::format(
      "times: the first that differs is line {} of the first log ({:+.6f} s), at most {:+.6f} s at line {}\n",
      times.first_place, std::chrono::duration<double>{times.first}.count(),
      std::chrono::duration<double>{times.largest}.count(), times.largest_place);
}

json frame_json(const std::optional<LoggedFrame>& logged, nanoseconds begin, bool has_times) {
  if (!logged) return nullptr;
  json frame{{"place", logged->place}, {"frame", text_of(*logged)}};
  if (has_times) frame["t_s"] = seconds_since(begin, logged->at);
  return frame;
}

json pairs_json(const std::vector<FramePair>& pairs, const Compared& compared) {
  json list = json::array();
  for (const FramePair& pair : pairs)
    list.push_back({{"a", frame_json(pair.a, compared.begin_a, compared.has_times)},
                    {"b", frame_json(pair.b, compared.begin_b, compared.has_times)}});
  return list;
}

json difference_json(const Difference& difference, const Compared& compared) {
  json value{{"kind", kDifferenceKinds[static_cast<std::size_t>(difference.kind)]},
             {"what", what_differs(difference)},
             {"a", frame_json(difference.at.a, compared.begin_a, compared.has_times)},
             {"b", frame_json(difference.at.b, compared.begin_b, compared.has_times)},
             {"before", pairs_json(difference.before, compared)},
             {"after", pairs_json(difference.after, compared)},
             {"a_in_b", difference.a_in_b},
             {"b_in_a", difference.b_in_a}};
  for (const auto& [key, words] : {std::pair{"a", &difference.words_a}, std::pair{"b", &difference.words_b}})
    if (!words->empty()) value[key]["means"] = *words;
  value["bytes"] = json::array();
  for (const ByteDifference& byte : difference.bytes)
    value["bytes"].push_back({{"byte", byte.byte}, {"a", byte.a}, {"b", byte.b}, {"bits", byte.bits()}});
  value["last"] = json::array();
  for (const Former& former : difference.formers) {
    json item = frame_json(former.frame, compared.begin_a, compared.has_times);
    item["what"] = former.what;
    item["means"] = former.words;
    value["last"].push_back(std::move(item));
  }
  return value;
}

}  // namespace

std::string text_of(const Compared& compared, const std::string& a, const std::string& b) {
  if (!compared.difference)
    return fmt::format("{} and {} are the same: {} frames\n", a, b, compared.frames) + times_text(compared);
  const Difference& difference = *compared.difference;
  std::string text =
      fmt::format("{} and {} differ behind {} frames: {}\n", a, b, compared.frames, what_differs(difference));
  if (!difference.words_a.empty()) text += fmt::format("  first log:  {}\n", difference.words_a);
  if (!difference.words_b.empty()) text += fmt::format("  second log: {}\n", difference.words_b);
  text += order_text(difference);
  text += fmt::format("\n  {:>3} {:>8} {:<40} {:>8} {}\n", "", "line", "first log", "line", "second log");
  for (const FramePair& pair : difference.before) text += pair_text("", pair, compared);
  text += pair_text("->", difference.at, compared);
  for (const FramePair& pair : difference.after) text += pair_text("", pair, compared);
  if (!difference.formers.empty()) text += "\nlast before it:\n";
  for (const Former& former : difference.formers)
    text += fmt::format("  {:<16} {:>8} {:<40} {}\n", former.what, former.frame.place,
                        side_text(former.frame, compared.begin_a, compared.has_times), former.words);
  return text + times_text(compared);
}

json json_of(const Compared& compared, const std::string& a, const std::string& b) {
  json value{{"a", a}, {"b", b}, {"same", !compared.difference}, {"frames", compared.frames}};
  if (compared.has_times) {
    const auto of = [](nanoseconds time, std::uint64_t place) {
      return place == 0 ? json{} : json{{"place", place}, {"s", std::chrono::duration<double>{time}.count()}};
    };
    value["times"] = {{"first", of(compared.times.first, compared.times.first_place)},
                      {"largest", of(compared.times.largest, compared.times.largest_place)}};
  }
  if (compared.difference) value["difference"] = difference_json(*compared.difference, compared);
  value["remarks"] = compared.remarks;
  return value;
}

}  // namespace runs
