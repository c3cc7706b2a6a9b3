// What has gone wrong with a sheet, and the policy for it.
#pragma once

#include <string>
#include <vector>

#include "drench/config.h"
#include "drench/health.h"

namespace drench {
inline namespace DRENCH_BULLET_NAMESPACE {

// Keeps one report for each kind of trouble, so that they stay few however long it lasts.
class Diagnostics {
  public:
    explicit Diagnostics(OnTrouble policy) : policy_(policy) {}

    // Says when what follows happens.
    void begin(double time, std::int64_t substep) {
        time_ = time;
        substep_ = substep;
    }

    // @param message  without "drench: "; says what, and how to mend it
    // @throws std::runtime_error with the message, if the policy wants that; the caller has then changed nothing
    void note(Trouble what, const std::string& message, int node = -1, double value = 0);
    // The same for something that was thrown, which goes on its way if the policy wants that.
    // @pre called while it is being handled
    void noteThrown(Trouble what, const std::string& message);

    bool throws() const { return policy_ == OnTrouble::throwError; }
    const std::vector<TroubleReport>& reports() const { return reports_; }
    void clear() { reports_.clear(); }

  private:
    void write(Trouble what, const std::string& message, int node, double value);

    OnTrouble policy_;
    double time_ = 0;           // s
    std::int64_t substep_ = 0;  // number
    std::vector<TroubleReport> reports_;
};

}  // namespace DRENCH_BULLET_NAMESPACE
}  // namespace drench
