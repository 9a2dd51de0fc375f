#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fuzz {

/// The bytes of somebody.
using Input = std::span<const std::byte>;

/// A reader of files, lines or images that others have written, with the rules that it keeps whatever they hold.
struct ReaderRow {
  std::string_view name;
  std::string_view summary;
  /// The folder below the source tree whose files are inputs to begin with; empty: none is.
  std::string_view folder;
  /// Inputs to begin with that are made when they are needed; nullptr: none is.
  std::vector<std::string> (*made)();
  /// Reads @p input; what is against the rules, empty if nothing is.
  std::string (*broken_rule)(Input input);
};

/// All of them.
std::span<const ReaderRow> readers() noexcept;
/// The one called @p name; nullptr if there is none.
const ReaderRow* find_reader(std::string_view name) noexcept;

// What they do with an input.
std::string read_configuration(Input input);
std::string read_motor(Input input);
std::string read_scenario(Input input);
std::string read_fault(Input input);
std::string read_plan(Input input);
std::string read_request(Input input);
std::string read_candump(Input input);
std::string read_recording(Input input);
std::string read_parameters(Input input);
std::string read_retained(Input input);
std::string read_objects(Input input);
std::string read_control(Input input);
std::string read_http(Input input);
std::string read_hub(Input input);
std::string read_frames(Input input);
std::string read_frames_402(Input input);

// Inputs to begin with.
std::vector<std::string> made_configurations();
std::vector<std::string> made_faults();
std::vector<std::string> made_plans();
std::vector<std::string> made_requests();
std::vector<std::string> made_recordings();
std::vector<std::string> made_parameters();
std::vector<std::string> made_retained();
std::vector<std::string> made_objects();
std::vector<std::string> made_control();
std::vector<std::string> made_http();
std::vector<std::string> made_hub();
std::vector<std::string> made_frames();
/// Whether @p text is a configuration.
bool takes_configuration(std::string_view text);
/// All inputs that @p reader begins with.
std::vector<std::string> inputs_of(const ReaderRow& reader);

/// @p input as text.
inline std::string_view text_of(Input input) noexcept {
  return {reinterpret_cast<const char*>(input.data()), input.size()};
}
/// Whether @p message can stand in a log: one line, printable, and not empty. What is against that, or nothing.
std::string message_rule(std::string_view message);

}  // namespace fuzz
