#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>

#include "eds/transform/configuration.hpp"
#include "eds/transform/dictionary_source.hpp"
#include "eds/transform/flatten.hpp"
#include "text/number.hpp"
#include "tools/edstool/command.hpp"

namespace edstool {
namespace {

/// Where from and where to.
struct Paths {
  std::string input;
  std::string output;
};

void add_paths(CLI::App& command, Paths& paths) {
  command.add_option("file", paths.input, "EDS or DCF file")->required()->type_name("FILE");
  command.add_option("--output", paths.output, "File to write (default: standard output)")->type_name("FILE");
}

/// A file bears its own name (CiA 306, FileName).
std::string named(eds::Document document, const std::string& output) {
  const std::string name = std::filesystem::path{output}.filename().string();
  if (!name.empty()) document.section("FileInfo").set("FileName", name);
  return document.write();
}

struct FlattenOptions {
  Paths paths;
  std::string modules;
};

/// "1,1,2" as numbers; UsageError.
std::vector<unsigned> parse_modules(std::string_view text) {
  std::vector<unsigned> numbers;
  std::string_view rest = text;
  while (true) {
    const auto number = text::take_integer<unsigned>(rest);
    if (number) numbers.push_back(*number);
    if (number && rest.empty()) return numbers;
    if (!number || rest.front() != ',')
      throw UsageError{"--modules: expected numbers separated by commas, as 1,1,2, got \"" + std::string{text} +
                       '"'};
    rest.remove_prefix(1);
  }
}

int flatten(const FlattenOptions& options, bool json) {
  const std::vector<unsigned> modules = parse_modules(options.modules);
  const InputFile file{options.paths.input};
  Made made{.text = {}, .findings = eds::Findings{file.path}, .output = options.paths.output};
  made.text = named(eds::flatten(file.document, modules, made.findings), made.output);
  return deliver(made, json);
}

struct DcfOptions {
  Paths paths;
  eds::NodeSettings node;
  std::vector<std::string> settings;
};

int configure(const DcfOptions& options, bool json) {
  std::vector<eds::Setting> settings;
  for (const std::string& text : options.settings) {
    auto setting = eds::parse_setting(text);
    if (!setting)
      throw UsageError{"--set: expected INDEX=VALUE or INDEX:SUB=VALUE, as 6083=1000, got \"" + text + '"'};
    settings.push_back(*std::move(setting));
  }
  const InputFile file{options.paths.input};
  Made made{.text = {}, .findings = eds::Findings{file.path}, .output = options.paths.output};
  made.text = named(eds::configure(file.document, options.node, settings, made.findings), made.output);
  return deliver(made, json);
}

struct SourceCommand {
  Paths paths;
  std::string table = "kObjects";
  unsigned text_capacity = 64;
};

int write_source(const SourceCommand& options, bool json) {
  const InputFile file{options.paths.input};
  Made made{.text = {}, .findings = eds::Findings{file.path}, .output = options.paths.output};
  const std::string origin = std::filesystem::path{file.path}.filename().string();
  made.text = eds::write_dictionary(
      file.sheet, {.table = options.table, .origin = origin, .text_capacity = options.text_capacity},
      made.findings);
  return deliver(made, json);
}

/// An identifier of C++.
std::string not_an_identifier(const std::string& text) {
  const bool fits = !text.empty() &&
                    text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_0123456789") ==
                        std::string::npos &&
                    (text[0] < '0' || text[0] > '9');
  return fits ? "" : "expected a name of C++, got \"" + text + '"';
}

}  // namespace

void add_flatten(CLI::App& app, Invocation& invocation) {
  CLI::App* const command = app.add_subcommand("flatten", "Make a plain file of a modular one");
  const auto options = std::make_shared<FlattenOptions>();
  add_paths(*command, options->paths);
  command
      ->add_option("--modules", options->modules, "Numbers of the modules in the order of their places, as 1,1,2")
      ->required()
      ->type_name("N,...");
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return flatten(*options, invocation.json); };
  });
}

void add_dcf(CLI::App& app, Invocation& invocation) {
  CLI::App* const command = app.add_subcommand("dcf", "Make the configuration (DCF) of one node");
  const auto options = std::make_shared<DcfOptions>();
  add_paths(*command, options->paths);
  eds::NodeSettings& node = options->node;
  command->add_option("--node-id", node.node_id, "Node-ID, 1 to 127")->required()->type_name("N");
  command->add_option("--bit-rate", node.bit_rate, "kbit/s (default: the highest one of the device)")
      ->type_name("N");
  command->add_option("--name", node.node_name, "Name of the node (default: that of the product)")
      ->type_name("TEXT");
  command->add_option("--network", node.network_name, "Name of the network")->type_name("TEXT");
  command->add_option("--net-number", node.net_number, "Number of the network (default: 1)")->type_name("N");
  command->add_flag("--manager", node.manager, "The node is the CANopen manager");
  command
      ->add_option("--set", options->settings,
                   "Value of an entry: 6083=1000, 1018:1=5; may be given several times")
      ->type_name("INDEX[:SUB]=VALUE")
      ->allow_extra_args(false);
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return configure(*options, invocation.json); };
  });
}

void add_source(CLI::App& app, Invocation& invocation) {
  CLI::App* const command = app.add_subcommand("c++", "Write a dictionary for libcanopen, a C++ header");
  const auto options = std::make_shared<SourceCommand>();
  add_paths(*command, options->paths);
  command->add_option("--table", options->table, "Name of the table (default: kObjects)")
      ->type_name("NAME")
      ->check(CLI::Validator{not_an_identifier, "", ""});
  command->add_option("--text-capacity", options->text_capacity, "Bytes of a writable string (default: 64)")
      ->type_name("N");
  command->callback([&invocation, options] {
    invocation.run = [&invocation, options] { return write_source(*options, invocation.json); };
  });
}

}  // namespace edstool
