// SPDX-License-Identifier: MIT
#include "techniques/ray_tracing/probe/probe_area.h"

#include "techniques/foundation/trace/area/area_visibility.h"

namespace shadowlab::ray_tracing {

void describeArea(const Surfaces& surfaces, const trace::SurfacePoint& point, const dvec3& toViewerWorld, int light,
                  Probe& probe) {
    const trace::AreaVisibility area(surfaces.tracer(), light);
    const dvec3 normalWorld = surfaces.normalWorld(point, toViewerWorld);
    trace::AreaIrradiance found;
    area.irradiances({&point, 1}, {&normalWorld, 1}, {&found, 1});
    const std::string name = surfaces.scene().light(light).name;
    probe.facts.push_back(probeFact("share of the area of " + name + " that is seen", found.visible));
    probe.facts.push_back({"that is",
                           !surfaces.tracer().facesLight(point, light) ? "turned away"
                           : found.visible <= 0                        ? "umbra"
                           : found.visible >= 1                        ? "full light"
                                                                       : "penumbra",
                           ""});
    probe.facts.push_back(probeFact("irradiance", found.irradiance, "of pi times its radiance"));
    probe.facts.push_back(probeFact("without shadows", found.unshadowed, "of pi times its radiance"));
}

} // namespace shadowlab::ray_tracing
