// SPDX-License-Identifier: MIT
#include "app/course/state_motion.h"

#include <utility>

namespace shadowlab::course {

std::vector<ShownState> statesInMotion(const ShownState& atRest, const film::Motion& motion) {
    scene::Scene base = *atRest.scene;
    base.camera = atRest.camera; // motions begin there
    const scene::Snapshot first = std::make_shared<const scene::Scene>(std::move(base));
    scene::Snapshot previous = first;
    std::vector<ShownState> states;
    for (int frame = 0; frame < motion.frames; ++frame) {
        const film::Moment moment = film::momentAt(motion, first, frame, previous);
        previous = moment.snapshot;
        states.push_back(atRest);
        states.back().scene = moment.snapshot;
        states.back().camera = moment.camera;
    }
    return states;
}

} // namespace shadowlab::course
