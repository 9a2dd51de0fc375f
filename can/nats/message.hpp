#pragma once

#include <string_view>

#include <nats/nats.h>
#include <tl/expected.hpp>

namespace nats {

/// What @p message carries, which lives as long as it does.
[[nodiscard]] std::string_view data_of(natsMsg* message) noexcept;

/// The value of the header @p name, which lives as long as @p message; nullptr: it has none of that name. The
/// library takes headers apart when it is first asked for one: the error is that it could not, as without memory.
[[nodiscard]] tl::expected<const char*, natsStatus> header_of(natsMsg* message, const char* name) noexcept;

}  // namespace nats
