// SPDX-License-Identifier: MIT
#include "tests/speed/crowded_scene.h"

#include <sstream>

namespace shadowlab::speed {

namespace {

constexpr int kSeenCasters = 20, kAllCasters = 200;

/// Boxes, spheres and tori in turn, of 12 to 512 triangles, standing on the floor.
void writeCaster(std::ostream& out, int number, double x, double z) {
    static constexpr const char* shapes[] = {R"("shape":"box","size":[0.6,0.9,0.6],"translate":[)",
                                             R"("shape":"sphere","radius":0.45,"segments":24,"translate":[)",
                                             R"("shape":"torus","radii":[0.4,0.12],"segments":[32,8],"translate":[)"};
    static constexpr double heights[] = {0.45, 0.5, 0.2};
    out << R"(,{"name":"caster)" << number << "\"," << shapes[number % 3] << x << ',' << heights[number % 3] << ',' << z
        << "]}\n";
}

} // namespace

std::string crowdedScene(bool whole) {
    std::ostringstream out;
    out << R"({"camera":{"position":[0,5,9],"target":[0,0.3,0],"fovYDegrees":40},"ambient":[0.06,0.06,0.06],
"lights":[
{"name":"sun","type":"directional","direction":[-0.4,-1,-0.3],"intensity":0.8},
{"name":"lamp","type":"point","position":[1.5,4,2],"intensity":20})";
    if (whole)
        out << R"(,
{"name":"spot1","type":"spot","position":[-20,5,0],"direction":[0,-1,0],"coneDegrees":60,"intensity":40},
{"name":"spot2","type":"spot","position":[20,5,0],"direction":[0.2,-1,0],"coneDegrees":60,"intensity":40},
{"name":"spot3","type":"spot","position":[0,5,30],"direction":[0,-1,0.2],"coneDegrees":50,"intensity":40},
{"name":"spot4","type":"spot","position":[0,3,-10],"direction":[0,0.2,-1],"coneDegrees":40,"intensity":40},
{"name":"panel","type":"rect","position":[0,8,-40],"edgeU":[-1,0,0],"edgeV":[0,1,0],"intensity":10},
{"name":"below","type":"spot","position":[0,-2,0],"direction":[0.2,-1,0],"coneDegrees":90,"intensity":40})";
    out << R"(],
"objects":[{"name":"floor","shape":"quad","size":[80,80]})"
        << '\n';
    for (int i = 0; i < kSeenCasters; ++i)
        writeCaster(out, i + 1, 1.4 * (i % 5) - 2.8, 1.2 * static_cast<double>(i / 5) - 2.2);
    // The others in two fields to the left and the right, and behind the eye.
    if (whole)
        for (int i = kSeenCasters; i < kAllCasters; ++i) {
            const int field = i % 3, place = i / 3;
            const double along = 1.3 * (place % 8) - 4.5, across = 1.3 * static_cast<double>(place / 8);
            if (field < 2)
                writeCaster(out, i + 1, (field ? 1 : -1) * (14 + across), along - 2);
            else
                writeCaster(out, i + 1, along, 14 + across);
        }
    out << "]}\n";
    return out.str();
}

} // namespace shadowlab::speed
