#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "control/writer/parameter_reader.hpp"
#include "control/writer/protocol_text.hpp"

namespace control {
namespace {

constexpr std::array<std::string_view, 8> kFileKeys{"group",       "summary", "order",   "commands",
                                                    "definitions", "notices", "methods", "of_parameters"};
constexpr std::array<std::string_view, 10> kMethodKeys{"name",   "scope",       "command", "summary", "params",
                                                       "result", "result_text", "columns", "brief",   "acts"};
constexpr double kLast = 1000.0;

/// One file, with what its texts are kept in.
struct Reader {
  ProtocolText& text;
  std::string file;

  void read_file(const Json& document);
  MethodText read_method(const Json& object, const std::string& place);
  void read_parameters(const Fields& fields, MethodText& method);
  static void read_acts(const Fields& fields, Method& method);
  std::span<const std::string_view> read_texts(const Fields& fields, std::string_view key);
  void add_group(std::string_view name, std::string_view summary);
  void merge(Json& all, const Fields& fields, std::string_view key) const;
};

void Reader::read_parameters(const Fields& fields, MethodText& method) {
  std::vector<Parameter>& own = text.parameters.emplace_back();
  std::size_t number = 0;
  for (const Json& object : fields.list("params")) {
    ParameterText parameter =
        read_parameter(text, object, fields.place("params") + "/" + std::to_string(number++));
    own.push_back(parameter.row);
    method.meanings.push_back(parameter.meaning);
  }
  method.row.parameters = own;
  bool optional = false;
  for (const Parameter& parameter : own) {
    if (!parameter.option.empty()) continue;
    if (optional && parameter.absent.empty())
      fields.refuse("params", fmt::format("{} before the words that may be left out", parameter.key));
    optional = !parameter.absent.empty();
  }
}

std::span<const std::string_view> Reader::read_texts(const Fields& fields, std::string_view key) {
  std::vector<std::string_view>& own = text.choices.emplace_back();
  for (const Json& element : fields.list(key)) {
    if (!element.is_string()) fields.refuse(key, "texts");
    own.emplace_back(element.get_ref<const std::string&>());
  }
  return own;
}

/// true, or "change".
void Reader::read_acts(const Fields& fields, Method& method) {
  if (!fields.is_text("acts")) {
    method.acts = fields.flag("acts", false) ? Acts::Always : Acts::No;
    return;
  }
  method.acts = Acts::Change;
  if (fields.text("acts") != "change") fields.refuse("acts", "true, or \"change\"");
}

MethodText Reader::read_method(const Json& object, const std::string& place) {
  const Fields fields{object, place, kMethodKeys};
  MethodText method{};
  method.row.name = fields.text("name");
  method.row.summary = fields.text("summary");
  const std::string_view scope = fields.text("scope", "unit");
  if (scope != "unit" && scope != "program") fields.refuse("scope", "unit or program");
  method.row.scope = scope == "unit" ? Scope::Unit : Scope::Program;
  const std::string_view command = fields.text("command", "");
  const std::size_t blank = command.find(' ');
  if (blank != std::string_view::npos) method.row.group = command.substr(0, blank);
  method.row.command = command.substr(blank == std::string_view::npos ? 0 : blank + 1);
  if (method.row.command.find(' ') != std::string_view::npos) fields.refuse("command", "one word or two");
  method.result = fields.has("result") ? &fields.object("result") : nullptr;
  method.result_text = fields.text("result_text", method.result == nullptr ? "`{}`" : "the object below");
  method.row.columns = read_texts(fields, "columns");
  method.row.brief = read_texts(fields, "brief");
  read_parameters(fields, method);
  read_acts(fields, method.row);
  return method;
}

void Reader::add_group(std::string_view name, std::string_view summary) {
  if (std::ranges::count(text.groups, name, &Group::name) == 0) text.groups.push_back({name, summary});
}

void Reader::merge(Json& all, const Fields& fields, std::string_view key) const {
  for (const auto& item : fields.object(key).items()) {
    if (all.contains(item.key())) fields.refuse(key, fmt::format("{} in one file only", item.key()));
    all[item.key()] = item.value();
  }
}

void Reader::read_file(const Json& document) {
  const Fields fields{document, file + ":", kFileKeys};
  Chapter chapter{fields.text("group"), fields.text("summary"), fields.number("order", kLast), {}};
  merge(text.definitions, fields, "definitions");
  merge(text.notices, fields, "notices");
  for (const auto& item : fields.object("commands").items()) {
    if (!item.value().is_string()) fields.refuse("commands", "a text a command");
    add_group(text.names.emplace_back(item.key()), item.value().get_ref<const std::string&>());
  }
  std::size_t number = 0;
  for (const Json& object : fields.list("methods"))
    chapter.methods.push_back(read_method(object, fields.place("methods") + "/" + std::to_string(number++)));
  for (MethodText& method : chapter.methods) method.row.of_parameters = fields.flag("of_parameters", false);
  for (const MethodText& method : chapter.methods)
    if (!method.row.group.empty()) add_group(method.row.group, chapter.summary);
  text.chapters.push_back(std::move(chapter));
}

std::unique_ptr<const Json> parse_file(const std::string& path) {
  std::ifstream file{path};
  if (!file) throw std::runtime_error{path + ": cannot be read"};
  try {
    return std::make_unique<const Json>(Json::parse(file));
  } catch (const Json::exception& error) {
    throw std::runtime_error{fmt::format("{}: {}", path, error.what())};
  }
}

/// The names of the members that @p schema describes, in its order, each once.
void collect_keys(const ProtocolText& text, const Json& schema, std::vector<std::string_view>& keys) {
  if (schema.is_array())
    for (const Json& element : schema) collect_keys(text, element, keys);
  if (!schema.is_object()) return;
  if (const auto reference = schema.find("$ref"); reference != schema.end() && reference->is_string()) {
    const auto& target = reference->get_ref<const std::string&>();
    const auto found = text.definitions.find(target.substr(target.rfind('/') + 1));
    if (found != text.definitions.end()) collect_keys(text, *found, keys);
  }
  if (const auto members = schema.find("properties"); members != schema.end())
    for (const auto& item : members->items()) {
      if (std::ranges::count(keys, item.key()) == 0) keys.emplace_back(item.key());
      collect_keys(text, item.value(), keys);
    }
  for (const char* const below : {"items", "anyOf", "oneOf", "allOf"})
    if (schema.contains(below)) collect_keys(text, schema[below], keys);
}

void add_keys(ProtocolText& text) {
  for (Chapter& chapter : text.chapters)
    for (MethodText& method : chapter.methods) {
      std::vector<std::string_view>& keys = text.choices.emplace_back();
      if (method.result != nullptr) collect_keys(text, *method.result, keys);
      method.row.keys = keys;
    }
}

/// Names and subcommands of methods are theirs alone.
void check_names(const ProtocolText& text) {
  std::vector<std::string> seen;
  const auto once = [&seen](std::string name) {
    if (std::ranges::count(seen, name) != 0) throw std::runtime_error{name + ": stands twice"};
    seen.push_back(std::move(name));
  };
  for (const Chapter& chapter : text.chapters)
    for (const MethodText& method : chapter.methods) {
      once(fmt::format("method {}", method.row.name));
      if (!method.row.command.empty()) once(fmt::format("command {} {}", method.row.group, method.row.command));
    }
  for (const Chapter& chapter : text.chapters)
    for (const auto& [row, meanings, result_text, result] : chapter.methods)
      if (row.group.empty() && std::ranges::count(text.groups, row.command, &Group::name) != 0)
        throw std::runtime_error{fmt::format("{}: {} is the first word of other commands", row.name, row.command)};
}

}  // namespace

ProtocolText read_protocol(const std::vector<std::string>& paths) {
  ProtocolText text;
  for (const std::string& path : paths) {
    text.documents.push_back(parse_file(path));
    Reader{text, std::filesystem::path{path}.filename().string()}.read_file(*text.documents.back());
  }
  std::ranges::stable_sort(text.chapters, [](const Chapter& a, const Chapter& b) {
    return a.order != b.order ? a.order < b.order : a.group < b.group;
  });
  check_names(text);
  add_keys(text);
  return text;
}

}  // namespace control
