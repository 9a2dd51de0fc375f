#pragma once

#include <set>
#include <string>

#include "gateway/openapi/writers.hpp"
#include "gateway/routes/route.hpp"

namespace gateway {

/// Writes operations from rows, and keeps in mind what they refer to.
class OperationWriter {
 public:
  /// @p schema is that of the lines of the control socket.
  explicit OperationWriter(const nlohmann::json& schema) : definitions_{schema.at("$defs")} {}

  /// The operation of @p route.
  [[nodiscard]] OrderedJson write(const Route& route);
  /// The schemas that the operations so far refer to, under their names.
  [[nodiscard]] OrderedJson schemas() const;

 private:
  OrderedJson parameter(const Route& route, const control::Parameter& row) const;
  OrderedJson parameters(const Route& route) const;
  OrderedJson body(const Route& route) const;
  OrderedJson content(const Route& route);
  OrderedJson reference(const std::string& definition);
  OrderedJson definition(const std::string& name);
  nlohmann::json schema_of(const Route& route, std::string_view key) const;
  std::string identifier(const Route& route);

  const nlohmann::json& definitions_;
  std::set<std::string> referred_;
  std::set<std::string> identifiers_;
};

}  // namespace gateway
