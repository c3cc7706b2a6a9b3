#include "bullet/repair/diagnostics.h"

#include <algorithm>
#include <stdexcept>

#include "checks/checks.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

void Diagnostics::note(Trouble what, const std::string& message, int node, double value) {
    if (throws()) refuse<std::runtime_error>(message);
    write(what, message, node, value);
}

void Diagnostics::noteThrown(Trouble what, const std::string& message) {
    if (throws()) throw;
    write(what, message, -1, 0);
}

bool Diagnostics::goesOn(Trouble what) {
    const auto report = find(what);
    if (throws() || report == reports_.end()) return false;
    report->last = time_;
    report->lastSubstep = substep_;
    ++report->substeps;
    return true;
}

std::vector<TroubleReport>::iterator Diagnostics::find(Trouble what) {
    return std::find_if(reports_.begin(), reports_.end(),
                        [what](const TroubleReport& known) { return known.what == what; });
}

void Diagnostics::write(Trouble what, const std::string& message, int node, double value) {
    auto report = find(what);
    if (report == reports_.end()) {
        reports_.push_back({what, {}, -1, 0, time_, time_, substep_, substep_, 0});
        report = reports_.end() - 1;
    }
    // If several nodes have the problem in one substep, the first one is reported.
    if (report->substeps > 0 && report->lastSubstep == substep_) return;
    report->message = withoutPrefix(message);
    report->node = node;
    report->value = value;
    report->last = time_;
    report->lastSubstep = substep_;
    ++report->substeps;
}

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
