// Where the water of a sheet came from and went to.
#pragma once

namespace drench {

/// Running totals of one sheet's water since it was made, kg. Always
/// supplied = held + dripped + evaporated + returned, to rounding (see `imbalance`).
struct Ledger {
    double supplied = 0;    ///< brought by sources
    double held = 0;        ///< in pores and film now
    double dripped = 0;     ///< fallen off in drops; this version lets none fall
    double evaporated = 0;  ///< gone into the air; this version does not dry
    double returned = 0;    ///< given back to a pool; this version has none

    /// supplied - held - dripped - evaporated - returned, kg; a few rounding errors of `supplied`.
    double imbalance() const { return supplied - held - dripped - evaporated - returned; }
};

}  // namespace drench
