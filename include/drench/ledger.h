// Where the water of a sheet came from and went to.
#pragma once

#include <string>
#include <vector>

namespace drench {

/// What one source has brought and taken back, kg.
struct Account {
    std::string name;     ///< of the source; "application" for water that the application added itself
    double supplied = 0;  ///< brought
    double returned = 0;  ///< taken back: by a pool, a wet body, another sheet
};

/// Running totals of one sheet's water since it was made, kg. Always
/// supplied = held + dripped + evaporated + returned, to rounding (see `imbalance`).
struct Ledger {
    double supplied = 0;            ///< brought by all sources; air that is damper than the cloth is one
    double held = 0;                ///< in pores and film now
    double dripped = 0;             ///< fallen off in drops
    double evaporated = 0;          ///< gone into the air
    double returned = 0;            ///< given back to sources
    std::vector<Account> accounts;  ///< of each source, also of those that were removed since; one a name

    /// supplied - held - dripped - evaporated - returned, kg; a few rounding errors of `supplied`.
    double imbalance() const { return supplied - held - dripped - evaporated - returned; }
};

}  // namespace drench
