#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "tools/axisctl/scenario/language/keys.hpp"

namespace scenario {

/// How a value that stands alone is written: checked, explained, and said in a schema.
struct FormRow {
  Form form;
  bool (*fits)(const nlohmann::json& value, const Key& key);
  std::string (*expected)(const Key& key);
  nlohmann::json (*schema)(const Key& key);
};

/// The row of @p form; null for those that are objects or lists with keys of their own.
[[nodiscard]] const FormRow* row_of(Form form) noexcept;

}  // namespace scenario
