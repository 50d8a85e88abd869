// SPDX-License-Identifier: MIT
#include "app/session/motion.h"

#include "app/session/orbit.h"

namespace shadowlab::session {

Moment momentAt(const Motion& motion, const scene::Snapshot& base, int frame) {
    const double share = static_cast<double>(frame) / motion.frames;
    Moment moment{base, base->camera};
    if (motion.orbitLightDegrees) moment.snapshot = withLightsTurned(base, share * *motion.orbitLightDegrees);
    if (motion.orbitCameraDegrees) moment.camera = turned(base->camera, share * *motion.orbitCameraDegrees);
    return moment;
}

} // namespace shadowlab::session
