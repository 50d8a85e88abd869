// SPDX-License-Identifier: MIT
#include "app/film/motion.h"

#include "app/film/orbit.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::film {

Moment momentAt(const Motion& motion, const scene::Snapshot& base, int frame, const scene::Snapshot& previous) {
    Moment moment{base, base->camera};
    if (motion.path) {
        CameraAndLights state = motion.path->at(frame + 1);
        moment.snapshot = scene::withLights(previous ? previous : base, std::move(state.lights));
        moment.camera = state.camera;
        return moment;
    }
    const double share = static_cast<double>(frame) / motion.frames;
    if (motion.orbitLightDegrees) moment.snapshot = withLightsTurned(base, share * *motion.orbitLightDegrees);
    if (motion.orbitCameraDegrees) moment.camera = turned(base->camera, share * *motion.orbitCameraDegrees);
    return moment;
}

} // namespace shadowlab::film
