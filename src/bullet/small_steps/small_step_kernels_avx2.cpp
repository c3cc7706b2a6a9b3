// Compiled for AVX2 and FMA; called only where the processor has them.
#include "bullet/small_steps/small_step_kernels.h"

namespace drench {

namespace avx2 {
#include "bullet/small_steps/small_step_kernels_wide.inc"
}  // namespace avx2

const SmallStepKernels& avx2Kernels();
const SmallStepKernels& avx2Kernels() {
    static const SmallStepKernels kernels = {
        "AVX2",           avx2::advance,       avx2::pushByFluid, avx2::prepareLinks,
        avx2::solveLinks, avx2::preparePlates, avx2::solvePlates};
    return kernels;
}

}  // namespace drench
