// SPDX-License-Identifier: MIT
#include "techniques/radiosity/display/patch_error.h"

#include <algorithm>

namespace shadowlab::radiosity {

namespace {

std::vector<double> errorsOf(const RoomCache& cache, const Sources& sources, const LightBalance& balance, bool ofReflectedLight) {
    const std::vector<Patch>& patches = cache.room().patches();
    std::vector<dvec3> radiosity = balance.radiosity();
    radiosity.resize(patches.size()); // the loose ones exchange nothing
    std::vector<DirectLight> lights;
    if (ofReflectedLight)
        for (std::size_t i = 0; i < patches.size(); ++i)
            radiosity[i] -= sources.emission[i] + sources.reflectance[i] * sources.fromLights[i];
    else
        for (const DirectLight* light : cache.lights())
            lights.push_back(*light);
    return errorsOfPatches(patches, patchBorders(cache.room().exchangingFaces(), patches), radiosity, sources.reflectance, lights);
}

} // namespace

double PatchError::share(const RoomCache& cache, const Sources& sources, const LightBalance& balance, bool ofReflectedLight,
                         const dvec3& eyeWorld) {
    const PatchErrorCacheKey key{balance.version(), ofReflectedLight};
    if (key != key_) errors_ = errorsOf(cache, sources, balance, ofReflectedLight);
    key_ = key;
    const dvec3 eyeCentred = eyeWorld - cache.room().world().originWorld;
    double wrong = 0, all = 0;
    for (std::size_t i = 0; i < errors_.size(); ++i) {
        const Patch& patch = cache.room().patches()[i];
        const dvec3 toEye = eyeCentred - patch.centre;
        const double distance = std::max(glm::length(toEye), sizeOf(patch.polygon));
        const double looks = patch.area * std::max(0.0, glm::dot(toEye, patch.normal)) / (distance * distance * distance);
        wrong += looks * errors_[i];
        all += looks * luminance(balance.radiosity()[i]);
    }
    return all > 0 ? wrong / all : 0;
}

} // namespace shadowlab::radiosity
