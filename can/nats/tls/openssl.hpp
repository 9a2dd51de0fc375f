#pragma once

namespace nats {

/// Has OpenSSL ready, and stay until the process is gone; to be called before anything that libnats does, which
/// uses it. False: there is no memory for it, and libnats would crash when it asks for random numbers. A thread of
/// libnats destroys a connection when its last subscription is gone, which may be while the process ends: OpenSSL
/// must not be taken down under it.
[[nodiscard]] bool open_openssl() noexcept;

}  // namespace nats
