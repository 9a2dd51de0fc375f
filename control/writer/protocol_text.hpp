#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "control/method.hpp"
#include "control/writer/fields.hpp"

namespace control {

/// A method as its file tells it.
struct MethodText {
  Method row;
  std::vector<std::string_view> meanings;  ///< of its parameters, for the page, beyond key and range
  std::string_view result_text;            ///< for the page
  const Json* result;                      ///< JSON Schema of the result; nullptr: an empty object
};

/// One file: the methods of a group.
struct Chapter {
  std::string_view group;
  std::string_view summary;
  double order;
  std::vector<MethodText> methods;
};

/// All files. Texts and lists of the rows lie in `documents` and the deques below it.
struct ProtocolText {
  std::vector<std::unique_ptr<const Json>> documents;
  std::deque<std::vector<std::string_view>> choices;
  std::deque<std::vector<Range>> terminals;
  std::deque<std::vector<Parameter>> parameters;
  std::deque<std::string> names;

  std::vector<Chapter> chapters;      ///< in the order of the page
  std::vector<Group> groups;          ///< first words of subcommands
  Json definitions = Json::object();  ///< schemas that results refer to
  Json notices = Json::object();      ///< schemas of the lines that a subscription brings, by their one key
};

/// Reads the files @p paths of the protocol. Throws std::runtime_error with one line that names file and key.
ProtocolText read_protocol(const std::vector<std::string>& paths);

}  // namespace control
