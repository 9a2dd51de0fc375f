#pragma once

namespace nats {

/// Has OpenSSL stay until the process is gone; to be called before anything that the library of NATS does, for
/// that uses it. A thread of the library destroys a connection when its last subscription is gone, which may be
/// while the process ends: OpenSSL must not be taken down under it.
void keep_openssl() noexcept;

}  // namespace nats
