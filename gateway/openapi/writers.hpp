#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace gateway {

/// Keeps the order in which members were written.
using OrderedJson = nlohmann::ordered_json;

/// The OpenAPI file (3.1) of the routes; @p schema is that of the lines of the control socket, from which
/// parameters and results have theirs.
[[nodiscard]] std::string write_document(const nlohmann::json& schema, std::string_view version);
/// The answers to all kinds of errors, by their status: "409".
[[nodiscard]] OrderedJson write_error_responses();
/// What is answered where there is an error.
[[nodiscard]] OrderedJson write_error_schema();
/// A C++ source that has @p document in it, for openapi_document().
[[nodiscard]] std::string write_source(std::string_view document);
/// The tables of docs/reference/http.md: routes and errors.
[[nodiscard]] std::string write_page();
/// @p page with @p part in the place of what stands between its marks. Throws std::runtime_error without marks.
[[nodiscard]] std::string with_part(std::string_view page, std::string_view part);

}  // namespace gateway
