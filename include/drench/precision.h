// Keeps single- and double-precision Bullet apart: whatever of Drench touches Bullet's types lives in an
// inline namespace that names the precision, so an application compiled for one and a library for the other
// fail to link instead of corrupting each other's memory.
#pragma once

#if defined(BT_USE_DOUBLE_PRECISION)
#define DRENCH_BULLET_NAMESPACE bullet_double
#else
#define DRENCH_BULLET_NAMESPACE bullet_float
#endif
