// Denormal numbers, which some processors compute a hundred times slower than others.
#pragma once

#if defined(__SSE2__) || defined(_M_X64)
#include <xmmintrin.h>
#endif

#include <cstdint>

namespace drench {

// Treats denormal numbers as 0 while it lives, in this thread; afterwards they are as before. Speeds and
// displacements of cloth at rest decay through them. On processors where this is unknown it does nothing.
class DenormalsAsZero {
  public:
    DenormalsAsZero() : before_(read()) { write(before_ | flags); }
    ~DenormalsAsZero() { write(before_); }
    DenormalsAsZero(const DenormalsAsZero&) = delete;
    DenormalsAsZero& operator=(const DenormalsAsZero&) = delete;

  private:
#if defined(__SSE2__) || defined(_M_X64)
    // Bits of MXCSR: flush to zero, and denormals are zero.
    static constexpr std::uint64_t flags = 0x8040;
    static std::uint64_t read() {
        return _mm_getcsr();
    }
    static void write(std::uint64_t state) {
        _mm_setcsr(static_cast<unsigned>(state));
    }
#elif defined(__aarch64__)
    // Bit of FPCR: flush to zero.
    static constexpr std::uint64_t flags = 1u << 24;
    static std::uint64_t read() {
        std::uint64_t state;
        asm volatile("mrs %0, fpcr" : "=r"(state));
        return state;
    }
    static void write(std::uint64_t state) {
        asm volatile("msr fpcr, %0" : : "r"(state));
    }
#else
    static constexpr std::uint64_t flags = 0;
    static std::uint64_t read() {
        return 0;
    }
    static void write(std::uint64_t) {}
#endif

    std::uint64_t before_;
};

}  // namespace drench
