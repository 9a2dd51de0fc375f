#pragma once

#include "gateway/page/page_files.hpp"
#include "gateway/server/exchange.hpp"

namespace gateway {

/// How long a browser may keep a file without asking.
enum class Keep : bool {
  Asks,    ///< it asks each time whether its copy is still the one
  ForEver  ///< the name is another one when the content is
};

/// The answer to @p request with @p file: compressed if the client takes that, or that its copy is still the one.
[[nodiscard]] Response page_answer(const Request& request, const PageFile& file, Keep keep);

/// Whether a client that sends @p accept_encoding (RFC 9110, 12.5.3) takes gzip.
[[nodiscard]] bool takes_gzip(std::string_view accept_encoding) noexcept;

}  // namespace gateway
