#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "control/writer/writers.hpp"

namespace control {
namespace {

constexpr std::string_view kHead =
    "// Made from control/protocol/ by compile_protocol.\n"
    "#pragma once\n\n"
    "#include <array>\n\n"
    "#include \"control/method.hpp\"\n\n"
    "namespace control {\n\n";

std::string quoted(std::string_view text) {
  return Json(std::string{text}).dump();
}

std::string text_of(const Range& range) {
  return fmt::format("{{{}, {}}}", range.low, range.high);
}

/// Name of a Form, as C++ has it.
std::string_view name_of(Form form) {
  switch (form) {
    case Form::Axis:
      return "Axis";
    case Form::Place:
      return "Place";
    case Form::Integer:
      return "Integer";
    case Form::Terminal:
      return "Terminal";
    case Form::Fault:
      return "Fault";
    case Form::Number:
      return "Number";
    case Form::Choice:
      return "Choice";
    case Form::Switch:
      return "Switch";
    case Form::Text:
      return "Text";
    case Form::List:
      return "List";
    case Form::Words:
      return "Words";
    case Form::Value:
      return "Value";
    case Form::Hexadecimal:
      return "Hexadecimal";
    case Form::Any:
      break;
  }
  return "Any";
}

/// Arrays that rows refer to, each under a number of its own.
class TableWriter {
 public:
  std::string parameters(const Method& method);
  std::string texts(std::span<const std::string_view> texts);
  std::string take() { return std::move(arrays_); }

 private:
  std::string name(std::string_view what) { return fmt::format("k{}{}", what, ++number_); }
  std::string terminals(const Parameter& parameter);
  std::string row(const Parameter& parameter);

  std::string arrays_;
  int number_ = 0;
};

std::string TableWriter::texts(std::span<const std::string_view> texts) {
  if (texts.empty()) return "{}";
  std::string array = name("Texts");
  arrays_ += fmt::format("inline constexpr std::array<std::string_view, {}> {}{{", texts.size(), array);
  for (const std::string_view text : texts) arrays_ += quoted(text) + ", ";
  arrays_ += "};\n";
  return array;
}

std::string TableWriter::terminals(const Parameter& parameter) {
  if (parameter.terminals.empty()) return "{}";
  std::string array = name("Terminals");
  arrays_ += fmt::format("inline constexpr std::array {}{{", array);
  for (const Range& range : parameter.terminals) arrays_ += "Range" + text_of(range) + ", ";
  arrays_ += "};\n";
  return array;
}

std::string TableWriter::row(const Parameter& parameter) {
  const Exception& exception = parameter.exception;
  return fmt::format(
      "    Parameter{{.key = {}, .form = Form::{}, .range = {}, .unit = {}, .choices = {}, .terminals = {},\n"
      "              .exception = {{{}, {}, {}}}, .absent = {}, .argument = {}, .option = {},\n"
      "              .help = {}}},\n",
      quoted(parameter.key), name_of(parameter.form), text_of(parameter.range), quoted(parameter.unit),
      texts(parameter.choices), terminals(parameter), quoted(exception.key), quoted(exception.choice),
      text_of(exception.range), quoted(parameter.absent), quoted(parameter.argument), quoted(parameter.option),
      quoted(parameter.help));
}

std::string TableWriter::parameters(const Method& method) {
  if (method.parameters.empty()) return "{}";
  std::string rows;
  for (const Parameter& parameter : method.parameters) rows += row(parameter);
  std::string array = name("Parameters");
  arrays_ += fmt::format("inline constexpr std::array {}{{\n{}}};\n", array, rows);
  return array;
}

std::string_view name_of(Acts acts) {
  constexpr std::array<std::string_view, 3> kNames{"No", "Always", "Change"};
  return kNames[static_cast<std::size_t>(acts)];
}

/// "drive-state" as the name of a constant: kDriveState.
std::string constant_of(std::string_view definition) {
  std::string name{"k"};
  bool is_first = true;
  for (const char c : definition) {
    if (c != '-') name += static_cast<char>(is_first ? std::toupper(static_cast<unsigned char>(c)) : c);
    is_first = c == '-';
  }
  return name;
}

/// The choices of the definitions that are nothing else, for who takes them as words.
std::string choices_of(const ProtocolText& text) {
  std::string arrays;
  for (const auto& item : text.definitions.items()) {
    if (!item.value().is_object() || !item.value().contains("enum")) continue;
    const Json& choices = item.value()["enum"];
    if (!std::ranges::all_of(choices, [](const Json& choice) { return choice.is_string(); })) continue;
    arrays += fmt::format("inline constexpr std::array<std::string_view, {}> {}{{", choices.size(),
                          constant_of(item.key()));
    for (const Json& choice : choices) arrays += choice.dump() + ", ";
    arrays += "};\n";
  }
  return arrays;
}

}  // namespace

std::string write_table(const ProtocolText& text) {
  TableWriter writer;
  std::string methods;
  for (const Chapter& chapter : text.chapters)
    for (const auto& [row, meanings, result_text, result] : chapter.methods)
      methods += fmt::format(
          "    Method{{.name = {}, .scope = Scope::{}, .group = {}, .command = {}, .summary = {},\n"
          "           .parameters = {}, .keys = {}, .columns = {}, .brief = {},\n"
          "           .acts = Acts::{}, .of_parameters = {}}},\n",
          quoted(row.name), row.scope == Scope::Unit ? "Unit" : "Program", quoted(row.group), quoted(row.command),
          quoted(row.summary), writer.parameters(row), writer.texts(row.keys), writer.texts(row.columns),
          writer.texts(row.brief), name_of(row.acts), row.of_parameters);
  std::string groups;
  for (const Group& group : text.groups)
    groups += fmt::format("    Group{{{}, {}}},\n", quoted(group.name), quoted(group.summary));
  return fmt::format(
      "{}{}inline constexpr std::array kMethods{{\n{}}};\ninline constexpr std::array kGroups{{\n{}}};"
      "\n\n}}  // namespace control\n",
      kHead, choices_of(text) + writer.take(), methods, groups);
}

}  // namespace control
