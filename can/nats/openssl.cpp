#include "can/nats/openssl.hpp"

#include <openssl/crypto.h>

namespace nats {

void keep_openssl() noexcept {
  [[maybe_unused]] static const int done = OPENSSL_init_crypto(OPENSSL_INIT_NO_ATEXIT, nullptr);
}

}  // namespace nats
