#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "eds/catalogue/catalogue.hpp"

namespace eds {

/// The list that a row belongs to.
enum class RowKind : std::uint8_t { Object, Parameter };

/// One row of the catalogue, checked by itself.
struct CatalogueRow {
  std::string place;  ///< "row 3 (6040:00)" or "parameter row 3 (2025:00)", for messages
  std::uint16_t index = 0;
  ObjectCode code = ObjectCode::Variable;
  Scope scope = Scope::Unit;
  std::string name;
  std::optional<std::string> does;
  std::optional<Entry> entry;  ///< of a VAR row, with the first sub-index
  std::uint8_t last_sub = 0;   ///< last sub-index of a range "first-last"; else that of the entry
};

/// Reads row @p number (from 1) of the list @p kind; throws CatalogueError.
[[nodiscard]] CatalogueRow parse_row(const nlohmann::json& json, std::size_t number, RowKind kind);

}  // namespace eds
