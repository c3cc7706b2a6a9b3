// Compiled for AVX2 and FMA; called only if the processor supports them.
#include "bullet/simd/contact_lanes.h"
#include "bullet/simd/fluid_kernels_wide.h"
#include "bullet/simd/small_step_kernels_wide.h"
#include "bullet/simd/strip_loops.h"

namespace drench {

const SmallStepKernels& avx2Kernels();
const SmallStepKernels& avx2Kernels() {
    static const SmallStepKernels kernels = {"AVX2",
                                             wide::advance,
                                             wide::advanceByFraction,
                                             wide::correctByFraction,
                                             wide::prepareLinks,
                                             wide::solveLinks,
                                             wide::preparePlates,
                                             wide::solvePlates,
                                             strip_loops::kernels<wide::Eight, wide::Vector>()};
    return kernels;
}

const ContactKernels& avx2ContactKernels();
const ContactKernels& avx2ContactKernels() {
    static const ContactKernels kernels = lanes::kernelsFor<wide::Eight>();
    return kernels;
}

PushByFluid avx2PushByFluid();
PushByFluid avx2PushByFluid() {
    return wide::pushByFluid;
}

}  // namespace drench
