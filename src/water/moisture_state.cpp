// What a sheet's water is from step to step.
#include "drench/moisture.h"

#include <algorithm>

#include "state/state_pass.h"

namespace drench {

namespace {

/// A node that is covered, or lies on something, until the next step.
struct Covered {
    std::size_t node = 0;
    float openArea = 0;  // m2
    bool lies = false;
};

}  // namespace

void Moisture::state(StatePass& pass) {
    constexpr double most = 1e15;  // kg, by which sums stay finite
    pass.numbers(poreMass_, 0, most);
    pass.numbers(filmMass_, 0, most);
    pass.number(dripped_, 0, most);
    pass.number(evaporated_, 0, most);
    accountsState(pass);
    coveredState(pass);
}

/// Sources hold the numbers of their accounts; so those that are open stay where they are, and go back to nothing where
/// the state knows none of that name. An account in which nothing is might as well not be there.
void Moisture::accountsState(StatePass& pass) {
    std::vector<Account> accounts;
    for (const Account& account : accounts_)
        if (pass.saves() && (account.supplied > 0 || account.returned > 0)) accounts.push_back(account);
    std::sort(accounts.begin(), accounts.end(),
              [](const Account& a, const Account& b) { return a.name < b.name; });
    const std::size_t size = pass.count(accounts.size());
    if (pass.restores())
        for (Account& account : accounts_) account.supplied = account.returned = 0;
    for (std::size_t i = 0; i < size; ++i) {
        Account read;
        Account& account = pass.saves() ? accounts[i] : read;
        pass.text(account.name);
        pass.number(account.supplied, 0);
        pass.number(account.returned, 0);
        if (pass.restores()) accounts_[openAccount(account.name)] = account;
    }
}

void Moisture::coveredState(StatePass& pass) {
    std::vector<Covered> all;
    if (pass.saves())
        for (const std::size_t node : covered_) all.push_back({node, openAreas_[node], lying_[node] != 0});
    pass.list(all, [&](Covered& covered) {
        pass.index(covered.node, size() - 1);
        pass.number(covered.openArea, 0);
        pass.flag(covered.lies);
    });
    if (!pass.restores()) return;
    uncover();
    for (const Covered& covered : all) {
        covered_.push_back(covered.node);
        openAreas_[covered.node] = covered.openArea;
        lying_[covered.node] = covered.lies;
    }
}

}  // namespace drench
