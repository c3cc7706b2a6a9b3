// Compiled for double-precision Bullet; must not link with a library for single precision.
#include <drench/wet_cloth.h>

drench::Ledger read(const drench::WetCloth& cloth);
drench::Ledger read(const drench::WetCloth& cloth) {
    return cloth.ledger();
}

int main() {
    return 0;
}
