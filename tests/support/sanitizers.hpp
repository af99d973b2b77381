// Whether a sanitizer is on. Some tests must know: a sanitizer takes terabytes of addresses, and ThreadSanitizer has
// its own operator new. GCC and clang define different macros.
#pragma once

#if defined(__has_feature)
#define REQUAD_ADDRESS_SANITIZER __has_feature(address_sanitizer)
#define REQUAD_THREAD_SANITIZER __has_feature(thread_sanitizer)
#else
#ifdef __SANITIZE_ADDRESS__
#define REQUAD_ADDRESS_SANITIZER 1
#else
#define REQUAD_ADDRESS_SANITIZER 0
#endif
#ifdef __SANITIZE_THREAD__
#define REQUAD_THREAD_SANITIZER 1
#else
#define REQUAD_THREAD_SANITIZER 0
#endif
#endif

namespace requad::tests {

constexpr bool kSanitized = REQUAD_ADDRESS_SANITIZER != 0 || REQUAD_THREAD_SANITIZER != 0;

}  // namespace requad::tests
