// Lines and files that programs write for programs: what is taken is written as it is read.
#include <array>
#include <chrono>
#include <cstring>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "control/methods.hpp"
#include "control/protocol.hpp"
#include "control/words.hpp"
#include "record/candump.hpp"
#include "record/reader.hpp"
#include "tests/fakes/temporary_directory.hpp"
#include "tests/fuzz/readers/readers.hpp"
#include "tests/record/recorded.hpp"

namespace fuzz {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return parts;
}

std::string request_rule(std::string_view line) {
  const auto request = control::parse_request(line);
  if (!request) return message_rule(request.error().error.message);
  const std::string said = control::request_line(1, request->method, request->params);
  const auto again = control::parse_request(said.substr(0, said.size() - 1));
  if (!again) return fmt::format("{} is not read again", said);
  return again->method == request->method && again->params == request->params
             ? ""
             : fmt::format("{} is read as another one", said);
}

std::string words_rule(std::string_view line) {
  const std::vector<std::string_view> words = split(line, ' ');
  if (words.empty()) return "";
  const control::Method* const method = control::find_method(words.front());
  if (method == nullptr) return "";
  std::vector<control::Words> given(method->parameters.size());
  for (std::size_t i = 1; i < words.size() && !given.empty(); ++i)
    given[(i - 1) % given.size()].emplace_back(words[i]);
  const auto parameters = control::parse_words(*method, given);
  return parameters ? "" : message_rule(parameters.error());
}

std::string frame_rule(std::string_view line) {
  const auto read = record::read_candump_line(line);
  if (!read) return message_rule(read.error());
  const std::string said = record::candump_line(*read);
  const auto again = record::read_candump_line(std::string_view{said}.substr(0, said.size() - 1));
  if (!again) return fmt::format("{} is not read again: {}", said, again.error());
  // A line has microseconds; those of others may have more.
  const auto written = std::chrono::duration_cast<std::chrono::microseconds>(read->at);
  const bool is_same = again->at == written && again->interface == read->interface &&
                       std::memcmp(&again->frame, &read->frame, sizeof read->frame) == 0;
  return is_same ? "" : fmt::format("{} is read as another one", said);
}

}  // namespace

std::string read_request(Input input) {
  const std::string_view line = text_of(input);
  if (std::string broken = request_rule(line); !broken.empty()) return broken;
  if (const auto answer = control::parse_answer(line, 1); !answer && answer.error().message.empty())
    return "an answer that is none, without a word why";
  return words_rule(line);
}

std::string read_candump(Input input) {
  for (const std::string_view line : split(text_of(input), '\n')) {
    if (std::string broken = frame_rule(line); !broken.empty()) return broken;
    if (const auto printed = record::read_printed_line(line); !printed && printed.error().empty())
      return "a printed line that is none, without a word why";
  }
  return "";
}

std::string read_recording(Input input) {
  auto reader = record::Reader::open(input);
  if (!reader) return message_rule(reader.error());
  std::size_t before = reader->position();
  while (reader->next()) {
    if (reader->position() <= before || reader->position() > input.size()) return "a record that does not go on";
    before = reader->position();
  }
  if (reader->ending() == record::Reader::Ending::NotYet) return "no end at the end";
  const bool is_whole = reader->ending() == record::Reader::Ending::Whole;
  if (is_whole != reader->remark().empty()) return "a remark that does not fit to the end";
  return reader->position() + reader->left() == input.size() ? "" : "bytes that are nowhere";
}

std::vector<std::string> made_requests() {
  std::vector<std::string> lines;
  for (const control::Method& method : control::kMethods) {
    lines.push_back(control::request_line(1, method.name, nlohmann::json::object()));
    lines.push_back(std::string{method.name} + " 1 vcan0/5 p0304 true");
  }
  return lines;
}

std::vector<std::string> made_recordings() {
  const fakes::TemporaryDirectory folder;
  record::Plan plan{.files = record::plan_in(folder.path("recordings"))};
  {
    record::Recorder recorder{plan, {}};
    recorder.on_frame(record::kRequest, false, std::chrono::milliseconds{1});
    recorder.on_event({.kind = record::EventKind::Fault, .object = 2, .axis = 1, .number = 7900, .text = "fault"},
                      std::chrono::milliseconds{2});
    recorder.on_samples(std::array{1.0}, std::chrono::milliseconds{3});
    recorder.on_frame(record::kSync, true, std::chrono::milliseconds{4});
  }
  return {record::content_of_file(plan.files.folder / "run.axrec")};
}

}  // namespace fuzz
