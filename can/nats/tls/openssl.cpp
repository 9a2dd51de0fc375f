#include "can/nats/tls/openssl.hpp"

#include <openssl/crypto.h>

namespace nats {

// OpenSSL makes its context once. If that has failed, RAND_bytes() goes on with what is not there (3.0).
bool open_openssl() noexcept {
  static const int kKept = OPENSSL_init_crypto(OPENSSL_INIT_NO_ATEXIT, nullptr);
  return kKept == 1 && OSSL_LIB_CTX_get0_global_default() != nullptr;
}

}  // namespace nats
