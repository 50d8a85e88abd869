// SPDX-License-Identifier: MIT
#include "techniques/exact_judge.h"

#include <mutex>

namespace shadowlab {

std::shared_ptr<const trace::ExactVisibility> exactJudge(const scene::Snapshot& snapshot) {
    static std::mutex mutex;
    static scene::Snapshot kept; // alive, so that no other scene can lie at its address
    static std::shared_ptr<const trace::ExactVisibility> judge;
    const std::scoped_lock lock(mutex);
    if (kept != snapshot || !judge) {
        judge = std::make_shared<const trace::ExactVisibility>(snapshot);
        kept = snapshot;
    }
    return judge;
}

} // namespace shadowlab
