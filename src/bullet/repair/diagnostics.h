// Reports of problems of a sheet, and the policy for them.
#pragma once

#include <string>
#include <vector>

#include "drench/config.h"
#include "drench/health.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Keeps one report for each kind of problem, so that their number stays small however long a problem lasts.
class Diagnostics {
  public:
    explicit Diagnostics(OnTrouble policy) : policy_(policy) {}

    // Sets the time and the substep of the following reports.
    void begin(double time, std::int64_t substep) {
        time_ = time;
        substep_ = substep;
    }

    // @param message  without "drench: "; says what the problem is, and how to prevent it
    // @throws std::runtime_error with the message, if the policy is OnTrouble::throwError; the caller must
    //     not have changed anything before
    void note(Trouble what, const std::string& message, int node = -1, double value = 0);
    // Counts another substep of a problem that has been reported. @return whether it has been, and is not to be
    //     thrown; if not, call `note`
    bool goesOn(Trouble what);
    // The same as `note` for an exception, which is rethrown if the policy is OnTrouble::throwError.
    // @pre called while the exception is being handled
    void noteThrown(Trouble what, const std::string& message);

    bool throws() const { return policy_ == OnTrouble::throwError; }
    const std::vector<TroubleReport>& reports() const { return reports_; }
    void clear() { reports_.clear(); }

  private:
    std::vector<TroubleReport>::iterator find(Trouble what);
    void write(Trouble what, const std::string& message, int node, double value);

    OnTrouble policy_;
    double time_ = 0;           // s
    std::int64_t substep_ = 0;  // number
    std::vector<TroubleReport> reports_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
