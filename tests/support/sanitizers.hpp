// What a test must know of the build: a sanitizer takes terabytes of addresses, and ThreadSanitizer has an operator new
// of its own. GCC and clang say it in different ways.
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
