#include "bullet/simd/contact_kernels.h"

#include "bullet/simd/contact_lanes.h"

namespace drench {

#if defined(DRENCH_HAS_AVX2_KERNELS)
const ContactKernels& avx2ContactKernels();  // see kernels_avx2.cpp
#endif

const ContactKernels& scalarContactKernels() {
    static const ContactKernels kernels = lanes::kernelsFor<float>();
    return kernels;
}

const ContactKernels& bestContactKernels() {
#if defined(DRENCH_HAS_AVX2_KERNELS)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2ContactKernels();
#endif
#if defined(__GNUC__)
    static const ContactKernels kernels = lanes::kernelsFor<wide::Eight>();
    return kernels;
#else
    return scalarContactKernels();
#endif
}

}  // namespace drench
