#include "control/methods.hpp"

#include <string>

#include <gtest/gtest.h>

namespace control {
namespace {

TEST(Methods, HaveNamesAndSubcommandsOfTheirOwn) {
  for (const Method& method : kMethods) {
    EXPECT_EQ(std::ranges::count(kMethods, method.name, &Method::name), 1) << method.name;
    if (method.command.empty()) continue;
    EXPECT_EQ(std::ranges::count_if(kMethods,
                                    [&](const Method& other) {
                                      return other.group == method.group && other.command == method.command;
                                    }),
              1)
        << method.name;
  }
}

TEST(Methods, AreInGroupsThatExist) {
  for (const Method& method : kMethods)
    EXPECT_TRUE(method.group.empty() || std::ranges::count(kGroups, method.group, &Group::name) == 1)
        << method.name;
  for (const Group& group : kGroups) EXPECT_NE(std::ranges::count(kMethods, group.name, &Method::group), 0);
}

TEST(Methods, HaveParametersWithEverythingThatTheirFormAsksFor) {
  for (const Method& method : kMethods)
    for (const Parameter& parameter : method.parameters) {
      SCOPED_TRACE(std::string{method.name}.append(" ").append(parameter.key));
      EXPECT_EQ(std::ranges::count(method.parameters, parameter.key, &Parameter::key), 1);
      EXPECT_FALSE(parameter.argument.empty());
      EXPECT_FALSE(parameter.help.empty());
      EXPECT_EQ(parameter.form == Form::Choice, !parameter.choices.empty());
      EXPECT_EQ(parameter.form == Form::Terminal, !parameter.terminals.empty());
      EXPECT_TRUE(parameter.form == Form::Number || parameter.unit.empty());
      const bool has_range = parameter.form == Form::Integer || parameter.form == Form::Terminal ||
                             parameter.form == Form::Fault || parameter.form == Form::Number ||
                             (parameter.form == Form::List || parameter.form == Form::Words);
      EXPECT_EQ(has_range, parameter.range.low < parameter.range.high);
    }
}

TEST(Methods, HaveOptionalParametersBehindTheOthers) {
  for (const Method& method : kMethods)
    EXPECT_TRUE(std::ranges::is_partitioned(method.parameters,
                                            [](const Parameter& parameter) {
                                              return parameter.absent.empty() && parameter.option.empty();
                                            }) ||
                std::ranges::none_of(method.parameters,
                                     [](const Parameter& parameter) {
                                       return parameter.option.empty() && !parameter.absent.empty();
                                     }))
        << method.name;
}

TEST(Methods, HaveExceptionsThatAChoiceOfTheirsDecides) {
  for (const Method& method : kMethods)
    for (const Parameter& parameter : method.parameters) {
      if (parameter.exception.key.empty()) continue;
      const auto decides = std::ranges::find(method.parameters, parameter.exception.key, &Parameter::key);
      ASSERT_NE(decides, method.parameters.end()) << method.name;
      EXPECT_EQ(std::ranges::count(decides->choices, parameter.exception.choice), 1) << method.name;
    }
}

}  // namespace
}  // namespace control
