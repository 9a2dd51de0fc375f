#pragma once

#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "can/nats_options/nats_options.hpp"
#include "farm/naming/farm_url.hpp"

namespace farm {

/// The farm of @p url, whose server is spoken to as @p server says. @p name is that of the option that has the
/// URL, or of the variable; the error is one line that names it.
[[nodiscard]] tl::expected<FarmUrl, std::string> read_farm(std::string_view url, const nats::ServerOptions& server,
                                                           std::string_view name = "--farm");

}  // namespace farm
